package pacman.controllers;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.function.IntSupplier;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import pacman.Executor;
import pacman.controllers.examples.Legacy;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GameRules;

/** Actions are converted to moves: docs/specification/controllers.md, section 3.1. */
class NewPacManControllerTest {

    private static final class Acting extends NewPacManController {
        private final IntSupplier action;
        private int asked;

        Acting(IntSupplier action) {
            this.action = action;
        }

        @Override
        public int getAction(Game game, long timeDue) {
            asked++;
            return action.getAsInt();
        }

        @Override
        public void logEvaluationDetails() {}
    }

    private static MOVE moveOf(int action) {
        return new Acting(() -> action).getMove(new Game(0), -1);
    }

    @Test
    void actions_areDirectionNumbers() {
        assertThat(moveOf(0)).isEqualTo(MOVE.UP);
        assertThat(moveOf(1)).isEqualTo(MOVE.RIGHT);
        assertThat(moveOf(2)).isEqualTo(MOVE.DOWN);
        assertThat(moveOf(3)).isEqualTo(MOVE.LEFT);
        assertThat(moveOf(4)).isEqualTo(MOVE.NEUTRAL);
        assertThat(moveOf(-1)).isEqualTo(MOVE.NEUTRAL);
        assertThat(moveOf(NewPacManController.END_GAME_CODE)).isNull();
    }

    @Test
    void controllerThatAlwaysThrows_isAskedTwelveTimes_andEndsTheGame() {
        Acting throwing = new Acting(() -> {
            throw new IllegalStateException("no idea");
        });
        Game game = new Game(0, GameRules.mmneat(), new ResumableRandom(0));
        new Executor().runExperiment(throwing, new Legacy(), game);
        assertThat(throwing.asked).isEqualTo(12);
        assertThat(game.getTotalTime()).isEqualTo(11);
    }
}
