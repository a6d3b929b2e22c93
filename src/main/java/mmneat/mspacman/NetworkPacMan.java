package mmneat.mspacman;

import mmneat.mspacman.modules.AnyGhostEdible;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.modules.ThreatEdibleOrBoth;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.mspacman.sensors.SensorSuite;
import mmneat.neat.Genotype;
import mmneat.neat.network.ModuleArbitration;
import mmneat.random.ResumableRandom;
import pacman.controllers.Controller;
import pacman.controllers.ReadOnlyController;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * An evolved network as a controller of the competition's interface: plays under any rules, timed too.
 *
 * <p>It decides as in evolution. Ties between modules and between directions are broken by a generator of its own, so that
 * playing does not disturb the game's.
 */
public final class NetworkPacMan extends Controller<MOVE> implements ReadOnlyController<MOVE> {

    private static final MOVE[] MOVES = MOVE.values();

    private final DirectionEvaluator player;
    private final ResumableRandom ties;

    /**
     * A player with a network.
     *
     * @param sensors what it senses: as many as the network has inputs
     * @param arbitration how it chooses among its modules
     * @param division names the module of each step for a multitask network; null for others
     * @param tieSeed seed of the numbers that break ties
     * @throws IllegalArgumentException if the network does not suit the sensors or the division
     */
    public NetworkPacMan(
            Genotype network,
            SensorSettings sensors,
            ModuleArbitration arbitration,
            ModuleDivision division,
            long tieSeed) {
        player = new DirectionEvaluator(SensorSuite.of(sensors).newInputs(), network, arbitration, division);
        ties = new ResumableRandom(tieSeed);
    }

    /**
     * A player with a network as it senses and chooses in a task. In the isolated version divisions tell one kind of game from
     * another; full games are then divided as {@link #published} says.
     *
     * @param division names the module of each step for a multitask network; if null, that of the task
     * @throws IllegalArgumentException if the network does not suit the task or the division
     */
    public static NetworkPacMan of(MsPacManTaskSettings task, Genotype network, ModuleDivision division, long tieSeed) {
        ModuleDivision ofTask = task.version() == TaskVersion.ISOLATED ? publishedDivision(network) : task.division();
        return new NetworkPacMan(
                network, task.sensors(), task.arbitration(), division == null ? ofTask : division, tieSeed);
    }

    /**
     * A player with a network of the published experiments: its number of inputs tells which sensors it has.
     *
     * @param division names the module of each step for a multitask network; if null, the published division of full games
     *     with as many modules
     * @throws IllegalArgumentException if the network has neither 26, 30 nor 38 inputs
     */
    public static NetworkPacMan published(Genotype network, ModuleDivision division, long tieSeed) {
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

    private static ModuleDivision publishedDivision(Genotype network) {
        if (!network.layout().standardMultitask()) {
            return null;
        }
        return network.modules() == new ThreatEdibleOrBoth().modules()
                ? new ThreatEdibleOrBoth()
                : new AnyGhostEdible();
    }

    @Override
    public MOVE getMove(Game game, long timeDue) {
        return decide(game, game.rnd);
    }

    /** {@inheritDoc} The generator that is passed is not used: it belongs to the game. */
    @Override
    public MOVE decide(Game game, ResumableRandom ofTheGame) {
        int direction = player.decide(game, ties);
        // Null asks for the end of the game, as in the original.
        return direction == DirectionEvaluator.END_GAME ? null : MOVES[direction];
    }
}
