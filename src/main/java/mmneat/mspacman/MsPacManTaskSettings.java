package mmneat.mspacman;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import mmneat.mspacman.objectives.GameObjective;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.neat.network.ModuleArbitration;
import pacman.controllers.examples.Legacy;
import pacman.game.GameRules;
import pacman.game.GhostLocations;

/**
 * The settings of an evaluation in the Ms.&nbsp;Pac-Man task. Start from a preset such as {@link #blended}. Immutable.
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 1, 2 and 7.
 *
 * @param games the games that are played
 * @param networks the inputs of networks and the choice among their modules
 * @param objectives what networks are selected for, at least one, with different names
 */
public record MsPacManTaskSettings(GameSettings games, NetworkSettings networks, List<GameObjective> objectives) {

    private static final int PUBLISHED_TRIALS = 10;

    /**
     * Checked settings.
     *
     * @throws IllegalArgumentException if there is no objective, or two objectives have one name
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
                new GameSettings(version, PUBLISHED_TRIALS, rules, Legacy::new, false),
                new NetworkSettings(sensors, null, ModuleArbitration.PREFERENCE),
                GameObjective.PUBLISHED);
    }

    /** Returns these settings with other games. */
    public MsPacManTaskSettings withGames(UnaryOperator<GameSettings> change) {
        return new MsPacManTaskSettings(change.apply(games), networks, objectives);
    }

    /** Returns these settings for other networks. */
    public MsPacManTaskSettings withNetworks(UnaryOperator<NetworkSettings> change) {
        return new MsPacManTaskSettings(games, change.apply(networks), objectives);
    }

    /** Returns these settings with other objectives. */
    public MsPacManTaskSettings withObjectives(List<GameObjective> value) {
        return new MsPacManTaskSettings(games, networks, value);
    }

    /** Returns these settings with another number of trials. */
    public MsPacManTaskSettings withTrials(int number) {
        return withGames(changed -> changed.withTrials(number));
    }

    /**
     * Returns these settings with one trial per evaluation, whose seed comes from the generator that {@link
     * MsPacManTask#evaluate} receives. Champions are evaluated and shown in this way: the seed of each game determines
     * the game, also if the evolution was deterministic.
     */
    public MsPacManTaskSettings forSingleGames() {
        return withGames(changed -> changed.withTrials(1).withDeterministic(false));
    }
}
