import mmneat.cli.Main;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.variation.MutationOperator;
import mmneat.random.ResumableRandom;

/** A mutation operator: draws all weights a little towards 0. */
public class WeightDecay implements MutationOperator {
    public String logName() {
        return "WeightDecay";
    }

    public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        double factor = 1 - 0.1 * random.nextDouble();
        offspring.links().replaceAll(link -> link.withWeight(factor * link.weight()));
        return true;
    }

    public static void main(String[] arguments) {
        Main.main("task=blended mutations=WeightDecay:0.3 mu=10 maxGens=3 trials=2 base=results/decay".split(" "));
    }
}
