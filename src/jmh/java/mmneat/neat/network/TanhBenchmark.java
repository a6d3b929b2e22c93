package mmneat.neat.network;

import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Measures the hyperbolic tangents {@link Tanh} and {@link RoughTanh} against the Java library's. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(3)
@State(Scope.Thread)
public class TanhBenchmark {

    private static final int ARGUMENTS = 1024;

    /** Standard deviation of the arguments: neurons of young networks, of grown ones, mostly saturated ones. */
    @Param({"0.5", "2", "15"})
    double spread;

    private final double[] arguments = new double[ARGUMENTS];
    private final double[] results = new double[ARGUMENTS];

    /** Fills in the arguments. */
    @Setup
    public void draw() {
        SplittableRandom random = new SplittableRandom(1);
        for (int i = 0; i < ARGUMENTS; i++) {
            arguments[i] = random.nextGaussian() * spread;
        }
    }

    /** Ours, independent arguments. */
    @Benchmark
    @OperationsPerInvocation(ARGUMENTS)
    public double[] fast() {
        for (int i = 0; i < ARGUMENTS; i++) {
            results[i] = Tanh.of(arguments[i]);
        }
        return results;
    }

    /** The library's, independent arguments. */
    @Benchmark
    @OperationsPerInvocation(ARGUMENTS)
    public double[] strictMath() {
        for (int i = 0; i < ARGUMENTS; i++) {
            results[i] = StrictMath.tanh(arguments[i]);
        }
        return results;
    }

    /** Ours for decisions, independent arguments. */
    @Benchmark
    @OperationsPerInvocation(ARGUMENTS)
    public double[] rough() {
        for (int i = 0; i < ARGUMENTS; i++) {
            results[i] = RoughTanh.of(arguments[i]);
        }
        return results;
    }

    /** Ours, each argument depending on the previous result. */
    @Benchmark
    @OperationsPerInvocation(ARGUMENTS)
    public double fastInChain() {
        double last = 0;
        for (int i = 0; i < ARGUMENTS; i++) {
            last = Tanh.of(arguments[i] + last);
        }
        return last;
    }
}
