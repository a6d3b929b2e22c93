package mmneat.neat.variation;

import java.util.List;
import java.util.Objects;
import java.util.OptionalLong;
import mmneat.neat.Genotype;

/**
 * A child with the record of its parents and mutations.
 *
 * @param genotype the child, mutated
 * @param firstParent id of the first parent. For a child of two parents, it is the parent named first in the original's
 *     lineage log, which need not be the one with the child's structure
 * @param secondParent id of the other parent, if there was a crossover
 * @param mutations names of the mutations that were performed, in order, as in the original's log of mutations
 */
public record Offspring(Genotype genotype, long firstParent, OptionalLong secondParent, List<String> mutations) {

    /**
     * A child with a copy of the names.
     *
     * @throws NullPointerException if a part is missing; the message names it
     */
    public Offspring {
        Objects.requireNonNull(genotype, "genotype");
        Objects.requireNonNull(secondParent, "secondParent");
        mutations = List.copyOf(Objects.requireNonNull(mutations, "mutations"));
    }
}
