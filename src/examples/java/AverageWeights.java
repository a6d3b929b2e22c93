import mmneat.cli.Main;
import mmneat.neat.*;
import mmneat.neat.variation.CrossoverOperator;
import mmneat.random.ResumableRandom;

/** A crossover: both children get the mean weight of each link that both parents have. */
public class AverageWeights implements CrossoverOperator {
    public void cross(GenotypeDraft first, GenotypeDraft second, Archetype archetype, ResumableRandom random) {
        for (int i = 0; i < first.links().size(); i++) {
            LinkGene link = first.links().get(i);
            for (int j = 0; j < second.links().size(); j++) {
                LinkGene other = second.links().get(j);
                if (link.innovation() == other.innovation()) {
                    first.links().set(i, link.withWeight((link.weight() + other.weight()) / 2));
                    second.links().set(j, other.withWeight((link.weight() + other.weight()) / 2));
                }
            }
        }
    }

    public static void main(String[] arguments) {
        Main.main("task=blended crossover=AverageWeights mu=10 maxGens=3 trials=2 base=results/average".split(" "));
    }
}
