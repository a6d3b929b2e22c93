package mmneat.experiment.original;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import mmneat.evolution.SampleStatistics;
import mmneat.experiment.store.DoubleText;
import mmneat.experiment.store.RunLayout;

/**
 * A log with one row per generation: minimum, mean, maximum and standard deviation of every property of a population.
 *
 * <p>Source: docs/specification/evolution.md, sections 5.2 and 5.3.
 *
 * @param name name of the population, such as {@code parents}
 * @param labels names of the properties
 */
record PopulationLog(String name, List<String> labels) {

    /** Name of the log's file. */
    String file(String prefix) {
        return RunLayout.log(prefix, name);
    }

    /** Name of the log's gnuplot script. */
    String plotFile(String prefix) {
        return RunLayout.plot(prefix, name);
    }

    /**
     * The row of a generation.
     *
     * @param population the properties of each individual
     */
    String row(int generation, List<double[]> population) {
        StringBuilder row = new StringBuilder().append(generation).append('\t');
        for (int property = 0; property < labels.size(); property++) {
            int column = property;
            SampleStatistics statistics = SampleStatistics.of(population.stream()
                    .mapToDouble(properties -> properties[column])
                    .toArray());
            row.append(tabbed(statistics.min(), statistics.mean(), statistics.max(), statistics.deviation()));
        }
        return row.append('\n').toString();
    }

    /** The gnuplot script that shows the log. */
    String plotScript(String prefix) {
        PlotScript script = new PlotScript("set style data lines", "set xlabel \"Generation\"", "");
        IntStream.range(0, labels.size()).forEach(property -> {
            int column = RunLayout.firstColumn(property);
            script.picture(
                            prefix + name + " " + labels.get(property),
                            PlotScript.spread(file(prefix), column, column + 1, column + 2))
                    .line("");
        });
        return script.toString();
    }

    /** Returns the numbers, each followed by a tab. */
    static String tabbed(double... values) {
        StringBuilder text = new StringBuilder();
        Arrays.stream(values).forEach(value -> text.append(DoubleText.of(value)).append('\t'));
        return text.toString();
    }
}
