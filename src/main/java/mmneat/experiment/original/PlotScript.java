package mmneat.experiment.original;

import java.util.ArrayList;
import java.util.List;

/** A builder of gnuplot scripts. */
final class PlotScript {

    private final StringBuilder text = new StringBuilder();

    /** Creates a script that starts with these lines. */
    PlotScript(String... header) {
        for (String line : header) {
            line(line);
        }
    }

    /**
     * One curve.
     *
     * @param file path of the data file for gnuplot
     * @param column column of the values; generations are in the first column, which is column 1
     * @param title its title in the key
     */
    record Curve(String file, int column, String title) {}

    /** Returns curves of the minimum, mean and maximum. */
    static List<Curve> spread(String file, int minColumn, int meanColumn, int maxColumn) {
        return List.of(
                new Curve(file, minColumn, "MIN"),
                new Curve(file, meanColumn, "AVG"),
                new Curve(file, maxColumn, "MAX"));
    }

    /** Adds a line. */
    PlotScript line(String line) {
        text.append(line).append('\n');
        return this;
    }

    /** Adds a picture, after which gnuplot waits for a key press. */
    PlotScript picture(String title, List<Curve> curves) {
        line("set title \"" + title + "\"");
        line("plot \\");
        List<String> plotted = new ArrayList<>();
        for (Curve curve : curves) {
            plotted.add("\"" + curve.file + "\" u 1:" + curve.column + " t \"" + curve.title + "\"");
        }
        line(String.join(", \\\n", plotted));
        line("");
        return line("pause -1");
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
