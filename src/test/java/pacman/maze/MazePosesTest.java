package pacman.maze;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Poses agree with the graph. */
class MazePosesTest {

    private static final int NO_MOVE = 4;

    @Test
    void pose_keepsNodeAndMove_andLeadsToTheNeighbour() {
        for (int maze = 0; maze < 4; maze++) {
            MazeGraph graph = Mazes.standard().get(maze).graph();
            MazePoses poses = Mazes.standard().get(maze).poses();
            for (int node = 0; node < graph.nodeCount(); node++) {
                for (int move = 0; move <= NO_MOVE; move++) {
                    int pose = MazePoses.of(node, move);
                    assertThat(MazePoses.node(pose)).isEqualTo(node);
                    assertThat(MazePoses.move(pose)).isEqualTo(move);
                    assertThat(MazePoses.turned(MazePoses.of(node, 1), move)).isEqualTo(pose);
                    int next = graph.neighbour(node, move);
                    assertThat(poses.onward(pose)).isEqualTo(next < 0 ? -1 : MazePoses.of(next, move));
                    assertThat(poses.isChoice(pose))
                            .isEqualTo(graph.isJunction(node) || node == graph.ghostStart() && move == NO_MOVE);
                }
            }
        }
    }

    @Test
    void leastDistance_isAtMostThePathDistance() {
        for (int maze = 0; maze < 4; maze++) {
            MazeTables tables = Mazes.standard().get(maze);
            MazeGraph graph = tables.graph();
            for (int from = 0; from < graph.lair(); from++) {
                for (int to = 0; to < graph.lair(); to++) {
                    int least = graph.leastDistance(from, to);
                    if (least > tables.distances().between(from, to) || least < 0) {
                        throw new AssertionError("maze " + maze + ", from " + from + " to " + to + ": " + least);
                    }
                }
            }
        }
    }

    @Test
    void pillPosition_isThePillsNumber_orTheLastBit() {
        for (int maze = 0; maze < 4; maze++) {
            MazeGraph graph = Mazes.standard().get(maze).graph();
            int none = Long.SIZE * graph.pillWords() - 1;
            assertThat(none).isGreaterThanOrEqualTo(graph.pillCount());
            for (int node = 0; node < graph.nodeCount(); node++) {
                int pill = graph.pillNumber(node);
                assertThat(graph.pillPosition(node)).isEqualTo(pill < 0 ? none : pill);
            }
        }
    }
}
