package mmneat.neat.network;

/**
 * Computes neurons of one network for one state or two states side by side: the loops in which a game spends its time.
 *
 * <p>A state is given by its activations as {@link NetworkState} keeps them, and slots in an order that has sources
 * before targets.
 */
final class Propagation {

    /*
     * A neuron's sum and its tanh are one long chain of dependent instructions, and a neuron of a higher level waits
     * for those below. The processor looks some 250 instructions ahead for something else to do. Other states are
     * something else: they depend on each other in nothing, and links are read once for all of them. And what is not in
     * the loop lets it look further: exact loops call nothing, so that the compiler keeps their arrays in registers;
     * the few arguments for which the fast tangent has to call the library end the loop (after leaving their sums
     * behind), and it is entered again behind them.
     *
     * The forms for one and two states are written out: in a loop over states their sums would not be registers. A form
     * for two also serves one state, which then is both.
     */

    private Propagation() {}

    /** The sum of one slot: the order of the links, recurrent ones first, is what makes it exact. */
    static double sum(Network network, double[] a, int slot) {
        int[] sources = network.linkSource;
        double[] weights = network.linkWeight;
        double sum = 0;
        int end = network.linkStart[slot + 1];
        for (int link = network.linkStart[slot]; link < end; link++) {
            sum += a[sources[link]] * weights[link];
        }
        return sum;
    }

    /** Computes the neurons of slots {@code [from, to)} to the last bit; their functions are tanh. */
    static void exactly(Network network, double[] a, int from, int to) {
        for (int slot = from; (slot = whileInTable(network, a, slot, to)) < to; slot++) {
            a[slot] = Tanh.of(a[slot]);
        }
    }

    /** Computes the same neurons for two states. */
    static void exactly(Network network, double[] a, double[] b, int from, int to) {
        for (int slot = from; (slot = whileInTable(network, a, b, slot, to)) < to; slot++) {
            a[slot] = Tanh.of(a[slot]);
            b[slot] = Tanh.of(b[slot]);
        }
    }

    /** Stops at a slot whose sum is not in the table, and leaves the sum there. */
    private static int whileInTable(Network network, double[] a, int from, int to) {
        int[] start = network.linkStart;
        int[] sources = network.linkSource;
        double[] weights = network.linkWeight;
        int link = start[from];
        for (int slot = from; slot < to; slot++) {
            double sum = 0;
            int end = start[slot + 1];
            for (; link < end; link++) {
                sum += a[sources[link]] * weights[link];
            }
            if (!Tanh.isInTable(sum)) {
                a[slot] = sum;
                return slot;
            }
            a[slot] = Tanh.inTable(sum);
        }
        return to;
    }

    private static int whileInTable(Network network, double[] a, double[] b, int from, int to) {
        int[] start = network.linkStart;
        int[] sources = network.linkSource;
        double[] weights = network.linkWeight;
        int link = start[from];
        for (int slot = from; slot < to; slot++) {
            double sumA = 0;
            double sumB = 0;
            int end = start[slot + 1];
            for (; link < end; link++) {
                int source = sources[link];
                double weight = weights[link];
                sumA += a[source] * weight;
                sumB += b[source] * weight;
            }
            if (!(Tanh.isInTable(sumA) && Tanh.isInTable(sumB))) {
                a[slot] = sumA;
                b[slot] = sumB;
                return slot;
            }
            a[slot] = Tanh.inTable(sumA);
            b[slot] = Tanh.inTable(sumB);
        }
        return to;
    }

    /** Computes the neurons of slots {@code [from, to)} up to the network's margin; their functions are tanh. */
    static void roughly(Network network, double[] a, double[] b, int from, int to) {
        int[] start = network.linkStart;
        int[] sources = network.linkSource;
        double[] weights = network.linkWeight;
        int link = start[from];
        for (int slot = from; slot < to; slot++) {
            double sumA = 0;
            double sumB = 0;
            int end = start[slot + 1];
            for (; link < end; link++) {
                int source = sources[link];
                double weight = weights[link];
                sumA += a[source] * weight;
                sumB += b[source] * weight;
            }
            a[slot] = RoughTanh.of(sumA);
            b[slot] = RoughTanh.of(sumB);
        }
    }

    /** Writes the sums of one slot for two states into elements {@code i} of one array and {@code j} of another. */
    static void sums(Network network, double[] a, double[] b, int slot, double[] intoA, int i, double[] intoB, int j) {
        int[] sources = network.linkSource;
        double[] weights = network.linkWeight;
        double sumA = 0;
        double sumB = 0;
        int end = network.linkStart[slot + 1];
        for (int link = network.linkStart[slot]; link < end; link++) {
            int source = sources[link];
            double weight = weights[link];
            sumA += a[source] * weight;
            sumB += b[source] * weight;
        }
        intoA[i] = sumA;
        intoB[j] = sumB;
    }
}
