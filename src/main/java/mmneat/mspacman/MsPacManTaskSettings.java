package mmneat.mspacman;

import java.util.function.Supplier;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.neat.network.ModuleArbitration;
import pacman.controllers.NewGhostController;
import pacman.controllers.examples.Legacy;
import pacman.game.GameRules;
import pacman.game.GameSwitch;
import pacman.game.GhostLocations;

/**
 * The settings of an evaluation in the Ms.&nbsp;Pac-Man task. Immutable.
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 1, 2 and 7.
 *
 * @param version which games make a trial
 * @param trials trials per evaluation, at least 1
 * @param rules rules of a full game; the games of the isolated version are derived from them
 * @param sensors the sensors, which are the networks' inputs
 * @param division selects the module of each step for multitask networks; null for others
 * @param arbitration how networks choose among their modules
 * @param ghosts creates the ghost team, one per task
 * @param deterministic whether a game's seed is its trial number instead of a random number
 */
public record MsPacManTaskSettings(
        TaskVersion version,
        int trials,
        GameRules rules,
        SensorSettings sensors,
        ModuleDivision division,
        ModuleArbitration arbitration,
        Supplier<NewGhostController> ghosts,
        boolean deterministic) {

    private static final int PUBLISHED_TRIALS = 10;

    public MsPacManTaskSettings {
        if (trials < 1) {
            throw new IllegalArgumentException("trials must be at least 1, is " + trials);
        }
        if (version == TaskVersion.ISOLATED && rules.ghosts().ghostLocations() == null) {
            throw new IllegalArgumentException(
                    "the isolated version needs recorded ghost locations (mazePowerPillGhostMapping)");
        }
    }

    /** The published blended version, for networks with preference neurons. */
    public static MsPacManTaskSettings blended() {
        return published(TaskVersion.BLENDED, GameRules.blended(), SensorSettings.blended());
    }

    /** The published interleaved version, for networks with preference neurons. */
    public static MsPacManTaskSettings interleaved() {
        return published(TaskVersion.INTERLEAVED, GameRules.interleaved(), SensorSettings.imprisoned());
    }

    /** The published isolated version, for networks with preference neurons. */
    public static MsPacManTaskSettings isolated(GhostLocations locations) {
        GameRules rules = GameRules.interleaved()
                .withSwitches(GameSwitch.PILL_TASK)
                .withGhosts(ghosts -> ghosts.withGhostLocations(locations));
        return published(TaskVersion.ISOLATED, rules, SensorSettings.imprisoned());
    }

    private static MsPacManTaskSettings published(TaskVersion version, GameRules rules, SensorSettings sensors) {
        return new MsPacManTaskSettings(
                version, PUBLISHED_TRIALS, rules, sensors, null, ModuleArbitration.PREFERENCE, Legacy::new, false);
    }

    /** Returns these settings with another number of trials. */
    public MsPacManTaskSettings withTrials(int number) {
        return new MsPacManTaskSettings(version, number, rules, sensors, division, arbitration, ghosts, deterministic);
    }

    /** Returns these settings for single games, each of which depends only on its generator. */
    public MsPacManTaskSettings forSingleGames() {
        return new MsPacManTaskSettings(version, 1, rules, sensors, division, arbitration, ghosts, false);
    }

    /** Returns these settings with other rules of a full game. */
    public MsPacManTaskSettings withRules(GameRules ofFullGame) {
        return new MsPacManTaskSettings(
                version, trials, ofFullGame, sensors, division, arbitration, ghosts, deterministic);
    }

    /** Returns these settings for multitask networks. */
    public MsPacManTaskSettings withDivision(ModuleDivision ofTask) {
        return new MsPacManTaskSettings(version, trials, rules, sensors, ofTask, arbitration, ghosts, deterministic);
    }
}
