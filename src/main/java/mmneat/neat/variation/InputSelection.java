package mmneat.neat.variation;

/**
 * The number of inputs to which a policy neuron of a new network or module is connected.
 *
 * @param isSelective whether only some randomly chosen inputs are connected (feature selective start, {@code fs})
 * @param linksPerOutput number of inputs, if selective ({@code fsLinksPerOut})
 */
public record InputSelection(boolean isSelective, int linksPerOutput) {

    /** Every input is connected: the published experiments. */
    public static final InputSelection ALL = new InputSelection(false, 1);

    /**
     * A checked selection.
     *
     * @throws IllegalArgumentException if {@code linksPerOutput} is less than 1
     */
    public InputSelection {
        if (linksPerOutput < 1) {
            throw new IllegalArgumentException("fsLinksPerOut must be at least 1, is " + linksPerOutput);
        }
    }

    /** Number of links into one policy neuron of a network with this number of inputs. */
    int linksInto(int inputs) {
        return isSelective ? linksPerOutput : inputs;
    }
}
