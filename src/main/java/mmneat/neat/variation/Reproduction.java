package mmneat.neat.variation;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.OptionalLong;
import java.util.function.Supplier;
import mmneat.neat.DraftCheck;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.ModuleLayout;
import mmneat.neat.OwnPart;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;

/**
 * Makes offspring from parents: copies them, crosses two copies if there are two parents, and mutates the copies.
 * Parents are not changed. Innovation numbers, ids and the archetype advance in the gene pool. Parents that belong to
 * another pool are refused as far as this can be detected.
 *
 * <p>Source: docs/specification/networks.md, sections 7 to 10; docs/specification/evolution.md, section 2.4.
 */
public final class Reproduction {

    private final GenePool pool;
    private final CrossoverOperator crossover;

    /** Check of a crossover of the user's own; null for NEAT's. */
    private final @Nullable DraftCheck crossoverCheck;

    private final OffspringMutation mutation;

    /**
     * Reproduction of the genotypes of one pool.
     *
     * @throws NullPointerException if one of them is missing
     */
    public Reproduction(VariationSettings settings, GenePool pool) {
        this.pool = Objects.requireNonNull(pool, "pool");
        Objects.requireNonNull(settings, "settings");
        this.crossover = settings.ownCrossover().orElseGet(() -> new Crossover(settings.crossoverExcessRate()));
        this.crossoverCheck = settings.ownCrossover()
                .map(own -> new DraftCheck(OwnPart.of("crossover", own), settings.activation()))
                .orElse(null);
        this.mutation = new OffspringMutation(settings);
    }

    /**
     * Returns a mutated copy of one parent.
     *
     * @throws IllegalArgumentException if the parent has genes that are not of this pool
     * @throws IllegalStateException if a module is to be added to a multitask network, or an operator of the user's own
     *     fails or leaves an invalid network behind ({@link mmneat.neat.BadPartException})
     */
    public Offspring fromOne(Genotype parent, ResumableRandom random) {
        pool.requireOwn(parent);
        GenotypeDraft copy = GenotypeDraft.copyOf(parent, pool.takeGenotypeId());
        return finish(copy, parent.id(), OptionalLong.empty(), random);
    }

    /**
     * Returns the children of two parents, which may be the same. Two children are made, each with the structure of one
     * parent. If {@code room} is 2 or more, both are mutated and returned: first the child with the structure of {@code
     * second}, then the child with the structure of {@code first}. If {@code room} is 1, only the child with the
     * structure of {@code first} is mutated and returned; the other is dropped, as in the original.
     *
     * @param room the largest number of children to return, at least 1; more than 2 counts as 2
     * @throws IllegalArgumentException if {@code room} is less than 1, a parent has genes that are not of this pool,
     *     only one parent is a multitask network, or the parents differ in the number of inputs or of policy neurons
     *     per module
     * @throws IllegalStateException if a module is to be added to a multitask network, or an operator of the user's own
     *     fails or leaves an invalid network behind ({@link mmneat.neat.BadPartException})
     */
    public List<Offspring> fromTwo(Genotype first, Genotype second, int room, ResumableRandom random) {
        if (room < 1) {
            throw new IllegalArgumentException("room must be at least 1, is " + room);
        }
        requireAlike(first, second);
        pool.requireOwn(first);
        pool.requireOwn(second);
        GenotypeDraft firstChild = GenotypeDraft.copyOf(first, pool.takeGenotypeId());
        // The original copies the second parent, which takes an id, and makes the child from that copy with another id.
        pool.takeGenotypeId();
        GenotypeDraft secondChild = GenotypeDraft.copyOf(second, pool.takeGenotypeId());
        cross(firstChild, secondChild, random);

        List<Offspring> children = new ArrayList<>(2);
        if (room > 1) {
            children.add(finish(secondChild, first.id(), OptionalLong.of(second.id()), random));
        }
        children.add(finish(firstChild, first.id(), OptionalLong.of(second.id()), random));
        return children;
    }

    private void cross(GenotypeDraft first, GenotypeDraft second, ResumableRandom random) {
        if (crossoverCheck == null) {
            crossover.cross(first, second, pool.archetype(), random);
            return;
        }
        Supplier<Boolean> own = () -> {
            crossover.cross(first, second, pool.archetype(), random);
            return true;
        };
        crossoverCheck.call(own, pool, first, second);
    }

    private static void requireAlike(Genotype first, Genotype second) {
        requireEqual("inputs", first.inputs(), second.inputs());
        ModuleLayout layout = first.layout();
        ModuleLayout other = second.layout();
        requireEqual("policy neurons per module", layout.policyNeuronsPerModule(), other.policyNeuronsPerModule());
        if (layout.standardMultitask() != other.standardMultitask()) {
            throw new IllegalArgumentException("a multitask network cannot be crossed with one that is not");
        }
        requireEqual("groups of modules", groups(layout), groups(other));
    }

    private static int groups(ModuleLayout layout) {
        return layout.isGrouped() ? layout.choicesOfTask() : 0;
    }

    private static void requireEqual(String what, int first, int second) {
        if (first != second) {
            throw new IllegalArgumentException(
                    "parents must have equally many " + what + ", have " + first + " and " + second);
        }
    }

    private Offspring finish(GenotypeDraft child, long firstParent, OptionalLong secondParent, ResumableRandom random) {
        List<String> mutations = mutation.apply(child, pool, random);
        return new Offspring(child.finish(), firstParent, secondParent, mutations);
    }
}
