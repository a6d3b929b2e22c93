package mmneat.nsga2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.IntStream;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

class Nsga2Test {

    /** Schaffer's problem: minimise x^2 and (x - 2)^2; every x in [0, 2] is optimal. */
    private static double[] schaffer(double x) {
        return new double[] {-x * x, -(x - 2) * (x - 2)};
    }

    @Test
    void evolve_findsTheFrontOfSchaffersProblem() {
        ResumableRandom random = new ResumableRandom(4);
        List<Double> start = IntStream.range(0, 20).mapToObj(i -> 100.0 + i).toList();
        List<Double> front = Nsga2.evolve(start, Nsga2Test::schaffer, (x, r) -> x + r.nextGaussian(), 200, random);
        assertThat(front).hasSize(20).allSatisfy(x -> assertThat(x).isBetween(-0.01, 2.01));
        double[][] scores = front.stream().map(Nsga2Test::schaffer).toArray(double[][]::new);
        // The optimum is 13.3, the limit for infinitely many points.
        assertThat(Hypervolume.of(scores, new double[] {-4, -4})).isGreaterThan(12.5);
    }

    @Test
    void evolve_withoutParents_isRefused() {
        assertThatThrownBy(() ->
                        Nsga2.evolve(List.<Double>of(), Nsga2Test::schaffer, (x, r) -> x, 1, new ResumableRandom(1)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("population must not be empty");
    }
}
