package mmneat.mspacman;

import java.util.List;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import pacman.controllers.NewGhostController;
import pacman.game.GameRules;

/**
 * The games of an evaluation. Immutable.
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 2 and 7.
 *
 * @param version which games make a trial
 * @param trials trials per evaluation, at least 1
 * @param rules rules of a full game, with pills, power pills and ghosts. {@link TrialGame#of} derives the separate
 *     games of the isolated version from them
 * @param ghosts creates the ghost team, one per task
 * @param deterministic whether a game's seed is its trial number instead of a random number
 */
public record GameSettings(
        TaskVersion version, int trials, GameRules rules, Supplier<NewGhostController> ghosts, boolean deterministic) {

    /**
     * @throws IllegalArgumentException if there is no trial, or the isolated version has no ghost locations
     */
    public GameSettings {
        if (trials < 1) {
            throw new IllegalArgumentException("trials must be at least 1, is " + trials);
        }
        if (version == TaskVersion.ISOLATED && rules.ghosts().ghostLocations() == null) {
            throw new IllegalArgumentException(
                    "the isolated version needs recorded ghost locations (mazePowerPillGhostMapping)");
        }
    }

    /** The games of a trial, in the order in which they are played. */
    public List<TrialGame> ofTrial() {
        return TrialGame.of(version, rules);
    }

    /** Returns these settings with another number of trials. */
    public GameSettings withTrials(int number) {
        return new GameSettings(version, number, rules, ghosts, deterministic);
    }

    /** Returns these settings with other rules of a full game. */
    public GameSettings withRules(UnaryOperator<GameRules> change) {
        return new GameSettings(version, trials, change.apply(rules), ghosts, deterministic);
    }

    /** Returns these settings with seeds that are trial numbers, or with random seeds. */
    public GameSettings withDeterministic(boolean value) {
        return new GameSettings(version, trials, rules, ghosts, value);
    }
}
