package mmneat.neat;

import java.util.Collection;
import java.util.HashSet;
import java.util.Objects;
import java.util.Set;

/**
 * The counters of innovation numbers and genotype ids, and the archetype, which the genotypes of one population share.
 *
 * <p>{@link #foundedOn} makes the pool of a new population, {@link #resume} that of a saved one. A pool is used by one
 * run and one thread. A pool resumed from its state continues exactly. A pool and its genotypes belong together: in
 * another pool, the same innovation number means another structure. Reproduction therefore refuses genotypes that it
 * can tell to be from another pool.
 *
 * <p>Source: docs/specification/networks.md, sections 4 and 10.
 */
public final class GenePool {

    /**
     * Maximum of a counter in a state. A run that takes a billion numbers per second for a century stays below it; a
     * larger value comes from a damaged file and would overflow.
     */
    private static final long MAX_COUNTER = Long.MAX_VALUE / 2;

    private final Archetype archetype;
    private long nextInnovation;
    private long nextGenotypeId;

    private GenePool(long nextInnovation, long nextGenotypeId, Archetype archetype) {
        this.nextInnovation = nextInnovation;
        this.nextGenotypeId = nextGenotypeId;
        this.archetype = archetype;
    }

    /**
     * Creates the pool of a new population whose networks all have the neurons of an example. As in the original, the
     * archetype begins as a copy of the example, and the copy uses up one genotype id: if the example has the id n, the
     * first individual gets n + 2.
     */
    public static GenePool foundedOn(Genotype example) {
        long firstFree = 0;
        for (NodeGene node : example.nodes()) {
            firstFree = Math.max(firstFree, node.innovation() + 1);
        }
        for (LinkGene link : example.links()) {
            firstFree = Math.max(firstFree, link.innovation() + 1);
        }
        return new GenePool(firstFree, example.id() + 2, Archetype.startingWith(example.nodes()));
    }

    /** Restores a pool from its state. */
    public static GenePool resume(State state) {
        return new GenePool(state.nextInnovation(), state.nextGenotypeId(), Archetype.resume(state.archetype()));
    }

    /** Returns the complete state. */
    public State state() {
        return new State(nextInnovation, nextGenotypeId, archetype.state());
    }

    /**
     * Refuses a genotype that cannot belong to this pool: the archetype lacks one of its neurons, or this pool has not
     * yet given out the innovation number of one of its links.
     *
     * @throws IllegalArgumentException if so
     */
    public void requireOwn(Genotype genotype) {
        int unknown = archetype.firstUnknown(genotype);
        if (unknown >= 0) {
            throw new IllegalArgumentException(
                    "genotype " + genotype.id() + " does not belong to this pool: nodes[" + unknown + "] of innovation "
                            + genotype.nodes().get(unknown).innovation() + " is not in its archetype");
        }
        for (LinkGene link : genotype.links()) {
            if (link.innovation() >= nextInnovation) {
                throw new IllegalArgumentException("genotype " + genotype.id()
                        + " does not belong to this pool: a link has innovation " + link.innovation()
                        + ", but the pool's next innovation is "
                        + nextInnovation);
            }
        }
    }

    /** Takes an innovation number for a new node or link; both use the same counter. */
    public long takeInnovation() {
        return nextInnovation++;
    }

    /** Takes an id for a new genotype. */
    public long takeGenotypeId() {
        return nextGenotypeId++;
    }

    /** The order of all neurons of the population. */
    public Archetype archetype() {
        return archetype;
    }

    /**
     * State of a pool between two reproductions.
     *
     * @param nextInnovation the next innovation number that will be used
     * @param nextGenotypeId the next genotype id that will be used
     * @param archetype the order of all neurons
     */
    public record State(long nextInnovation, long nextGenotypeId, Archetype.State archetype) {
        /**
         * A checked state.
         *
         * @throws IllegalArgumentException if the next innovation number is negative: those belong to inputs and
         *     outputs
         * @throws NullPointerException if the archetype is missing
         */
        public State {
            if (nextInnovation < 0) {
                throw new IllegalArgumentException("nextInnovation must not be negative, is " + nextInnovation);
            }
            Objects.requireNonNull(archetype, "archetype");
        }

        /**
         * Checks that a population can belong to a pool in this state, which may come from a file.
         *
         * @throws IllegalArgumentException if a counter is about to overflow, the archetype is not a valid order of
         *     neurons, or a genotype has neurons or links unknown to the pool, neurons in another order, or an id that
         *     the pool would give out again; the message says which
         */
        public void requireOwn(Collection<Genotype> population) {
            requireNoOverflow("nextInnovation", nextInnovation);
            requireNoOverflow("nextGenotypeId", nextGenotypeId);
            archetype.requireOrder();
            archetype.entries().forEach(entry -> requireTaken("archetype: a neuron", entry.innovation()));
            GenePool pool = resume(this);
            Set<Long> ids = new HashSet<>();
            for (Genotype genotype : population) {
                pool.requireOwn(genotype);
                archetype.requireSameOrder(genotype);
                if (genotype.id() >= nextGenotypeId) {
                    throw new IllegalArgumentException(
                            "nextGenotypeId is " + nextGenotypeId + ", but there is a genotype " + genotype.id());
                }
                if (!ids.add(genotype.id())) {
                    throw new IllegalArgumentException("two genotypes have the id " + genotype.id());
                }
            }
        }

        private static void requireNoOverflow(String counter, long value) {
            if (value > MAX_COUNTER) {
                throw new IllegalArgumentException(counter + " must be at most " + MAX_COUNTER + ", is " + value);
            }
        }

        private void requireTaken(String what, long innovation) {
            if (innovation >= nextInnovation) {
                throw new IllegalArgumentException(
                        what + " has innovation " + innovation + ", but nextInnovation is " + nextInnovation);
            }
        }
    }
}
