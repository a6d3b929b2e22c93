package mmneat.nsga2;

import java.util.Arrays;
import java.util.concurrent.TimeUnit;
import mmneat.random.ResumableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/** Selection of 100 survivors out of 200 individuals with two objectives. */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class SelectionBenchmark {

    /** Many fronts of similar size, or one chain of 200 fronts. */
    @Param({"scattered", "chain"})
    String shape;

    private double[][] scores;

    @Setup
    public void makeScores() {
        ResumableRandom random = new ResumableRandom(1);
        scores = new double[200][2];
        for (int i = 0; i < scores.length; i++) {
            int rank = i;
            Arrays.setAll(scores[i], j -> shape.equals("chain") ? rank : random.nextInt(1000) / 10.0);
        }
    }

    @Benchmark
    public int[] survivors() {
        return SurvivorSelection.survivors(scores, 100, Crowding.WHOLE_POPULATION);
    }
}
