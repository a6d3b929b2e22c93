package mmneat.mspacman;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The three versions of the task that the paper compares: the two parts of the game, to eat pills among threats and to
 * eat edible ghosts, happen at the same time, in turn, or in separate games. Section 3 of the paper defines the
 * versions for any domain.
 */
public enum TaskVersion {
    /** Threats and edible ghosts at the same time: one full game per trial. */
    BLENDED,
    /** Ghosts stay in the lair while others are edible: one full game per trial. */
    INTERLEAVED,
    /** A game of eating pills among threats, and four games of eating ghosts, per trial. */
    ISOLATED;

    /** The name in commands, folder names and titles: {@code blended}, {@code interleaved} or {@code isolated}. */
    public String label() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** All labels, in the paper's order. */
    public static List<String> labels() {
        return Stream.of(values()).map(TaskVersion::label).toList();
    }

    /** The version with exactly this label. */
    public static Optional<TaskVersion> labelled(String label) {
        return Stream.of(values())
                .filter(version -> version.label().equals(label))
                .findFirst();
    }
}
