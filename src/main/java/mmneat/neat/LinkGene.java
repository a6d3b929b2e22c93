package mmneat.neat;

/**
 * One connection of a genotype.
 *
 * @param innovation innovation number; links with equal numbers have equal end points
 * @param source innovation of the neuron that the link comes from
 * @param target innovation of the neuron that the link leads to, never an input
 * @param weight any double, unbounded
 * @param active whether the link exists in the network. Splicing a neuron into a link makes the link inactive; the next
 *     copy of the genotype leaves inactive links out ({@link GenotypeDraft#copyOf})
 * @param recurrent whether the target was at or before the source in node order when the link was made; information
 *     only
 * @param frozen whether weight mutation and splicing skip this link
 */
public record LinkGene(
        long innovation, long source, long target, double weight, boolean active, boolean recurrent, boolean frozen) {

    /** An active link that is not frozen. */
    public LinkGene(long innovation, long source, long target, double weight, boolean recurrent) {
        this(innovation, source, target, weight, true, recurrent, false);
    }

    /** This gene with another weight. */
    public LinkGene withWeight(double value) {
        return new LinkGene(innovation, source, target, value, active, recurrent, frozen);
    }

    /** This gene with another innovation number. */
    public LinkGene withInnovation(long value) {
        return value == innovation ? this : new LinkGene(value, source, target, weight, active, recurrent, frozen);
    }

    /** This gene between other neurons, with the innovation number of that structure. */
    public LinkGene moved(long newInnovation, long newSource, long newTarget) {
        return new LinkGene(newInnovation, newSource, newTarget, weight, active, recurrent, frozen);
    }

    /** This gene, active or not. */
    public LinkGene withActive(boolean value) {
        return value == active ? this : new LinkGene(innovation, source, target, weight, value, recurrent, frozen);
    }

    /** This gene, frozen or not. */
    public LinkGene withFrozen(boolean value) {
        return value == frozen ? this : new LinkGene(innovation, source, target, weight, active, recurrent, value);
    }
}
