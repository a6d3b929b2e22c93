package mmneat.analysis.results;

import java.util.Locale;

/** Names of methods and versions of the task in headings and tables. */
public final class MethodName {

    private MethodName() {}

    /** The paper's name: MM(D) for MMD, MM(R) for MMR, otherwise the same. */
    public static String paper(String method) {
        return method.equals("MMD") ? "MM(D)" : method.equals("MMR") ? "MM(R)" : method;
    }

    /** A version of the task as a heading, or an empty text for a task of the user's own. */
    public static String title(String version) {
        return version.isEmpty()
                ? ""
                : version.substring(0, 1).toUpperCase(Locale.ROOT) + version.substring(1) + " task";
    }
}
