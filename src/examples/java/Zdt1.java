import java.util.Arrays;
import java.util.stream.Stream;
import mmneat.nsga2.*;
import mmneat.random.ResumableRandom;

/** Minimises the two objectives of ZDT1, a benchmark of 30 numbers in [0, 1], with NSGA-II and mutation alone. */
public class Zdt1 {
    static double[] scores(double[] x) { // negated: NSGA-II maximises
        double g = 1 + 9 * Arrays.stream(x).skip(1).average().orElseThrow();
        return new double[] {-x[0], -g * (1 - Math.sqrt(x[0] / g))};
    }

    static double[] mutated(double[] parent, ResumableRandom random) {
        double[] child = parent.clone();
        child[random.nextInt(child.length)] = random.nextDouble();
        return child;
    }

    public static void main(String[] arguments) {
        var random = new ResumableRandom(1);
        var start = Stream.generate(() -> random.doubles(30).toArray()).limit(100);
        var front = Nsga2.evolve(start.toList(), Zdt1::scores, Zdt1::mutated, 1000, random);
        front.forEach(x -> System.out.println(Arrays.toString(scores(x))));
    }
}
