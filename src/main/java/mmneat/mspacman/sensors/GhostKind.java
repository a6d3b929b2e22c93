package mmneat.mspacman.sensors;

/** The two kinds of ghosts outside the lair. */
enum GhostKind {
    THREAT("Threat"),
    EDIBLE("Edible");

    private final String label;

    GhostKind(String label) {
        this.label = label;
    }

    /** The original's word for this kind in sensor labels. */
    String label() {
        return label;
    }
}
