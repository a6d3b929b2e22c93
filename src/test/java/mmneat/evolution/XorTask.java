package mmneat.evolution;

import java.util.List;
import java.util.Map;
import mmneat.neat.Genotype;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkState;
import mmneat.random.ResumableRandom;

/**
 * Exclusive or with noisy inputs and, as second objective, few links. It is written as a user would write a task;
 * exclusive or is the smallest problem that needs a hidden neuron.
 */
public final class XorTask implements Task {

    private final double noise;
    private final int repetitions;

    /** The task without noise: the random numbers that it draws have no effect on scores. */
    static XorTask exact() {
        return new XorTask(Map.of("noise", "0", "repetitions", "1"));
    }

    public XorTask(Map<String, String> parameters) {
        noise = Double.parseDouble(parameters.getOrDefault("noise", "0.05"));
        repetitions = Integer.parseInt(parameters.getOrDefault("repetitions", "5"));
    }

    @Override
    public List<String> objectiveNames() {
        return List.of("Correctness", "Sparseness");
    }

    @Override
    public List<String> otherScoreNames() {
        return List.of("Correctness");
    }

    @Override
    public double[] referencePoint() {
        return new double[] {0, -1000};
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
        NetworkState state = Network.compile(genotype).newState();
        double error = 0;
        int cases = 0;
        int[] usage = new int[genotype.modules()];
        for (int repetition = 0; repetition < repetitions; repetition++) {
            for (int first = 0; first < 2; first++) {
                for (int second = 0; second < 2; second++) {
                    state.flush();
                    double[] inputs = {1, first + noise * random.nextGaussian(), second + noise * random.nextGaussian()
                    };
                    usage[state.activate(inputs, random)]++;
                    error += Math.abs(state.policyOutput(0) - (first ^ second));
                    cases++;
                }
            }
        }
        double correctness = 1 - error / cases;
        long links = genotype.links().size();
        return new Evaluation(
                new double[] {correctness, -links},
                new double[] {correctness},
                usage,
                new Evaluation.Outcomes(0, 0, 0, cases));
    }
}
