package mmneat.evolution;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import mmneat.neat.Genotype;
import mmneat.neat.Thrown;
import mmneat.random.ResumableRandom;

/** Evaluates one individual after the other with the run's generator, exactly as the original does. */
public final class SequentialEvaluator implements Evaluator {

    private final Task task;
    private final LongSupplier nanoTime;

    /** An evaluator that measures time with the system's clock. */
    public SequentialEvaluator(Task task) {
        this(task, System::nanoTime);
    }

    SequentialEvaluator(Task task, LongSupplier nanoTime) {
        this.task = CheckedTask.of(task);
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
            Individual individual = evaluate(task, genotype, generation, random, nanoTime);
            individuals.add(individual);
            whenDone.accept(individual);
        }
        return individuals;
    }

    static Individual evaluate(
            Task task, Genotype genotype, int generation, ResumableRandom random, LongSupplier nanoTime) {
        long start = nanoTime.getAsLong();
        // The state of the run's generator must not depend on whether a deterministic task is evaluated again.
        ResumableRandom generator = task.isDeterministic() ? new ResumableRandom(genotype.id()) : random;
        Evaluation evaluation = evaluation(task, genotype, generation, generator);
        long nanoseconds = nanoTime.getAsLong() - start;
        requireScores(genotype, generation, "objective", evaluation.objectives(), task.objectiveNames());
        requireScores(genotype, generation, "other score", evaluation.otherScores(), task.otherScoreNames());
        requireUsage(genotype, generation, evaluation.moduleUsage());
        return Individual.of(genotype, evaluation, nanoseconds);
    }

    private static String whose(Genotype genotype, int generation) {
        return "genotype " + genotype.id() + " in generation " + generation;
    }

    private static Evaluation evaluation(Task task, Genotype genotype, int generation, ResumableRandom generator) {
        try {
            Evaluation evaluation = task.evaluate(genotype, generator);
            if (evaluation == null) {
                throw new BadEvaluationException(
                        whose(genotype, generation) + ": the task gave null instead of an evaluation");
            }
            return evaluation;
        } catch (CancellationException | BadEvaluationException e) {
            throw e;
        } catch (Throwable e) {
            new Thrown(e).passOnIfOfTheMachine();
            throw new FailedEvaluationException(whose(genotype, generation), e);
        }
    }

    /** Checks that there is one count per module, none negative. A wrong length could let mutation add a module. */
    private static void requireUsage(Genotype genotype, int generation, int[] usage) {
        if (usage.length != genotype.modules()) {
            throw new BadEvaluationException(whose(genotype, generation) + " has " + genotype.modules()
                    + " modules, but the task gave the usage of " + usage.length
                    + "; it must give one number for each module");
        }
        for (int module = 0; module < usage.length; module++) {
            if (usage[module] < 0) {
                throw new BadEvaluationException(whose(genotype, generation) + ": the task gave the usage "
                        + usage[module] + " of module " + module + "; it must be at least 0");
            }
        }
    }

    /** Checks that there is one score per name and that every score is finite. */
    private static void requireScores(
            Genotype genotype, int generation, String what, double[] scores, List<String> names) {
        if (scores.length != names.size()) {
            throw new BadEvaluationException(
                    "the task gave " + scores.length + " " + what + "s but names " + names.size() + ": " + names);
        }
        for (int i = 0; i < scores.length; i++) {
            if (!Double.isFinite(scores[i])) {
                throw new BadEvaluationException(whose(genotype, generation) + ": the task gave " + scores[i]
                        + " for the " + what + " '" + names.get(i) + "', which must be a finite number");
            }
        }
    }
}
