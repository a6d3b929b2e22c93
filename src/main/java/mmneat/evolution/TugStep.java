package mmneat.evolution;

/**
 * The result of TUG in one generation, computed after the parents were evaluated.
 *
 * @param after the state with which children are made and survivors chosen
 * @param performance p: the population's performance in each objective
 * @param targets t: the target of each objective ({@link TugSettings.Statistics#target})
 */
public record TugStep(TugState after, double[] performance, double[] targets) {

    /** A step with copies of the arrays. */
    public TugStep {
        performance = performance.clone();
        targets = targets.clone();
    }

    /** The population's performance in each objective (a copy). */
    @Override
    public double[] performance() {
        return performance.clone();
    }

    /** The score towards which each goal moves (a copy). */
    @Override
    public double[] targets() {
        return targets.clone();
    }
}
