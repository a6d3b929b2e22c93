package mmneat.neat;

import java.util.List;

/** Positions of nodes in a list, by innovation: a hash table of primitives with open addressing, filled once. */
public final class NodePositions {

    private static final long FIBONACCI = 0x9E3779B97F4A7C15L;

    private final long[] innovations;
    /** Position + 1; 0 where the table is empty. */
    private final int[] entries;

    private final int shift;

    /** The positions in this list, whose innovations must differ; later changes of the list have no effect. */
    public NodePositions(List<NodeGene> nodes) {
        int bits = 33 - Integer.numberOfLeadingZeros(nodes.size());
        innovations = new long[1 << bits];
        entries = new int[1 << bits];
        shift = 64 - bits;
        for (int i = 0; i < nodes.size(); i++) {
            long innovation = nodes.get(i).innovation();
            int place = placeOf(innovation);
            innovations[place] = innovation;
            entries[place] = i + 1;
        }
    }

    /** Position of a node; -1 if the list lacks it. */
    public int of(long innovation) {
        return entries[placeOf(innovation)] - 1;
    }

    /** Whether the list has a node of this innovation. */
    public boolean contains(long innovation) {
        return of(innovation) >= 0;
    }

    private int placeOf(long innovation) {
        int place = (int) (innovation * FIBONACCI >>> shift);
        while (entries[place] != 0 && innovations[place] != innovation) {
            place = (place + 1) & (entries.length - 1);
        }
        return place;
    }
}
