package mmneat.nsga2;

/**
 * Pareto dominance of score vectors, all objectives maximised.
 *
 * <p>Source: Deb et al. 2002, section III; spec/evolution.md, section 2.1.
 */
public final class Dominance {

    private Dominance() {}

    /**
     * Whether {@code a} is at least as good as {@code b} in every objective and better in one. Equal vectors do not dominate
     * each other.
     */
    public static boolean dominates(double[] a, double[] b) {
        boolean better = false;
        for (int objective = 0; objective < a.length; objective++) {
            if (a[objective] < b[objective]) {
                return false;
            }
            better |= a[objective] > b[objective];
        }
        return better;
    }
}
