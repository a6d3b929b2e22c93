package mmneat.analysis.replay;

import java.awt.Color;
import java.util.List;
import java.util.stream.Collectors;

/**
 * One colour per module, in pages and pictures; further modules begin again. Colour-blind readers can tell them apart, and by
 * brightness they can be told apart in grey. Blue is left to the walls, the edible ghosts and the exciting signals, red to the
 * inhibiting ones.
 */
final class ModuleColours {

    private static final List<String> COLOURS =
            List.of("#ffb52e", "#a070ff", "#2fd0a5", "#f0529c", "#cfe86a", "#ff7a2e", "#8adcff", "#c9d2f0");

    private ModuleColours() {}

    static Color of(int module) {
        return Color.decode(COLOURS.get(module % COLOURS.size()));
    }

    /** All of them as a JSON array, for pages. */
    static String json() {
        return COLOURS.stream().map(colour -> '"' + colour + '"').collect(Collectors.joining(", ", "[", "]"));
    }
}
