package mmneat.contest.entry;

/** Recognises what an entry misses because it was written for another version of the simulator. */
public final class MissingMember {

    private MissingMember() {}

    /**
     * An explanation to be appended to a message: that release 6.2 never had the class, method or field that an entry asks for.
     * Empty if something else is the matter.
     */
    public static String explanation(Throwable failure) {
        for (Throwable cause = failure; cause != null; cause = cause.getCause()) {
            if (isOfTheSimulator(cause)) {
                return "; release 6.2 of the competition never had this "
                        + (cause instanceof NoClassDefFoundError ? "class" : "member")
                        + ", the entry was written for another version of the simulator";
            }
        }
        return "";
    }

    private static boolean isOfTheSimulator(Throwable cause) {
        String missing = String.valueOf(cause.getMessage()).replace('/', '.');
        if (cause instanceof NoClassDefFoundError) {
            return missing.startsWith("pacman.") && !missing.startsWith("pacman.entries.");
        }
        // Of a field Java 17 tells the name alone.
        return cause instanceof NoSuchMethodError && missing.contains("pacman.")
                || cause instanceof NoSuchFieldError && (missing.contains("pacman.") || !missing.contains("."));
    }
}
