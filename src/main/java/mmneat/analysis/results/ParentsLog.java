package mmneat.analysis.results;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import mmneat.experiment.TextFiles;
import mmneat.experiment.store.RunLayout;

/**
 * Finder of the column with the champion's score in a log of parents. The log may be that of a run of this program, of
 * the original, or of a later version of MM-NEAT, which have different columns.
 */
final class ParentsLog {

    private static final Pattern TITLE = Pattern.compile("set title \".* Game ?Score\"");
    private static final Pattern LARGEST = Pattern.compile(".* u 1:(\\d+) t \"MAX\".*");

    private ParentsLog() {}

    /**
     * The column of the champion's score, counted from 1: the gnuplot script beside the log names it, because other
     * objectives and scores move it.
     */
    static int championScoreColumn(Path log) {
        Path script = log.resolveSibling(log.getFileName().toString().replaceFirst("\\.txt$", ".plot"));
        if (!Files.exists(script)) {
            return RunLayout.championScoreColumnOfLog();
        }
        boolean found = false;
        for (String line : TextFiles.lines(script)) {
            found |= TITLE.matcher(line).matches();
            Matcher largest = LARGEST.matcher(line);
            if (found && largest.matches()) {
                return Integer.parseInt(largest.group(1));
            }
        }
        return RunLayout.championScoreColumnOfLog();
    }
}
