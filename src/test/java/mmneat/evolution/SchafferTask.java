package mmneat.evolution;

import java.util.List;
import mmneat.neat.Genotype;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkState;
import mmneat.random.ResumableRandom;

/**
 * Schaffer's two-objective problem with noise. The network's output for a constant input is x in (-1, 1); one objective
 * rewards x near -0.5, the other x near 0.5. Every x between the two is Pareto optimal.
 */
public class SchafferTask extends SmallTask {

    static final double NOISE = 0.001;

    @Override
    public List<String> objectiveNames() {
        return List.of("NearMinusHalf", "NearHalf");
    }

    @Override
    public double[] referencePoint() {
        return new double[] {-3, -3};
    }

    @Override
    public List<String> otherScoreNames() {
        return List.of("Answer");
    }

    @Override
    public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
        NetworkState network = Network.compile(genotype).newState();
        network.activate(new double[] {1}, random);
        double x = network.policyOutput(0) + NOISE * random.nextGaussian();
        double[] objectives = {-(x + 0.5) * (x + 0.5), -(x - 0.5) * (x - 0.5)};
        return new Evaluation(objectives, new double[] {x}, network.moduleUsage(), new Evaluation.Outcomes(0, 0, 0, 1));
    }
}
