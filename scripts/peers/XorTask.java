import java.util.List;
import mmneat.evolution.Evaluation;
import mmneat.evolution.Task;
import mmneat.neat.Genotype;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkState;
import mmneat.random.ResumableRandom;

/** Exclusive or with the fitness of neat-python's example: 4 minus the squared errors. */
public final class XorTask implements Task {

    @Override
    public List<String> objectiveNames() {
        return List.of("Fitness");
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
    public boolean isDeterministic() {
        return true;
    }

    @Override
    public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
        NetworkState network = Network.compile(genotype).newState();
        int[] moduleUsage = new int[genotype.modules()];
        double fitness = 4;
        for (int bits = 0; bits < 4; bits++) {
            network.flush();
            moduleUsage[network.activate(new double[] {1, bits & 1, bits >> 1}, random)]++;
            double error = network.policyOutput(0) - ((bits & 1) ^ (bits >> 1));
            fitness -= error * error;
        }
        return new Evaluation(new double[] {fitness}, new double[0], moduleUsage, new Evaluation.Outcomes(0, 0, 0, 4));
    }
}
