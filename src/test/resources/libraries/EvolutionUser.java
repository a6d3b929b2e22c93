import java.util.List;
import mmneat.evolution.Evaluation;
import mmneat.evolution.Evolution;
import mmneat.evolution.Task;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;

/** Evolves networks with many links. */
public class EvolutionUser implements Task {
    public static void main(String[] arguments) {
        Task task = new EvolutionUser();
        int links = Evolution.of(task).populationSize(4).generations(5).seed(1).run().champion(task).genotype().links().size();
        System.out.println(links > 4);
    }

    @Override
    public List<String> objectiveNames() {
        return List.of("Links");
    }

    @Override
    public List<String> inputLabels() {
        return List.of("Bias", "First");
    }

    @Override
    public int policyNeuronsPerModule() {
        return 1;
    }

    @Override
    public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
        return new Evaluation(
                new double[] {genotype.links().size()}, new double[0], new int[] {1}, Evaluation.Outcomes.NONE);
    }
}
