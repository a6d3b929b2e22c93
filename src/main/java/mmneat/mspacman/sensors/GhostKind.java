package mmneat.mspacman.sensors;

/** The two kinds of ghosts outside the lair. */
public enum GhostKind {
    /** A ghost that catches Ms. Pac-Man. */
    THREAT("Threat"),
    /** A ghost that Ms. Pac-Man can eat. */
    EDIBLE("Edible");

    private final String label;

    GhostKind(String label) {
        this.label = label;
    }

    /** The original's word for this kind in sensor labels. */
    public String label() {
        return label;
    }
}
