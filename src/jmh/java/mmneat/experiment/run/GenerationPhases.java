package mmneat.experiment.run;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import mmneat.evolution.Evaluator;
import mmneat.evolution.Evolution;
import mmneat.evolution.EvolutionObserver;
import mmneat.evolution.EvolutionSettings;
import mmneat.evolution.EvolutionState;
import mmneat.evolution.Generation;
import mmneat.evolution.Individual;
import mmneat.evolution.ParallelEvaluator;
import mmneat.evolution.Task;
import mmneat.experiment.original.RunFiles;
import mmneat.experiment.parameters.EvolutionParameters;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.parameters.Parameters;
import mmneat.experiment.parameters.Tasks;
import mmneat.experiment.store.CheckpointCheck;
import mmneat.experiment.store.CheckpointFile;
import mmneat.experiment.store.GenerationTable;
import mmneat.experiment.store.RunFolder;
import mmneat.experiment.store.RunLock;
import mmneat.experiment.store.RunStatus;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;

/**
 * Measures the phases of generations that evaluate in parallel ({@code parallelEvaluations=true}): evaluation on many
 * threads; reproduction, selection and commit (logs, checkpoint) on the run's thread.
 *
 * <p>The run continues from a checkpoint, with all its files. The first generation is the warm-up.
 */
final class GenerationPhases implements Evaluator, EvolutionObserver {

    private static final int MANY_CORES = 64;

    private enum Phase {
        /** The run's thread while others evaluate: it hands out genotypes and collects results. */
        DISTRIBUTION,
        REPRODUCTION,
        SELECTION,
        COMMIT
    }

    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final Evaluator evaluator;
    private final EvolutionObserver recorder;

    /** Processor time of the run's thread in each phase, in nanoseconds. */
    private final Map<Phase, Long> serial = new EnumMap<>(Phase.class);

    /** Elapsed times of evaluations, in nanoseconds: parents and children of each generation in turns. */
    private final List<List<Long>> evaluations = new ArrayList<>();

    private long lastProcessorTime;
    private long startOfEvaluators;
    private long evaluatorsTime;
    private long startOfAll;
    private long allTime;
    private long start;
    private long elapsed;
    private int generations;
    private boolean isChildren;

    private GenerationPhases(Evaluator evaluator, EvolutionObserver recorder) {
        this.evaluator = evaluator;
        this.recorder = recorder;
    }

    /**
     * Measures one number of threads.
     *
     * @param arguments the checkpoint, an empty folder for the run, threads, and measured generations
     */
    public static void main(String[] arguments) throws Exception {
        Path checkpoint = Path.of(arguments[0]);
        int threads = Integer.parseInt(arguments[2]);
        int generations = Integer.parseInt(arguments[3]);
        String[] words =
                checkpoint.getFileName().toString().replace(".json.gz", "").split("-");
        int last = Integer.parseInt(words[2]) + 1 + generations;
        Parameters parameters = new ParameterReader(ParameterCatalogue.load())
                .read(List.of(
                        "task=" + words[0],
                        "method=" + words[1],
                        "runs=1",
                        "base=" + arguments[1],
                        "parallelEvaluations=true",
                        "maxGens=" + last))
                .parameters();
        RunPlan run = ExperimentPlan.of(parameters).runs().get(0);
        Files.createDirectories(run.directory());
        Files.copy(checkpoint, run.directory().resolve("checkpoint.json.gz"));
        measure(run, parameters, threads);
    }

    private static void measure(RunPlan run, Parameters parameters, int threads) throws Exception {
        Supplier<Task> tasks = Tasks.factory(parameters);
        Task task = tasks.get();
        EvolutionSettings settings = EvolutionParameters.settings(parameters, task);
        RunFolder folder = new RunFolder(run.directory(), run.prefix());
        RunFiles files = new RunFiles(folder, task, EnumSet.allOf(RunFiles.Choice.class));
        CheckpointFile checkpoint = new CheckpointFile(run.directory());
        EvolutionState state = checkpoint
                .load(new CheckpointCheck(settings, run.prefix()))
                .orElseThrow()
                .evolution();
        RunStatus status = new RunStatus(
                RunStatus.State.RUNNING, state.generation(), run.generations(), Double.NaN, Double.NaN, 0, 0, null);
        try (RunLock lock = RunLock.acquire(run.directory(), RunLock.Timing.USUAL);
                ParallelEvaluator evaluator = new ParallelEvaluator(tasks, threads, run.seed())) {
            RunRecorder recorder = new RunRecorder(
                    task,
                    folder,
                    files,
                    GenerationTable.in(
                            run.directory(), task, settings.initialNetworks().layout()),
                    checkpoint,
                    lock,
                    new CommitGate(),
                    new RunMonitor(run, System::nanoTime),
                    CheckpointSchedule.of(parameters.text("checkpointEvery"), System::nanoTime),
                    status);
            GenerationPhases phases = new GenerationPhases(evaluator, recorder);
            new Evolution(settings, state, phases, phases).run();
            phases.print(threads);
        }
    }

