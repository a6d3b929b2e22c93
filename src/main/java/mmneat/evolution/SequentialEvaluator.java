package mmneat.evolution;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;

/** Evaluates one individual after the other with the run's generator: exactly as the original does. */
public final class SequentialEvaluator implements Evaluator {

    private final Task task;
    private final LongSupplier nanoTime;

    /** An evaluator that measures time with the system's clock. */
    public SequentialEvaluator(Task task) {
        this(task, System::nanoTime);
    }

    SequentialEvaluator(Task task, LongSupplier nanoTime) {
        this.task = task;
        this.nanoTime = nanoTime;
    }

    @Override
    public List<Individual> evaluate(
            List<Genotype> genotypes,
            int generation,
            int firstIndex,
            ResumableRandom random,
            Consumer<Individual> whenDone) {
        List<Individual> individuals = new ArrayList<>(genotypes.size());
        for (Genotype genotype : genotypes) {
            if (Thread.currentThread().isInterrupted()) {
                throw new CancellationException("interrupted in generation " + generation);
            }
            Individual individual = evaluate(task, genotype, random, nanoTime);
            individuals.add(individual);
            whenDone.accept(individual);
        }
        return individuals;
    }

    static Individual evaluate(Task task, Genotype genotype, ResumableRandom random, LongSupplier nanoTime) {
        long start = nanoTime.getAsLong();
        Evaluation evaluation = task.evaluate(genotype, random);
        requireAsNamed("objectives", evaluation.objectives(), task.objectiveNames());
        requireAsNamed("other scores", evaluation.otherScores(), task.otherScoreNames());
        return Individual.of(genotype, evaluation, nanoTime.getAsLong() - start);
    }

    private static void requireAsNamed(String what, double[] scores, List<String> names) {
        if (scores.length != names.size()) {
            throw new IllegalStateException(
                    "the task gave " + scores.length + " " + what + " but names " + names.size() + ": " + names);
        }
    }
}
