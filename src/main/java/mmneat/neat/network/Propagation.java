package mmneat.neat.network;

/**
 * Computes neurons of one network for one, two or three states side by side: the loops in which a game spends its time.
 *
 * <p>A state is given by its activations as {@link NetworkState} keeps them, and slots in an order that has sources before
 * targets.
 */
final class Propagation {

    /*
     * A neuron's sum and its tanh are one long chain of dependent instructions, and a neuron of a higher level waits for those
     * below. The processor looks some 250 instructions ahead for something else to do. Other states are something else: they
     * depend on each other in nothing, and links are read once for all of them. And what is not in the loop lets it look
     * further: exact loops call nothing, so that the compiler keeps their arrays in registers; the few arguments for which
     * the fast tangent has to call the library end the loop (after leaving their sums behind), and it is entered again
     * behind them.
     *
     * The forms for one, two and three states are written out: in a loop over states their sums would not be registers.
     *
     * For a single state what is independent are neurons: they come in fours that do not depend on each other (Fours), as far as
     * there are such. The compiler would compute their four tangents one after the other, too long a way for the processor to
     * look ahead. It keeps the order of what is written into arrays, though: so each piece of a tangent is written into an array
     * that nobody reads, for all four neurons before the next piece. Written out too: in loops over the four, values are stored and
     * read back.
     */

    /** Number of neurons that are computed side by side in one state. */
    static final int FOUR = 4;

    /** Length of the array that {@link #exactlyInFours} writes what nobody reads into. */
    static final int PIECES = 5 * FOUR;

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

    /** Computes the same neurons for three states. */
    static void exactly(Network network, double[] a, double[] b, double[] c, int from, int to) {
        for (int slot = from; (slot = whileInTable(network, a, b, c, slot, to)) < to; slot++) {
            a[slot] = Tanh.of(a[slot]);
            b[slot] = Tanh.of(b[slot]);
            c[slot] = Tanh.of(c[slot]);
        }
    }

    /**
     * The same as {@link #exactly(Network, double[], int, int)} for neurons of which every four do not depend on each other.
     *
     * @param pieces of {@link #PIECES} numbers; its content means nothing before or after
     */
    static void exactlyInFours(Network network, double[] a, double[] pieces, int from, int to) {
        for (int slot = from; (slot = foursInTable(network, a, pieces, slot, to)) < to; slot += FOUR) {
            for (int i = slot; i < slot + FOUR; i++) {
                a[i] = Tanh.of(a[i]);
            }
        }
    }

    /** Stops at four slots of which a sum is not in the table, and leaves the sums there. */
    private static int foursInTable(Network network, double[] a, double[] pieces, int from, int to) {
        int[] start = network.linkStart;
        int[] sources = network.linkSource;
        double[] weights = network.linkWeight;
        int link = start[from];
        for (int slot = from; slot < to; slot += FOUR) {
            for (int i = slot; i < slot + FOUR; i++) {
                double sum = 0;
                int end = start[i + 1];
                for (; link < end; link++) {
                    sum += a[sources[link]] * weights[link];
                }
                a[i] = sum;
            }
            double x0 = a[slot];
            double x1 = a[slot + 1];
            double x2 = a[slot + 2];
            double x3 = a[slot + 3];
            double reduced0 = pieces[0] = Tanh.reduced(x0);
            double reduced1 = pieces[1] = Tanh.reduced(x1);
            double reduced2 = pieces[2] = Tanh.reduced(x2);
            double reduced3 = pieces[3] = Tanh.reduced(x3);
            if (!(Tanh.isInTable(x0, reduced0)
                    && Tanh.isInTable(x1, reduced1)
                    && Tanh.isInTable(x2, reduced2)
                    && Tanh.isInTable(x3, reduced3))) {
                return slot;
            }
            double terms0 = pieces[4] = Tanh.upperTerms(reduced0);
            double terms1 = pieces[5] = Tanh.upperTerms(reduced1);
            double terms2 = pieces[6] = Tanh.upperTerms(reduced2);
            double terms3 = pieces[7] = Tanh.upperTerms(reduced3);
            double series0 = pieces[8] = Tanh.series(reduced0, terms0);
            double series1 = pieces[9] = Tanh.series(reduced1, terms1);
            double series2 = pieces[10] = Tanh.series(reduced2, terms2);
            double series3 = pieces[11] = Tanh.series(reduced3, terms3);
            double rest0 = pieces[12] = Tanh.remainder(x0, reduced0, series0);
            double rest1 = pieces[13] = Tanh.remainder(x1, reduced1, series1);
            double rest2 = pieces[14] = Tanh.remainder(x2, reduced2, series2);
            double rest3 = pieces[15] = Tanh.remainder(x3, reduced3, series3);
            double q0 = pieces[16] = Tanh.shifted(x0, reduced0, rest0);
            double q1 = pieces[17] = Tanh.shifted(x1, reduced1, rest1);
            double q2 = pieces[18] = Tanh.shifted(x2, reduced2, rest2);
            double q3 = pieces[19] = Tanh.shifted(x3, reduced3, rest3);
            a[slot] = Tanh.result(x0, q0);
            a[slot + 1] = Tanh.result(x1, q1);
            a[slot + 2] = Tanh.result(x2, q2);
            a[slot + 3] = Tanh.result(x3, q3);
        }
        return to;
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

    private static int whileInTable(Network network, double[] a, double[] b, double[] c, int from, int to) {
        int[] start = network.linkStart;
        int[] sources = network.linkSource;
        double[] weights = network.linkWeight;
        int link = start[from];
        for (int slot = from; slot < to; slot++) {
            double sumA = 0;
            double sumB = 0;
            double sumC = 0;
            int end = start[slot + 1];
            for (; link < end; link++) {
                int source = sources[link];
                double weight = weights[link];
                sumA += a[source] * weight;
                sumB += b[source] * weight;
                sumC += c[source] * weight;
            }
            if (!(Tanh.isInTable(sumA) && Tanh.isInTable(sumB) && Tanh.isInTable(sumC))) {
                a[slot] = sumA;
                b[slot] = sumB;
                c[slot] = sumC;
                return slot;
            }
            a[slot] = Tanh.inTable(sumA);
            b[slot] = Tanh.inTable(sumB);
            c[slot] = Tanh.inTable(sumC);
        }
        return to;
    }

    /** Computes the neurons of slots {@code [from, to)} up to the network's margin; their functions are tanh. */
    static void roughly(Network network, double[] a, int from, int to) {
        for (int slot = from; slot < to; slot++) {
            a[slot] = RoughTanh.of(sum(network, a, slot));
        }
    }
}
