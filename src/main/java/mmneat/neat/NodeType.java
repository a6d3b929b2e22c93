package mmneat.neat;

/** The kind of a neuron: input, hidden or output. */
public enum NodeType {
    /** Gets a value from outside; no link leads into it. */
    INPUT,
    /** Made by splicing a neuron into a link. */
    HIDDEN,
    /** A policy neuron or preference neuron of an output module. */
    OUTPUT;

    /** The original's code: 0 input, 1 hidden, 2 output. */
    public int code() {
        return ordinal();
    }

    /**
     * The type with the original's code.
     *
     * @throws IllegalArgumentException if no type has this code
     */
    public static NodeType ofCode(int code) {
        return switch (code) {
            case 0 -> INPUT;
            case 1 -> HIDDEN;
            case 2 -> OUTPUT;
            default -> throw new IllegalArgumentException("node type must be 0, 1 or 2, is " + code);
        };
    }
}
