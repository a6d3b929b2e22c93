package mmneat.neat;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import mmneat.random.ResumableRandom;

/**
 * Makes offspring from parents: copy, crossover, mutation. Parents are left as they are; innovations, ids and the archetype
 * advance in the gene pool.
 *
 * <p>Source: spec/networks.md, sections 7 to 10; spec/evolution.md, section 2.4.
 */
public final class Reproduction {

    private final GenePool pool;
    private final Crossover crossover;
    private final OffspringMutation mutation;

    public Reproduction(VariationSettings settings, GenePool pool) {
        this.pool = pool;
        this.crossover = new Crossover(settings.crossoverExcessRate());
        this.mutation = new OffspringMutation(settings);
    }

    /** A mutated copy of one parent. */
    public Offspring fromOne(Genotype parent, ResumableRandom random) {
        GenotypeDraft copy = GenotypeDraft.copyOf(parent, pool.takeGenotypeId());
        return finish(copy, parent.id(), OptionalLong.empty(), random);
    }

    /**
     * The children of two parents, who may be the same. The child with the second parent's structure comes first; if there is
     * room for one child only, it is dropped before it is mutated, as in the original.
     *
     * @param room how many children are wanted, at least 1; more than 2 counts as 2
     */
    public List<Offspring> fromTwo(Genotype first, Genotype second, int room, ResumableRandom random) {
        GenotypeDraft firstChild = GenotypeDraft.copyOf(first, pool.takeGenotypeId());
        // The original copies the second parent, which takes an id, and makes the child from that copy under another.
        pool.takeGenotypeId();
        GenotypeDraft secondChild = GenotypeDraft.copyOf(second, pool.takeGenotypeId());
        crossover.cross(firstChild, secondChild, pool.archetype(), random);

        List<Offspring> children = new ArrayList<>(2);
        if (room > 1) {
            children.add(finish(secondChild, first.id(), OptionalLong.of(second.id()), random));
        }
        children.add(finish(firstChild, first.id(), OptionalLong.of(second.id()), random));
        return children;
    }

    private Offspring finish(GenotypeDraft child, long firstParent, OptionalLong secondParent, ResumableRandom random) {
        List<String> mutations = mutation.apply(child, pool, random);
        return new Offspring(child.finish(), firstParent, secondParent, mutations);
    }
}
