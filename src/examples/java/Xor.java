import java.util.List;
import mmneat.evolution.*;
import mmneat.neat.network.Network;

/** Evolves networks with two output modules that compute exclusive or. */
public class Xor {
    public static void main(String[] arguments) {
        Task xor = Task.of(List.of("Correctness"), List.of("Bias", "First", "Second"), 1, (genotype, random) -> {
            var network = Network.compile(genotype).newState();
            int[] moduleUsage = new int[genotype.modules()];
            double error = 0;
            for (int pattern = 0; pattern < 4; pattern++) {
                network.flush();
                double[] inputs = {1, pattern & 1, pattern >> 1};
                moduleUsage[network.activate(inputs, random)]++;
                error += Math.abs(network.policyOutput(0) - (pattern == 1 || pattern == 2 ? 1 : 0));
            }
            return Evaluation.of(moduleUsage, 1 - error / 4);
        });
        var last = Evolution.of(xor).modules(2).generations(100).seed(1).run();
        System.out.println(
                "Correctness: " + xor.championScore(last.champion(xor).evaluation()));
    }
}
