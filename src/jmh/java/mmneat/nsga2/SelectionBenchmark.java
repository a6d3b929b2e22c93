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

/** Measures the selection of the better half of a population. */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
public class SelectionBenchmark {

    /** Individuals x objectives. */
    @Param({"200x2", "1000x3", "2000x2", "10000x2"})
    String size;

    /** Independent random scores, or one chain in which every front has one member. */
    @Param({"scattered", "chain"})
    String shape;

    private double[][] scores;

    @Setup
    public void makeScores() {
        ResumableRandom random = new ResumableRandom(1);
        String[] sizes = size.split("x");
        scores = new double[Integer.parseInt(sizes[0])][Integer.parseInt(sizes[1])];
        for (int i = 0; i < scores.length; i++) {
            int rank = i;
            Arrays.setAll(scores[i], j -> shape.equals("chain") ? rank : random.nextInt(1000) / 10.0);
        }
    }

    @Benchmark
    public int[] survivors() {
        return SurvivorSelection.survivors(scores, scores.length / 2, Crowding.WHOLE_POPULATION);
    }
}
