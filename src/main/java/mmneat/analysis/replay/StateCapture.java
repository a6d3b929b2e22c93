package mmneat.analysis.replay;

import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.maze.MazeGraph;

/** Copies the visible state of a game into a {@link ReplayStep}: positions, pills, times, score and lives. */
final class StateCapture {

    private static final GHOST[] GHOSTS = GHOST.values();

    private final ReplayRecorder recorder;
    private final ReplayStep step;

    @SuppressWarnings("NullAway.Init")
    private MazeGraph maze;

    /**
     * A capture for one recording.
     *
     * @param recorder receives the mazes
     * @param step receives the states
     */
    StateCapture(ReplayRecorder recorder, ReplayStep step) {
        this.recorder = recorder;
        this.step = step;
    }

    /** The maze of the last state that was captured. */
    MazeGraph maze() {
        return maze;
    }

    /** Copies the state into the step, and adds its maze to the recorder if it is new. */
    void capture(Game game) {
        int index = game.getMazeIndex();
        maze = game.mazeTables().graph();
        if (!recorder.knowsMaze(index)) {
            recorder.addMaze(picture(index, maze));
        }
        if (step.maze != index || step.pills.length != game.getNumberOfPills()) {
            step.pills = new boolean[game.getNumberOfPills()];
            step.powerPills = new boolean[game.getNumberOfPowerPills()];
        }
        step.maze = index;
        step.level = game.getCurrentLevel();
        step.levelTime = game.getCurrentLevelTime();
        step.score = game.getScore();
        step.lives = game.getPacmanNumberOfLivesRemaining();
        step.pacMan = game.getPacmanCurrentNodeIndex();
        step.pacManMove = game.getPacmanLastMoveMade().ordinal();
        for (int i = 0; i < step.pills.length; i++) {
            step.pills[i] = game.isPillStillAvailable(i);
        }
        for (int i = 0; i < step.powerPills.length; i++) {
            step.powerPills[i] = game.isPowerPillStillAvailable(i);
        }
        for (int g = 0; g < GHOSTS.length; g++) {
            step.ghosts[g] = game.getGhostCurrentNodeIndex(GHOSTS[g]);
            step.ghostMoves[g] = game.getGhostLastMoveMade(GHOSTS[g]).ordinal();
            step.edibleTimes[g] = game.getGhostEdibleTime(GHOSTS[g]);
            step.lairTimes[g] = game.getGhostLairTime(GHOSTS[g]);
        }
    }

    private static ReplayMaze picture(int index, MazeGraph maze) {
        int count = maze.nodeCount();
        int[] x = new int[count];
        int[] y = new int[count];
        int[] right = new int[count];
        int[] down = new int[count];
        for (int node = 0; node < count; node++) {
            x[node] = maze.x(node);
            y[node] = maze.y(node);
            right[node] = maze.neighbour(node, MOVE.RIGHT.ordinal());
            down[node] = maze.neighbour(node, MOVE.DOWN.ordinal());
        }
        return new ReplayMaze(index, x, y, right, down, maze.pillNodes(), maze.powerPillNodes(), maze.lair());
    }
}
