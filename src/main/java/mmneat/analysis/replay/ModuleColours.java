package mmneat.analysis.replay;

import java.awt.Color;
import java.util.List;
import java.util.stream.Collectors;

/**
 * The colours of modules in pages and pictures; module 8 has the colour of module 0 again.
 *
 * <p>Every two of them differ for readers with normal colour vision and for colour-blind readers: {@code
 * ModuleColoursTest} computes the distances. None is close to the blue of walls, edible ghosts and excitatory signals.
 */
final class ModuleColours {

    private static final List<String> COLOURS =
            List.of("#ffb52e", "#a070ff", "#2fd0a5", "#f0c3ff", "#b44b0f", "#c3ff96", "#a55aa5", "#00785a");

    private ModuleColours() {}

    /** The number of different colours. */
    static int size() {
        return COLOURS.size();
    }

    /**
     * The colour of a module.
     *
     * @param module index of the module, from 0
     */
    static Color of(int module) {
        return Color.decode(COLOURS.get(module % COLOURS.size()));
    }

    /** All colours as a JSON array of strings such as {@code "#ffb52e"}, for pages. */
    static String json() {
        return COLOURS.stream().map(colour -> '"' + colour + '"').collect(Collectors.joining(", ", "[", "]"));
    }
}
