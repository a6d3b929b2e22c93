package mmneat.analysis.replay;

import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.sensors.suite.NetworkInputs;
import mmneat.mspacman.sensors.suite.SensorSuite;
import mmneat.neat.Genotype;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkState;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Game;

/**
 * Evaluates the player's network a second time with all its nodes, to obtain every activation for the page. The
 * player's own network omits nodes without effect and activations that are not read.
 *
 * <p>The evaluation draws from a generator of its own. So it may choose differently between two modules with exactly
 * equal preferences; the recorded choice is therefore taken from the player.
 *
 * <p>There are four copies of the network, one per direction. Each is flushed (its activations are set to zero) when
 * its direction is closed, and all are flushed at the start of a level and after a death, as those of the player are.
 * Source: docs/specification/mspacman-task.md, section 3.1.
 */
final class FullNetworkEvaluator {

    private final NetworkInputs sensors;
    private final NetworkState[] states = new NetworkState[4];
    private final int inputs;
    private final int nodes;
    private final @Nullable ModuleDivision division;
    private final ResumableRandom random = new ResumableRandom(0);
    private int livesBefore = -1;

    FullNetworkEvaluator(MsPacManTaskSettings settings, Genotype genotype) {
        sensors = SensorSuite.of(settings.networks().sensors()).newInputs();
        Network network = Network.compileWithAllNodes(genotype);
        for (int d = 0; d < states.length; d++) {
            states[d] = network.newState(settings.networks().arbitration());
        }
        inputs = genotype.inputs();
        nodes = genotype.nodes().size();
        division = genotype.layout().isDivided() ? settings.networks().division() : null;
    }

    void startGame() {
        for (NetworkState state : states) {
            state.reset();
        }
        livesBefore = -1;
    }

    /**
     * Reads the sensors before a decision, evaluates the network in every open direction, and stores sensor values and
     * activations in the step.
     */
    void evaluate(Game game, ReplayStep step) {
        flushAfterChange(game);
        sensors.observe(game);
        for (int d = 0; d < states.length; d++) {
            step.open[d] = sensors.observation().isOpen(d);
            if (!step.open[d]) {
                states[d].flush();
                continue;
            }
            System.arraycopy(sensors.inputs(d), 0, step.sensors[d], 0, inputs);
            if (division != null) {
                states[d].presetModule(division.module(sensors.observation()));
            }
            states[d].activate(step.sensors[d], random);
            for (int node = inputs; node < nodes; node++) {
                step.activations[d][node - inputs] = states[d].nodeActivation(node);
            }
        }
    }

    private void flushAfterChange(Game game) {
        int lives = game.getPacmanNumberOfLivesRemaining();
        if (game.getCurrentLevelTime() == 0 || lives < livesBefore) {
            for (NetworkState state : states) {
                state.flush();
            }
        }
        livesBefore = lives;
    }
}
