package mmneat.nsga2;

/**
 * A child and where it comes from.
 *
 * @param genotype the child
 * @param parent the parent chosen first, as an index into the parents
 * @param mate the parent chosen second, as an index; {@link #NO_MATE} if the child is the mutated copy of one parent
 * @param hasMateStructure whether the child has the structure of the mate rather than of the parent
 */
public record Child<G>(G genotype, int parent, int mate, boolean hasMateStructure) {

    /** Instead of a mate's index. */
    public static final int NO_MATE = -1;

    public boolean isCrossed() {
        return mate != NO_MATE;
    }
}
