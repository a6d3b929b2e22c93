package mmneat.mspacman.sensors;

import java.util.ArrayList;
import java.util.List;
import mmneat.random.ResumableRandom;
import pacman.maze.MazeGraph;
import pacman.maze.MazeTables;

/** Positions, timers and pills drawn at random: legal for sensors, not necessarily reachable in a game. */
public final class RandomState {

    public final int pacMan;
    final int[] ghostNode = new int[4];
    final int[] edible = new int[4];
    final int[] lair = new int[4];
    final int[] lastMove = new int[4];
    final long[] pills;
    final long powerPills;
    private List<Integer> activePillNodes;

    public RandomState(MazeGraph graph, ResumableRandom random) {
        pacMan = random.nextInt(graph.lair());
        boolean crowded = random.nextInt(3) == 0;
        for (int ghost = 0; ghost < 4; ghost++) {
            placeGhost(ghost, graph, crowded, random);
        }
        pills = new long[graph.pillWords()];
        scatterPills(graph, random);
        powerPills = random.nextInt(3) == 0 ? 0 : random.nextLong() & (1L << graph.powerPillCount()) - 1;
    }

    private RandomState(RandomState before, int pacMan) {
        this.pacMan = pacMan;
        System.arraycopy(before.ghostNode, 0, ghostNode, 0, 4);
        System.arraycopy(before.edible, 0, edible, 0, 4);
        System.arraycopy(before.lair, 0, lair, 0, 4);
        System.arraycopy(before.lastMove, 0, lastMove, 0, 4);
        pills = before.pills.clone();
        powerPills = before.powerPills;
    }

    /**
     * A state one step later: Ms. Pac-Man moves in a direction and mostly eats what is on her new node, ghosts outside
     * the lair move without turning back.
     */
    public RandomState afterStep(MazeGraph graph, int direction, ResumableRandom random) {
        RandomState next = new RandomState(this, graph.neighbour(pacMan, direction));
        for (int ghost = 0; ghost < 4; ghost++) {
            next.edible[ghost] = Math.max(0, edible[ghost] - 1);
            if (lair[ghost] == 0 && (edible[ghost] & 1) == 0) {
                next.moveGhost(ghost, graph, random);
            }
        }
        int pill = graph.pillNumber(next.pacMan);
        if (pill >= 0 && random.nextInt(10) > 0) {
            next.pills[pill >> 6] &= ~(1L << pill);
        }
        return next;
    }

    private void moveGhost(int ghost, MazeGraph graph, ResumableRandom random) {
        int move = random.nextInt(4);
        while (graph.neighbour(ghostNode[ghost], move) < 0 || move == (lastMove[ghost] ^ 2)) {
            move = random.nextInt(4);
        }
        ghostNode[ghost] = graph.neighbour(ghostNode[ghost], move);
        lastMove[ghost] = move;
    }

    private void placeGhost(int ghost, MazeGraph graph, boolean crowded, ResumableRandom random) {
        if (random.nextInt(8) == 0) {
            ghostNode[ghost] = graph.lair();
            lair[ghost] = 1 + random.nextInt(40);
            lastMove[ghost] = 4;
            return;
        }
        ghostNode[ghost] = crowded ? nearPacMan(graph, random) : random.nextInt(graph.lair());
        edible[ghost] = random.nextInt(2) == 0 ? 0 : 1 + random.nextInt(random.nextBoolean() ? 30 : 200);
        lastMove[ghost] = 4;
        while (random.nextInt(10) > 0) {
            int back = random.nextInt(4);
            if (graph.neighbour(ghostNode[ghost], back) >= 0) {
                lastMove[ghost] = back ^ 2;
                return;
            }
        }
    }

    private int nearPacMan(MazeGraph graph, ResumableRandom random) {
        int node = pacMan;
        for (int step = random.nextInt(25); step > 0; step--) {
            int next = graph.neighbour(node, random.nextInt(4));
            node = next >= 0 ? next : node;
        }
        return node;
    }

    private void scatterPills(MazeGraph graph, ResumableRandom random) {
        int kind = random.nextInt(5);
        for (int pill = 0; pill < graph.pillCount(); pill++) {
            boolean isActive =
                    switch (kind) {
                        case 0 -> true;
                        case 1 -> random.nextBoolean();
                        case 2 -> random.nextInt(40) == 0;
                        // A few in a row, as when a level is nearly finished.
                        case 3 ->
                            Math.abs(graph.x(graph.pillNode(pill)) - graph.x(pacMan))
                                            + Math.abs(graph.y(graph.pillNode(pill)) - graph.y(pacMan))
                                    < 14;
                        default -> false;
                    };
            if (isActive) {
                pills[pill >> 6] |= 1L << pill;
            }
        }
    }

    boolean isPillActive(int pill) {
        return pill >= 0 && (pills[pill >> 6] >>> pill & 1) != 0;
    }

    List<Integer> activePillNodes(MazeGraph graph) {
        if (activePillNodes == null) {
            activePillNodes = new ArrayList<>();
            for (int pill = 0; pill < graph.pillCount(); pill++) {
                if (isPillActive(pill)) {
                    activePillNodes.add(graph.pillNode(pill));
                }
            }
        }
        return activePillNodes;
    }

    List<Integer> activePowerPillNodes(MazeGraph graph) {
        List<Integer> nodes = new ArrayList<>();
        for (int pill = 0; pill < graph.powerPillCount(); pill++) {
            if ((powerPills >>> pill & 1) != 0) {
                nodes.add(graph.powerPillNode(pill));
            }
        }
        return nodes;
    }

    /** Shows the state to sensors. */
    public void show(Observation observation, MazeTables maze) {
        observation.enter(maze, 0);
        observation.placePacMan(pacMan);
        for (int word = 0; word < pills.length; word++) {
            observation.setPills(word, pills[word]);
        }
        observation.setPowerPills(powerPills);
        for (int ghost = 0; ghost < 4; ghost++) {
            observation.placeGhost(ghost, ghostNode[ghost], edible[ghost], lair[ghost], lastMove[ghost]);
        }
        observation.conclude();
    }

    @Override
    public String toString() {
        StringBuilder text = new StringBuilder("Ms. Pac-Man at " + pacMan + ", ghosts (node, edible, lair, last move)");
        for (int ghost = 0; ghost < 4; ghost++) {
            text.append(
                    " (" + ghostNode[ghost] + ", " + edible[ghost] + ", " + lair[ghost] + ", " + lastMove[ghost] + ")");
        }
        return text + ", power pills " + Long.toBinaryString(powerPills);
    }
}
