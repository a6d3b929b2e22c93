package mmneat.evolution;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;

/**
 * An evaluator for deterministic tasks that does not evaluate parents again. It returns their evaluation of the
 * previous generation, in which they were parents or children.
 *
 * <p>The results are those of the wrapped evaluator. They differ only in the recorded time of an evaluation.
 */
public final class ScoreKeepingEvaluator implements Evaluator {

    private final Evaluator evaluator;

    /** Individuals of the last generation by the id of their genotype. */
    private Map<Long, Individual> kept = Map.of();

    /**
     * @param evaluator evaluates the genotypes without a kept evaluation; its task must be deterministic ({@link
     *     Task#isDeterministic})
     */
    public ScoreKeepingEvaluator(Evaluator evaluator) {
        this.evaluator = evaluator;
    }

    @Override
    public List<Individual> evaluate(
            List<Genotype> genotypes,
            int generation,
            int firstIndex,
            ResumableRandom random,
            Consumer<Individual> whenDone) {
        if (!genotypes.stream().allMatch(this::isKept)) {
            List<Individual> evaluated = evaluator.evaluate(genotypes, generation, firstIndex, random, whenDone);
            Map<Long, Individual> byId = firstIndex == 0 ? new HashMap<>() : new HashMap<>(kept);
            evaluated.forEach(individual -> byId.put(individual.genotype().id(), individual));
            kept = byId;
            return evaluated;
        }
        List<Individual> known = new ArrayList<>(genotypes.size());
        Map<Long, Individual> byId = new HashMap<>();
        for (Genotype genotype : genotypes) {
            Individual individual = kept.get(genotype.id());
            known.add(individual);
            byId.put(genotype.id(), individual);
            whenDone.accept(individual);
        }
        kept = byId;
        return known;
    }

    private boolean isKept(Genotype genotype) {
        Individual individual = kept.get(genotype.id());
        return individual != null && individual.genotype() == genotype;
    }
}
