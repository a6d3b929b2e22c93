package mmneat.evolution;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import java.util.function.Supplier;
import mmneat.neat.BadPartException;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;

/**
 * Evaluates individuals on several threads. Each evaluation has its own generator, whose seed depends only on the run's
 * seed, the generation and the individual's index.
 *
 * <p>Results are the same for any number of threads. They differ from the original's, in which all evaluations share
 * one generator.
 */
public final class ParallelEvaluator implements Evaluator, AutoCloseable {

    private final long runSeed;
    private final ExecutorService threads;
    /** One task for each thread; an evaluation takes one and puts it back. */
    private final BlockingQueue<Task> idleTasks;

    /**
     * Starts the threads. {@link #close} stops them.
     *
     * @param tasks makes a task for each thread
     * @param threadCount number of threads, at least 1
     * @throws IllegalArgumentException if {@code threadCount} is less than 1
     */
    public ParallelEvaluator(Supplier<Task> tasks, int threadCount, long runSeed) {
        if (threadCount < 1) {
            throw new IllegalArgumentException("number of threads must be at least 1, is " + threadCount);
        }
        this.runSeed = runSeed;
        this.threads = Executors.newFixedThreadPool(threadCount, DaemonThreads.named("evaluation"));
        this.idleTasks = new ArrayBlockingQueue<>(threadCount);
        for (int i = 0; i < threadCount; i++) {
            idleTasks.add(CheckedTask.of(tasks.get()));
        }
    }

    @Override
    public List<Individual> evaluate(
            List<Genotype> genotypes,
            int generation,
            int firstIndex,
            ResumableRandom random,
            Consumer<Individual> whenDone) {
        List<Future<Individual>> pending = new ArrayList<>(genotypes.size());
        for (int i = 0; i < genotypes.size(); i++) {
            Genotype genotype = genotypes.get(i);
            long seed = evaluationSeed(generation, firstIndex + i);
            pending.add(threads.submit(() -> evaluate(genotype, generation, seed)));
        }
        try {
            List<Individual> individuals = new ArrayList<>(genotypes.size());
            for (Future<Individual> future : pending) {
                Individual individual = future.get();
                individuals.add(individual);
                whenDone.accept(individual);
            }
            return individuals;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new CancellationException("interrupted in generation " + generation);
        } catch (ExecutionException e) {
            if (e.getCause() instanceof BadEvaluationException bad) {
                throw bad;
            }
            if (e.getCause() instanceof FailedEvaluationException failed) {
                throw failed;
            }
            if (e.getCause() instanceof BadPartException bad) {
                throw bad;
            }
            if (e.getCause() instanceof Error error) {
                throw error;
            }
            throw new IllegalStateException("an evaluation failed in generation " + generation, e.getCause());
        } finally {
            pending.forEach(future -> future.cancel(true));
        }
    }

    private Individual evaluate(Genotype genotype, int generation, long seed) throws InterruptedException {
        Task task = idleTasks.take();
        try {
            return SequentialEvaluator.evaluate(
                    task, genotype, generation, new ResumableRandom(seed), System::nanoTime);
        } finally {
            idleTasks.add(task);
        }
    }

    /** Mixes all bits, so that neighbouring evaluations have unrelated generators (SplitMix64's finalizer). */
    private long evaluationSeed(int generation, int index) {
        long mixed = (runSeed * 0x9E3779B97F4A7C15L) + (((long) generation << 32) | index);
        mixed = (mixed ^ (mixed >>> 30)) * 0xBF58476D1CE4E5B9L;
        mixed = (mixed ^ (mixed >>> 27)) * 0x94D049BB133111EBL;
        return mixed ^ (mixed >>> 31);
    }

    /** Stops the threads; evaluations in progress are interrupted. */
    @Override
    public void close() {
        threads.shutdownNow();
    }
}
