package mmneat.contest.entry;

import mmneat.neat.Thrown;
import org.jspecify.annotations.Nullable;

/** Explains errors of entries that use classes or members of another version of the simulator. */
public final class MissingMember {

    private MissingMember() {}

    /**
     * Returns an explanation to append to a message: release 6.2 of the competition's simulator, which this program
     * contains, never had the class, method or field that an entry uses. Empty if the failure has another cause.
     */
    public static String explanation(@Nullable Throwable failure) {
        if (failure == null) {
            return "";
        }
        for (Throwable cause : new Thrown(failure).causes()) {
            if (isOfTheSimulator(cause)) {
                return "; release 6.2 of the competition has no such "
                        + (cause instanceof NoClassDefFoundError ? "class" : "member")
                        + ", so the entry was written for another version of the simulator";
            }
        }
        return "";
    }

    private static boolean isOfTheSimulator(Throwable cause) {
        String missing = new Thrown(cause).message().replace('/', '.');
        if (cause instanceof NoClassDefFoundError) {
            return missing.startsWith("pacman.") && !missing.startsWith("pacman.entries.");
        }
        // For a field, Java 17 reports only the name.
        return cause instanceof NoSuchMethodError && missing.contains("pacman.")
                || cause instanceof NoSuchFieldError && (missing.contains("pacman.") || !missing.contains("."));
    }
}
