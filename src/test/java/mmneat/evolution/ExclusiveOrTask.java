package mmneat.evolution;

import java.util.List;
import mmneat.neat.Genotype;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkState;
import mmneat.random.ResumableRandom;

/** The smallest task that needs a hidden neuron: the exclusive or of two inputs, one objective, no chance. */
public final class ExclusiveOrTask implements Task {

    private static final double[][] CASES = {{1, 0, 0}, {1, 0, 1}, {1, 1, 0}, {1, 1, 1}};

    @Override
    public List<String> objectiveNames() {
        return List.of("Correctness");
    }

    @Override
    public List<String> inputLabels() {
        return List.of("Bias", "First", "Second");
    }

    @Override
    public int policyNeuronsPerModule() {
        return 1;
    }

    @Override
    public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
        NetworkState network = Network.compile(genotype).newState();
        double correctness = 4;
        for (double[] inputs : CASES) {
            network.flush();
            network.activate(inputs, random);
            double wanted = inputs[1] == inputs[2] ? 0 : 1;
            double error = network.policyOutput(0) - wanted;
            correctness -= error * error;
        }
        return new Evaluation(
                new double[] {correctness}, new double[0], network.moduleUsage(), Evaluation.Outcomes.NONE);
    }
}
