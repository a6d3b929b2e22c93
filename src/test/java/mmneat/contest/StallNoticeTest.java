package mmneat.contest;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import pacman.Executor;
import pacman.controllers.Controller;
import pacman.controllers.examples.Legacy;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

class StallNoticeTest {

    private static final long MILLISECONDS = 20;

    /** The printed notices; the first line releases the waiting test. */
    private static final class Notes extends PrintWriter {
        private final CountDownLatch written = new CountDownLatch(1);

        Notes() {
            super(new StringWriter());
        }

        @Override
        public void flush() {
            super.flush();
            written.countDown();
        }

        String text() {
            return out.toString();
        }
    }

    /** A controller that does not answer at time 5 until the stall is reported. */
    private static final class Thinker extends Controller<MOVE> {
        private static final int LONG_THOUGHT = 5;
        private final CountDownLatch noticed;

        Thinker(CountDownLatch noticed) {
            this.noticed = noticed;
        }

        @Override
        public MOVE getMove(Game game, long timeDue) {
            if (game.getTotalTime() == LONG_THOUGHT) {
                try {
                    noticed.await();
                } catch (InterruptedException e) {
                    throw new AssertionError(e);
                }
            }
            return MOVE.LEFT;
        }
    }

    @Test
    @Timeout(60)
    void controllerThatDoesNotAnswer_isNamedWithTheTimeOfTheGame() {
        Notes notes = new Notes();
        Game game = new Game(1);
        try (StallNotice stall = new StallNotice(notes, MILLISECONDS)) {
            stall.watch(game);
            new Executor().runExperiment(new Thinker(notes.written), new Legacy(), game);
        }
        assertThat(game.gameOver()).isTrue();
        assertThat(notes.text().lines()).anySatisfy(line -> assertThat(line)
                .contains("at time 5 of the game")
                .contains(Thinker.class.getName())
                .contains("timed=true"));
    }

    @Test
    void nothingIsSaid_whenNoGameIsPlayed() throws InterruptedException {
        Notes notes = new Notes();
        try (StallNotice stall = new StallNotice(notes, MILLISECONDS)) {
            stall.watch(new Game(1));
            stall.watch(null);
            Thread.sleep(10 * MILLISECONDS);
        }
        assertThat(notes.text()).isEmpty();
    }
}
