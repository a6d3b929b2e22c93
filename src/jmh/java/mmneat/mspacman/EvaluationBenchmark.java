package mmneat.mspacman;

import java.util.List;
import java.util.concurrent.TimeUnit;
import mmneat.evolution.Evaluation;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import org.openjdk.jmh.annotations.AuxCounters;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;

/**
 * Measures game steps per second of whole evaluations on one thread, which determine the duration of an experiment.
 * Each evaluation has another network, as in evolution.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
public class EvaluationBenchmark {

    private static final int NETWORKS = 100;

    /** The version of the task. */
    @Param({"BLENDED", "ISOLATED"})
    public TaskVersion version;

    /** The paper's sensors, or separate sensors for threats and edible ghosts. */
    @Param({"PUBLISHED", "SPLIT"})
    public Sensors sensors;

    /** Choices of sensors. */
    public enum Sensors {
        PUBLISHED,
        SPLIT
    }

    /** Networks of an early generation, or of the size of champions. */
    @Param({"MUTATED_30_TIMES", "CHAMPION_SIZED"})
    public Networks networks;

    /** The origin of the networks. */
    public enum Networks {
        MUTATED_30_TIMES,
        CHAMPION_SIZED
    }

    private MsPacManTask task;
    private List<Genotype> population;
    private ResumableRandom random;
    private int next;

    @Setup(Level.Trial)
    public void prepare() {
        task = sensors == Sensors.SPLIT ? EvaluationWorkload.splitTask(version) : EvaluationWorkload.task(version);
        population = networks == Networks.MUTATED_30_TIMES
                ? EvaluationWorkload.mutated(task.inputs(), NETWORKS, 30)
                : EvaluationWorkload.grown(task.inputs(), NETWORKS);
        random = new ResumableRandom(4);
    }

    /** Counts game steps in addition to evaluations. */
    @AuxCounters(AuxCounters.Type.OPERATIONS)
    @State(Scope.Thread)
    public static class Counters {
        public long gameSteps;
    }

    @Benchmark
    public Evaluation evaluation(Counters counters) {
        Evaluation evaluation = task.evaluate(population.get(next), random);
        next = (next + 1) % population.size();
        counters.gameSteps += evaluation.outcomes().steps();
        return evaluation;
    }
}
