package mmneat.mspacman.modules;

import java.util.List;

/** Names of classes of the original, which was published under two packages. */
public final class OriginalClassName {

    private static final List<String> PACKAGES = List.of("edu.southwestern.", "edu.utexas.cs.nn.");

    private OriginalClassName() {}

    /** Returns the name without its package if that is one of the original's; any other name unchanged. */
    public static String simple(String name) {
        return PACKAGES.stream().anyMatch(name::startsWith) ? name.substring(name.lastIndexOf('.') + 1) : name;
    }
}
