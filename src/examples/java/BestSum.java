import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;
import mmneat.cli.Main;
import mmneat.nsga2.Selection;
import mmneat.random.ResumableRandom;

/** A selection: those with the highest sum of scores survive. Parents are chosen as in NSGA-II. */
public class BestSum implements Selection {
    public int[] survivors(double[][] scores, int count, ResumableRandom random) {
        return IntStream.range(0, scores.length)
                .boxed()
                .sorted(Comparator.comparingDouble(
                        i -> -Arrays.stream(scores[i]).sum()))
                .limit(count)
                .mapToInt(i -> i)
                .toArray();
    }

    public static void main(String[] arguments) {
        Main.main("task=blended selection=BestSum mu=10 maxGens=3 trials=2 base=results/best-sum".split(" "));
    }
}
