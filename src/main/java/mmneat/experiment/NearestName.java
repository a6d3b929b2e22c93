package mmneat.experiment;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Optional;

/** Finds the known name that is nearest to a mistyped one. */
public final class NearestName {

    private NearestName() {}

    /**
     * The known name with the smallest edit distance to {@code typed}, upper and lower case being the same.
     *
     * @return empty if no name is near, that is, within a third of the letters or two of them (one in short names)
     */
    public static Optional<String> to(String typed, Collection<String> known) {
        return known.stream()
                .filter(name -> editDistance(typed, name) <= tolerance(Math.max(typed.length(), name.length())))
                .min(Comparator.comparingInt((String name) -> editDistance(typed, name))
                        .thenComparing(Comparator.naturalOrder()));
    }

    /** " (did you mean 'NAME'?)", or nothing if no name is near: to be appended to an error message. */
    public static String suggestion(String typed, Collection<String> known) {
        return to(typed, known).map(name -> " (did you mean '" + name + "'?)").orElse("");
    }

    /** Two letters swapped are a distance of two, the commonest slip. Names of one letter are near to none. */
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
