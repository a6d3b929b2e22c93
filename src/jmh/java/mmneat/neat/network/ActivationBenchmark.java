package mmneat.neat.network;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Measures one step of a network whose output is used, with inputs that change from step to step, and the compilation
 * of a network.
 */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 5, time = 1)
@Measurement(iterations = 5, time = 1)
@Fork(3)
@State(Scope.Thread)
public class ActivationBenchmark {

    /** Number of different networks, so that the processor's predictors cannot adapt to one. */
    private static final int NETWORKS = 16;

    private static final int ROWS = 256;
    private static final int DIRECTIONS = 4;

    private static final int CORRIDOR = 0b0101;
    private static final int JUNCTION = 0b0111;

    /**
     * "champion": 25 hidden neurons and 180 links; "young": 6 and 75; "evolved": the champion of a whole run, 12 and
     * 84; "large": 100 and 500.
     */
    @Param({"champion", "young", "evolved", "large"})
    String size;

    private final Genotype[] genotypes = new Genotype[NETWORKS];
    private final NetworkState[] states = new NetworkState[NETWORKS];
    private final NetworkStates[] directions = new NetworkStates[NETWORKS];
    private final double[][] inputs = new double[ROWS][];
    private final double[][] inputActivations = new double[ROWS][];
    private final ResumableRandom random = new ResumableRandom(1);
    private int step;

    /** Creates the networks, and rows of inputs of which a third is 0, as with sensors. */
    @Setup
    public void prepare() {
        SplittableRandom sizes = new SplittableRandom(1);
        for (int i = 0; i < NETWORKS; i++) {
            genotypes[i] = genotype(sizes);
            Network network = Network.compile(genotypes[i]);
            states[i] = network.newState();
            directions[i] = network.newStates(DIRECTIONS);
        }
        int stride = genotypes[0].inputs();
        for (int row = 0; row < ROWS; row++) {
            inputActivations[row] = new double[DIRECTIONS * stride];
            for (int i = 0; i < DIRECTIONS * stride; i++) {
                inputActivations[row][i] = sizes.nextInt(3) == 0 ? 0 : Tanh.of(sizes.nextDouble());
            }
            inputs[row] = Arrays.copyOf(inputActivations[row], stride);
        }
    }

    private Genotype genotype(SplittableRandom sizes) {
        return switch (size) {
            case "champion" -> SampleGenotypes.champion(sizes);
            case "young" -> SampleGenotypes.young(sizes);
            case "large" -> SampleGenotypes.large(sizes);
            default -> ShippedChampions.read("blended").genotype();
        };
    }

    /** One step as in a game, with activations of the input neurons from tables. */
    @Benchmark
    public double activateFromInputActivations() {
        NetworkState state = nextState();
        state.activateFrom(inputActivations[step & (ROWS - 1)], 0, random);
        return state.policyOutput(0);
    }

    /** One step from raw inputs, with thirty more tanh. */
    @Benchmark
    public double activate() {
        NetworkState state = nextState();
        state.activate(inputs[step & (ROWS - 1)], random);
        return state.policyOutput(0);
    }

    /**
     * The two directions of a corridor together, and the choice of the direction with the higher output, as in a game.
     */
    @Benchmark
    public int activateCorridor() {
        return activateTogether(CORRIDOR);
    }

    /** As {@link #activateCorridor}, for the three directions of a junction. */
    @Benchmark
    public int activateJunction() {
        return activateTogether(JUNCTION);
    }

    private int activateTogether(int which) {
        step++;
        NetworkStates together = directions[step >>> 10 & (NETWORKS - 1)];
        together.activate(
                which, inputActivations[step & (ROWS - 1)], states[0].network().inputs(), random);
        return together.clearlyHighest(which, 0);
    }

    /** Returns the next state; a network is used for the number of steps of a game. */
    private NetworkState nextState() {
        step++;
        return states[step >>> 10 & (NETWORKS - 1)];
    }

    /** Compiles a genotype to a network. */
    @Benchmark
    public Network compile() {
        return Network.compile(genotypes[step++ & (NETWORKS - 1)]);
    }
}
