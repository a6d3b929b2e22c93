package mmneat.experiment;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;

/** Finds the known name that is nearest to a mistyped one. */
public final class NearestName {

    private NearestName() {}

    /**
     * Returns the known name with the smallest edit distance to {@code typed}, ignoring case.
     *
     * @return empty if no known name is near. With n the length of the longer one of the two names, a name is near at
     *     an edit distance of at most max(2, n / 3); of at most 1 if n is 2 or 3; and only at 0 if n is 1
     */
    public static Optional<String> to(String typed, Collection<String> known) {
        return known.stream()
                .filter(name -> editDistance(typed, name) <= tolerance(Math.max(typed.length(), name.length())))
                .min(Comparator.comparingInt((String name) -> editDistance(typed, name))
                        .thenComparing(Comparator.naturalOrder()));
    }

    /** Returns " (did you mean 'NAME'?)" to append to an error message; the empty text if no name is near. */
    public static String suggestion(String typed, Collection<String> known) {
        return to(typed, known).map(name -> " (did you mean '" + name + "'?)").orElse("");
    }

    /** Swapping two letters, the most common slip, is a distance of two. No name is near to a name of one letter. */
    private static int tolerance(int length) {
        return length <= 1 ? 0 : length <= 3 ? 1 : Math.max(2, length / 3);
    }

    /** Levenshtein's distance: insertions, deletions and replacements of a letter, row by row. */
    private static int editDistance(String first, String second) {
        String a = first.toLowerCase(Locale.ROOT);
        String b = second.toLowerCase(Locale.ROOT);
        int[] previous = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            previous[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int[] row = new int[b.length() + 1];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int replaced = previous[j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                row[j] = Math.min(replaced, 1 + Math.min(previous[j], row[j - 1]));
            }
            previous = row;
        }
        return previous[b.length()];
    }
}
