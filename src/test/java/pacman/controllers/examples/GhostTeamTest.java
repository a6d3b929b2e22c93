package pacman.controllers.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import pacman.controllers.NewGhostController;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * Rules of the example teams that whole games rarely cover: docs/specification/controllers.md, sections 5.1 and 5.3.
 */
@Timeout(60)
class GhostTeamTest {

    /** Returns a game with all ghosts on one node, none edible or in the lair. */
    private static Game withGhostsAt(int node) {
        Game game = new Game(0);
        String[] fields = game.getGameState().split(",");
        int firstGhost = Arrays.asList(fields).indexOf(MOVE.LEFT.name()) + 3;
        for (int ghost = 0; ghost < 4; ghost++) {
            int at = firstGhost + 4 * ghost;
            fields[at] = Integer.toString(node);
            fields[at + 1] = "0";
            fields[at + 2] = "0";
            fields[at + 3] = MOVE.NEUTRAL.name();
        }
        game.setGameState(String.join(",", fields));
        return game;
    }

    @Test
    void crowdedGhosts_chaseWithinLessThanTenSteps_andElseGoToTheirCorners() {
        int told = 0;
        int pacMan = new Game(0).getPacmanCurrentNodeIndex();
        int blinkysCorner = new Game(0).getPowerPillIndices()[0];
        for (int node = 0; node < new Game(0).getNumberOfNodes() - 1; node++) {
            Game game = withGhostsAt(node);
            int distance = game.getShortestPathDistance(pacMan, node);
            MOVE chase = game.getApproximateNextMoveTowardsTarget(node, pacMan, MOVE.NEUTRAL, DM.PATH);
            MOVE corner = game.getApproximateNextMoveTowardsTarget(node, blinkysCorner, MOVE.NEUTRAL, DM.PATH);
            if ((distance == 9 || distance == 10) && chase != corner) {
                told |= 1 << distance;
                assertThat(new Legacy2TheReckoning().choose(game, GHOST.BLINKY, new ResumableRandom(0)))
                        .as("%d steps away", distance)
                        .isEqualTo(distance < 10 ? chase : corner);
            }
        }
        assertThat(told).as("both distances were seen").isEqualTo(1 << 9 | 1 << 10);
    }

    /** Quirk of the original: only StarterGhosts stay terminated. */
    @Test
    void reset_revivesTheTeams_butForStarterGhosts() throws InterruptedException {
        for (NewGhostController team : List.of(new StarterGhosts(), new Legacy(), new Legacy2TheReckoning())) {
            team.terminate();
            team.reset();
            Thread supervisor = new Thread(team);
            supervisor.setDaemon(true);
            supervisor.start();
            if (team instanceof StarterGhosts) {
                supervisor.join();
            } else {
                while (supervisor.getState() != Thread.State.WAITING) {
                    assertThat(supervisor.getState()).isNotEqualTo(Thread.State.TERMINATED);
                    Thread.onSpinWait();
                }
                team.terminate();
                supervisor.join();
            }
        }
    }
}
