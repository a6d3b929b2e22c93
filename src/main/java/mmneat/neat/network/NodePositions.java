package mmneat.neat.network;

import java.util.List;
import mmneat.neat.NodeGene;

/** Positions of nodes by innovation: a hash table of primitives with open addressing, filled once. */
final class NodePositions {

    private static final long FIBONACCI = 0x9E3779B97F4A7C15L;

    private final long[] innovations;
    /** Position + 1; 0 where the table is empty. */
    private final int[] entries;

    private final int shift;

    NodePositions(List<NodeGene> nodes) {
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

    /** Position of a node that is in the table. */
    int of(long innovation) {
        return entries[placeOf(innovation)] - 1;
    }

    private int placeOf(long innovation) {
        int place = (int) (innovation * FIBONACCI >>> shift);
        while (entries[place] != 0 && innovations[place] != innovation) {
            place = (place + 1) & (entries.length - 1);
        }
        return place;
    }
}
