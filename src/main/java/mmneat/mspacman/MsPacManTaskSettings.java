package mmneat.mspacman;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.objectives.GameObjective;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.neat.network.ModuleArbitration;
import org.jspecify.annotations.Nullable;
import pacman.controllers.NewGhostController;
import pacman.controllers.examples.Legacy;
import pacman.game.GameRules;
import pacman.game.GhostLocations;

/**
 * The settings of an evaluation in the Ms.&nbsp;Pac-Man task. Immutable.
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 1, 2 and 7.
 *
 * @param version which games make a trial
 * @param trials trials per evaluation, at least 1
 * @param rules rules of a full game, with pills, power pills and ghosts. {@link TrialGame#of} derives the separate
 *     games of the isolated version from them
 * @param sensors the sensors, which are the networks' inputs
 * @param division selects the module of each step for multitask networks; null for others
 * @param arbitration how networks choose among their modules
 * @param ghosts creates the ghost team, one per task
 * @param deterministic whether a game's seed is its trial number instead of a random number
 * @param objectives what networks are selected for, at least one, with different names
 */
public record MsPacManTaskSettings(
        TaskVersion version,
        int trials,
        GameRules rules,
        SensorSettings sensors,
        @Nullable ModuleDivision division,
        ModuleArbitration arbitration,
        Supplier<NewGhostController> ghosts,
        boolean deterministic,
        List<GameObjective> objectives) {

    private static final int PUBLISHED_TRIALS = 10;

    /**
     * Checked settings.
     *
     * @throws IllegalArgumentException if there is no trial or no objective, two objectives have one name, or the
     *     isolated version has no ghost locations
     */
    public MsPacManTaskSettings {
        objectives = List.copyOf(objectives);
        if (objectives.isEmpty()) {
            throw new IllegalArgumentException("there must be at least one objective");
        }
        Set<String> names = new HashSet<>();
        for (GameObjective objective : objectives) {
            if (!names.add(objective.name())) {
                throw new IllegalArgumentException("two objectives are called " + objective.name());
            }
        }
        if (trials < 1) {
            throw new IllegalArgumentException("trials must be at least 1, is " + trials);
        }
        if (version == TaskVersion.ISOLATED && rules.ghosts().ghostLocations() == null) {
            throw new IllegalArgumentException(
                    "the isolated version needs recorded ghost locations (mazePowerPillGhostMapping)");
        }
    }

    /** Settings with the two published objectives. */
    public MsPacManTaskSettings(
            TaskVersion version,
            int trials,
            GameRules rules,
            SensorSettings sensors,
            @Nullable ModuleDivision division,
            ModuleArbitration arbitration,
            Supplier<NewGhostController> ghosts,
            boolean deterministic) {
        this(version, trials, rules, sensors, division, arbitration, ghosts, deterministic, GameObjective.PUBLISHED);
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
        GameRules rules = GameRules.isolatedPills().withGhosts(ghosts -> ghosts.withGhostLocations(locations));
        return published(TaskVersion.ISOLATED, rules, SensorSettings.imprisoned());
    }

    private static MsPacManTaskSettings published(TaskVersion version, GameRules rules, SensorSettings sensors) {
        return new MsPacManTaskSettings(
                version, PUBLISHED_TRIALS, rules, sensors, null, ModuleArbitration.PREFERENCE, Legacy::new, false);
    }

    /** Returns these settings with another number of trials. */
    public MsPacManTaskSettings withTrials(int number) {
        return new MsPacManTaskSettings(
                version, number, rules, sensors, division, arbitration, ghosts, deterministic, objectives);
    }

    /**
     * Returns these settings with one trial per evaluation, whose seed comes from the generator that {@link
     * MsPacManTask#evaluate} receives. Champions are evaluated and shown in this way: the seed of each game determines
     * the game, also if the evolution was deterministic.
     */
    public MsPacManTaskSettings forSingleGames() {
        return new MsPacManTaskSettings(version, 1, rules, sensors, division, arbitration, ghosts, false, objectives);
    }

    /** Returns these settings with other rules of a full game. */
    public MsPacManTaskSettings withRules(GameRules ofFullGame) {
        return new MsPacManTaskSettings(
                version, trials, ofFullGame, sensors, division, arbitration, ghosts, deterministic, objectives);
    }

    /** Returns these settings for multitask networks. */
    public MsPacManTaskSettings withDivision(ModuleDivision ofTask) {
        return new MsPacManTaskSettings(
                version, trials, rules, sensors, ofTask, arbitration, ghosts, deterministic, objectives);
    }
}