    /** Adds the processor time of the run's thread since the last call to a phase. */
    private void end(Phase phase) {
        long now = threads.getCurrentThreadCpuTime();
        serial.merge(phase, now - lastProcessorTime, Long::sum);
        lastProcessorTime = now;
    }

    @Override
    public List<Individual> evaluate(
            List<Genotype> genotypes,
            int generation,
            int firstIndex,
            ResumableRandom random,
            Consumer<Individual> whenDone) {
        if (isChildren) {
            end(Phase.REPRODUCTION);
        }
        List<Individual> individuals = evaluator.evaluate(genotypes, generation, firstIndex, random, whenDone);
        end(Phase.DISTRIBUTION);
        evaluations.add(individuals.stream().map(Individual::nanoseconds).toList());
        isChildren = !isChildren;
        return individuals;
    }

    @Override
    public void evaluated(int generation, int done, int total, Individual individual) {
        recorder.evaluated(generation, done, total, individual);
    }

    @Override
    public void generationCompleted(Generation generation, EvolutionState next) {
        end(Phase.SELECTION);
        recorder.generationCompleted(generation, next);
        end(Phase.COMMIT);
        if (start == 0) {
            // The warm-up is over.
            serial.clear();
            evaluations.clear();
            start = System.nanoTime();
            startOfEvaluators = processorTimeOfEvaluators();
            startOfAll = processorTimeOfAll();
        } else {
            generations++;
            elapsed = System.nanoTime() - start;
            evaluatorsTime = processorTimeOfEvaluators() - startOfEvaluators;
            allTime = processorTimeOfAll() - startOfAll;
        }
        lastProcessorTime = threads.getCurrentThreadCpuTime();
    }

    @Override
    public void completed(Generation finalParents) {
        recorder.completed(finalParents);
    }

    private long processorTimeOfEvaluators() {
        long time = 0;
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (thread.getName().equals("evaluation")) {
                time += threads.getThreadCpuTime(thread.getId());
            }
        }
        return time;
    }

    private static long processorTimeOfAll() {
        return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
                .getProcessCpuTime();
    }

    private void print(int threadCount) {
        long ofRunThread = serial.values().stream().mapToLong(Long::longValue).sum();
        double work = ofRunThread + evaluatorsTime;
        String phases = serial.entrySet().stream()
                .map(phase -> String.format(
                        Locale.ROOT,
                        "%s %.1f",
                        phase.getKey().name().toLowerCase(Locale.ROOT),
                        milliseconds(phase.getValue())))
                .collect(Collectors.joining(", "));
        System.out.printf(
                Locale.ROOT,
                "threads %d: elapsed %.0f ms; processor time: evaluation %.0f ms, %s, compiler and collector %.0f ms%n",
                threadCount,
                milliseconds(elapsed),
                milliseconds(evaluatorsTime),
                phases,
                milliseconds(allTime - evaluatorsTime - ofRunThread));
        double share = ofRunThread / work;
        System.out.printf(
                Locale.ROOT,
                "  serial %.2f %% of the work; on %d cores %.1f times faster by Amdahl's law%n",
                100 * share,
                MANY_CORES,
                1 / (share + (1 - share) / MANY_CORES));
        if (threadCount == 1) {
            // With more threads than free cores, the elapsed times of evaluations say little.
            System.out.printf(
                    Locale.ROOT,
                    "  with evaluations of these lengths %.1f times%n",
                    1 / (share + (1 - share) * scheduledShare()));
        }
    }

    private double milliseconds(long nanoseconds) {
        return nanoseconds / 1e6 / generations;
    }

    /**
     * Time of the evaluations on {@link #MANY_CORES} cores as a share of their time on one: each core takes the next
     * evaluation when it is free, and parents and children wait for each other.
     */
    private double scheduledShare() {
        long scheduled = 0;
        long sum = 0;
        for (List<Long> population : evaluations.subList(0, 2 * generations)) {
            PriorityQueue<Long> cores = new PriorityQueue<>();
            long end = 0;
            for (long time : population) {
                long begin = cores.size() < MANY_CORES ? 0 : cores.remove();
                cores.add(begin + time);
                end = Math.max(end, begin + time);
                sum += time;
            }
            scheduled += end;
        }
        return (double) scheduled / sum;
    }
}
