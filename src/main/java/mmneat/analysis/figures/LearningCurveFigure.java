package mmneat.analysis.figures;

import java.awt.BasicStroke;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.MethodName;
import mmneat.analysis.results.PublishedResults;
import mmneat.analysis.statistics.Numbers;
import mmneat.analysis.statistics.Sample;

/**
 * The paper's Figures 5a, 7a and 8a: for each generation, the median over the runs of the score of the generation's
 * champion.
 */
public final class LearningCurveFigure {

    private static final BasicStroke DASHED =
            new BasicStroke(1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {5, 3}, 0);
    private static final BasicStroke SOLID = new BasicStroke(2);

    private LearningCurveFigure() {}

    /**
     * Draws the medians of all experiments in one panel, as in the paper.
     *
     * @param version the version of the task, for the title; empty for a task of the user's own
     * @param experiments the experiments to draw; all must be of this version
     */
    public static Figure overview(String version, List<Experiment> experiments, PublishedResults paper) {
        Panel panel = new Panel(MethodName.title(version), "Generation", "Champion's score, median over runs");
        int last = lastGeneration(experiments);
        List<Swatch> published = new ArrayList<>();
        for (int i = 0; i < experiments.size(); i++) {
            double[] theirs = published(paper, experiments.get(i), last);
            if (theirs.length > 0) {
                BasicStroke stroke = MethodStyle.of(experiments, i).stroke(1.3f);
                panel.curve(theirs, MethodStyle.PAPER, stroke);
                published.add(new Swatch.Line(MethodStyle.PAPER, stroke));
            }
        }
        List<LegendEntry> legend = new ArrayList<>();
        for (int i = 0; i < experiments.size(); i++) {
            MethodStyle style = MethodStyle.of(experiments, i);
            double[] medians = quantiles(experiments.get(i), 0.5);
            String name = experiments.get(i).label();
            panel.curve(medians, style.color(), style.stroke(2.2f));
            panel.label(name, medians[medians.length - 1], style.color());
            legend.add(new LegendEntry(name, new Swatch.Line(style.color(), style.stroke(2.2f))));
        }
        if (!published.isEmpty()) {
            legend.add(new LegendEntry("the paper's", published));
        }
        panel.range(0, Math.max(1, last), bottom(panel.low(), panel.high()), ceiling(panel.high()));
        return Figure.single(
                LearningCurveFigure.prefix(version) + "medians",
                "Median over runs of the champion's score in each generation" + paperNote(!published.isEmpty()) + ".",
                panel,
                legend);
    }

    /**
     * Draws one panel per experiment: median and quartiles over the runs.
     *
     * @param version the version of the task; empty for a task of the user's own
     * @param experiments the experiments to draw; all must be of this version
     */
    public static Figure panels(String version, List<Experiment> experiments, PublishedResults paper) {
        int last = lastGeneration(experiments);
        boolean published = false;
        List<Panel> panels = new ArrayList<>();
        List<Swatch> medians = new ArrayList<>();
        List<Swatch> quartiles = new ArrayList<>();
        for (int i = 0; i < experiments.size(); i++) {
            Experiment experiment = experiments.get(i);
            MethodStyle style = MethodStyle.of(experiments, i);
            Panel panel = new Panel(
                    experiment.label() + ", "
                            + Numbers.counted(experiment.runs().size(), "run"),
                    "Generation",
                    "Champion's score");
            panel.band(quantiles(experiment, 0.25), quantiles(experiment, 0.75), style.areaColor());
            panel.curve(quantiles(experiment, 0.5), style.color(), SOLID);
            // On top of ours: where both agree, the paper's would be hidden.
            double[] theirs = published(paper, experiment, last);
            if (theirs.length > 0) {
                published = true;
                panel.curve(theirs, MethodStyle.PAPER_ON_AREA, DASHED);
            }
            medians.add(new Swatch.Line(style.color(), SOLID));
            quartiles.add(new Swatch.Area(style.areaColor()));
            panels.add(panel);
        }
        double high = panels.stream().mapToDouble(Panel::high).max().orElse(1);
        double low = panels.stream().mapToDouble(Panel::low).min().orElse(0);
        panels.forEach(panel -> panel.range(0, Math.max(1, last), bottom(low, high), ceiling(high)));
        List<LegendEntry> legend = new ArrayList<>(
                List.of(new LegendEntry("median over runs", medians), new LegendEntry("quartiles", quartiles)));
        if (published) {
            legend.add(new LegendEntry("the paper's median", new Swatch.Line(MethodStyle.PAPER_ON_AREA, DASHED)));
        }
        return Figure.grid(
                prefix(version) + "curves",
                "Champion's score in each generation: median and quartiles over runs" + paperNote(published) + ".",
                panels,
                legend);
    }

    static String prefix(String version) {
        return version.isEmpty() ? "" : version + "-";
    }

    static String paperNote(boolean published) {
        return published ? "; in grey the paper's (" + PublishedResults.SOURCE + ")" : "";
    }

    /** Zero, unless that would press all curves into the upper half. */
    private static double bottom(double low, double high) {
        return low > high / 2 ? 1000 * Math.floor(low / 1000) : Math.min(0, low);
    }

    /** The next thousand; for small scores the next number of two digits. */
    private static double ceiling(double value) {
        if (value > 1000) {
            return 1000 * Math.ceil(value / 1000);
        }
        double unit = value <= 0 ? 1 : Math.pow(10, Math.floor(Math.log10(value)));
        return unit / 10 * Math.ceil(10 * value / unit);
    }

    private static int lastGeneration(List<Experiment> experiments) {
        return experiments.stream().mapToInt(Experiment::generations).max().orElseThrow();
    }

    private static double[] quantiles(Experiment experiment, double probability) {
        return IntStream.rangeClosed(0, experiment.generations())
                .mapToDouble(g -> new Sample("", experiment.championScoresAt(g)).quantile(probability))
                .toArray();
    }

    private static double[] published(PublishedResults paper, Experiment experiment, int last) {
        double[] curve = paper.medianCurve(experiment.version(), experiment.paperMethod());
        return Arrays.copyOf(curve, Math.min(curve.length, last + 1));
    }
}
