package mmneat.mspacman;

import mmneat.mspacman.modules.AnyGhostEdible;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.modules.ThreatEdibleOrBoth;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.mspacman.sensors.suite.SensorSuite;
import mmneat.neat.Genotype;
import mmneat.neat.network.ModuleArbitration;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.controllers.Controller;
import pacman.controllers.ReadOnlyController;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * A controller of the competition's interface that plays with an evolved network, under any rules and also in timed
 * games.
 *
 * <p>It decides as in evolution. A separate generator breaks ties between modules and between directions, so that the
 * game's generator is not affected.
 */
public final class NetworkPacMan extends Controller<MOVE> implements ReadOnlyController<MOVE> {

    private static final MOVE[] MOVES = MOVE.values();

    private final DirectionEvaluator player;
    private final ResumableRandom ties;

    /**
     * Creates a player with a network.
     *
     * @param sensors the sensors, one per input of the network
     * @param arbitration how the network chooses among its modules
     * @param division selects the module of each step for a multitask network; null for others
     * @param tieSeed seed of the numbers that break ties
     * @throws IllegalArgumentException if the network does not fit the sensors or the division
     */
    public NetworkPacMan(
            Genotype network,
            SensorSettings sensors,
            ModuleArbitration arbitration,
            @Nullable ModuleDivision division,
            long tieSeed) {
        player = new DirectionEvaluator(SensorSuite.of(sensors).newInputs(), network, arbitration, division);
        ties = new ResumableRandom(tieSeed);
    }

    /**
     * Creates a player of full games with the sensors and the module choice of a task. In the isolated version the
     * division of the task tells the pill game from the ghost games, which a full game does not have. A network of that
     * version gets the division that {@link #published} would choose.
     *
     * @param division selects the module of each step for a multitask network; if null, the division of the task
     * @throws IllegalArgumentException if the network does not fit the task or the division
     */
    public static NetworkPacMan of(
            MsPacManTaskSettings task, Genotype network, @Nullable ModuleDivision division, long tieSeed) {
        NetworkSettings settings = task.networks();
        ModuleDivision ofTask =
                task.games().version() == TaskVersion.ISOLATED ? publishedDivision(network) : settings.division();
        return new NetworkPacMan(
                network, settings.sensors(), settings.arbitration(), division == null ? ofTask : division, tieSeed);
    }

    /**
     * Creates a player with a network of the published experiments. Its number of inputs determines its sensors.
     *
     * @param division selects the module of each step for a multitask network; if null, the published division of full
     *     games with this number of modules
     * @throws IllegalArgumentException if the network has neither 26, 30 nor 38 inputs
     */
    public static NetworkPacMan published(Genotype network, @Nullable ModuleDivision division, long tieSeed) {
        return new NetworkPacMan(
                network,
                publishedSensors(network.inputs()),
                ModuleArbitration.PREFERENCE,
                division == null ? publishedDivision(network) : division,
                tieSeed);
    }

    private static SensorSettings publishedSensors(int inputs) {
        for (SensorSettings settings :
                new SensorSettings[] {SensorSettings.blended(), SensorSettings.imprisoned(), SensorSettings.split()}) {
            if (SensorSuite.of(settings).size() == inputs) {
                return settings;
            }
        }
        throw new IllegalArgumentException(
                "the network has " + inputs
                        + " inputs; networks of the published experiments have 30 (blended), 26 (interleaved, isolated) or 38 (split sensors)");
    }

    private static @Nullable ModuleDivision publishedDivision(Genotype network) {
        if (!network.layout().isDivided()) {
            return null;
        }
        return network.layout().choicesOfTask() == new ThreatEdibleOrBoth().modules()
                ? new ThreatEdibleOrBoth()
                : new AnyGhostEdible();
    }

    @Override
    public @Nullable MOVE getMove(Game game, long timeDue) {
        return decide(game, game.rnd);
    }

    /** {@inheritDoc} The passed generator is not used, because it belongs to the game. */
    @Override
    public @Nullable MOVE decide(Game game, ResumableRandom ofTheGame) {
        int direction = player.decide(game, ties);
        // Null requests the end of the game, as in the original.
        return direction == DirectionEvaluator.END_GAME ? null : MOVES[direction];
    }
}
