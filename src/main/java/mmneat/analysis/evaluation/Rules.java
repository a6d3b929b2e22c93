package mmneat.analysis.evaluation;

import java.util.Arrays;
import java.util.List;
import mmneat.experiment.UserError;
import pacman.game.Constants;
import pacman.game.GameRules;

/**
 * The rules under which champions are evaluated: those of the evolution ({@link #TRAINING}), or one of two sets of
 * rules with more lives ({@link #FOUR_MAZE}, {@link #MPM_VS_GHOSTS}). The other settings of the version of the task
 * stay as they are.
 *
 * <p>Source: docs/specification/evolution.md, section 6.1.
 */
public enum Rules {
    /** Label {@code training}. As in evolution: one life. */
    TRAINING("training"),
    /**
     * Label {@code FourMaze}. Three lives and an extra one, through the four mazes. The time limit, 50,000 steps per
     * level, is too high to matter.
     */
    FOUR_MAZE("FourMaze"),
    /**
     * Label {@code MPMvsG}. The Ms.&nbsp;Pac-Man versus Ghosts competition of 2011: three lives and an extra one, 16
     * levels of 3000 steps; at the end of a level the player gets half the points of the remaining pills.
     */
    MPM_VS_GHOSTS("MPMvsG");

    private static final int NO_LIMIT_OF_CONSEQUENCE = 50_000;

    private final String label;

    Rules(String label) {
        this.label = label;
    }

    /** The label, as written by users. */
    public String label() {
        return label;
    }

    /** All labels. */
    public static List<String> labels() {
        return Arrays.stream(values()).map(Rules::label).toList();
    }

    /** The rules with this label. */
    public static Rules of(String label) {
        return Arrays.stream(values())
                .filter(rules -> rules.label.equalsIgnoreCase(label))
                .findFirst()
                .orElseThrow(() -> new UserError("rules=" + label + ": must be one of " + String.join(", ", labels())));
    }

    /** The training rules with the changes that these rules make; settings of the version of the task are kept. */
    GameRules from(GameRules training) {
        return switch (this) {
            case TRAINING -> training;
            case FOUR_MAZE ->
                training.withLevels(levels -> levels.withLives(Constants.NUM_LIVES)
                        .withExtraLife(true)
                        .withLevelTimeLimit(NO_LIMIT_OF_CONSEQUENCE));
            case MPM_VS_GHOSTS ->
                training.withLevels(unused -> GameRules.mpmVsGhosts().levels());
        };
    }
}
