package mmneat.contest;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.StarterPacMan;
import pacman.game.GameRules;

/** Games of a contest without the command line. Without a display, a shown game has no window but the same steps. */
class ContestTest {

    private static final int STEPS = 5;

    @Test
    void shownUntimedGame_isSeenStepByStep_asOneThatIsNotShown() {
        List<String> hidden = states(false);
        assertThat(hidden).hasSizeGreaterThanOrEqualTo(STEPS);
        assertThat(states(true)).isEqualTo(hidden);
    }

    /** The states after each step of a short game. */
    private static List<String> states(boolean isShown) {
        ContestSettings settings = new ContestSettings(
                new Contestant<>("StarterPacMan", "", StarterPacMan::new),
                new Contestant<>("Legacy", "", Legacy::new),
                GameRules.competition()
                        .withLevels(levels -> levels.withMaximumLevel(1).withLevelTimeLimit(STEPS)),
                1,
                3,
                Timing.NONE,
                null,
                isShown,
                OnFailure.STOP,
                false);
        List<String> states = new ArrayList<>();
        new Contest(settings, new PrintWriter(new StringWriter()))
                .play(game -> states.add(game.getGameState()), soFar -> {});
        return states;
    }
}
