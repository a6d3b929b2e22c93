package mmneat.analysis.figures;

import java.awt.BasicStroke;
import java.awt.Color;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.MethodName;
import mmneat.analysis.results.PublishedResults;
import mmneat.analysis.statistics.Numbers;
import mmneat.analysis.statistics.Sample;

/** The paper's Figures 5a, 7a and 8a: the median champion's score in each generation. */
public final class LearningCurveFigure {

    private static final BasicStroke DASHED =
            new BasicStroke(1.5f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {5, 3}, 0);
    private static final Color DARK = new Color(0x40, 0x44, 0x4d);

    private LearningCurveFigure() {}

    /** All medians in one panel, as in the paper. */
    public static Figure overview(String version, List<Experiment> experiments, PublishedResults paper) {
        Panel panel = new Panel(MethodName.title(version), "Generation", "Champion's score, median over runs");
        int last = lastGeneration(experiments);
        boolean published = false;
        for (int i = 0; i < experiments.size(); i++) {
            double[] theirs = published(paper, experiments.get(i), last);
            if (theirs.length > 0) {
                published = true;
                panel.curve(
                        theirs,
                        MethodStyle.PAPER,
                        MethodStyle.of(experiments, i).stroke(1.3f));
            }
        }
        double[] ends = new double[experiments.size()];
        List<String> names = names(experiments);
        List<Key> keys = new ArrayList<>();
        for (int i = 0; i < experiments.size(); i++) {
            MethodStyle style = MethodStyle.of(experiments, i);
            double[] medians = quantiles(experiments.get(i), 0.5);
            panel.curve(medians, style.color(), style.stroke(2.2f));
            ends[i] = medians[medians.length - 1];
            keys.add(new Key(names.get(i), Key.Sign.LINE, style.color(), style.stroke(2.2f)));
        }
        if (published) {
            keys.add(new Key("the paper's", Key.Sign.LINE, MethodStyle.PAPER, new BasicStroke(1.3f)));
        }
        double bottom = bottom(panel.low(), panel.high());
        int longest = names.stream().mapToInt(String::length).max().orElse(0);
        panel.range(0, Math.max(1, last) * (1.03 + 0.0125 * longest), bottom, ceiling(panel.high()));
        double[] places = apart(ends, (ceiling(panel.high()) - bottom) / 25);
        for (int i = 0; i < ends.length; i++) {
            Experiment experiment = experiments.get(i);
            panel.label(
                    names.get(i),
                    last + Math.max(1, last) * 0.012,
                    places[i],
                    MethodStyle.of(experiments, i).color());
        }
        return new Figure(
                LearningCurveFigure.prefix(version) + "medians",
                "Median over runs of the champion's score in each generation" + behind(published) + ".",
                List.of(panel),
                keys,
                1,
                780,
                460);
    }

    /** One panel per method: median and quartiles over the runs. */
    public static Figure panels(String version, List<Experiment> experiments, PublishedResults paper) {
        int last = lastGeneration(experiments);
        boolean published = false;
        List<Panel> panels = new ArrayList<>();
        for (int i = 0; i < experiments.size(); i++) {
            Experiment experiment = experiments.get(i);
            MethodStyle style = MethodStyle.of(experiments, i);
            Panel panel = new Panel(
                    experiment.label() + ", "
                            + Numbers.counted(experiment.runs().size(), "run"),
                    "Generation",
                    i % Figure.columns(experiments.size()) == 0 ? "Champion's score" : "");
            panel.band(quantiles(experiment, 0.25), quantiles(experiment, 0.75), style.wash());
            double[] theirs = published(paper, experiment, last);
            if (theirs.length > 0) {
                published = true;
                panel.curve(theirs, MethodStyle.PAPER, DASHED);
            }
            panel.curve(quantiles(experiment, 0.5), style.color(), new BasicStroke(2));
            panels.add(panel);
        }
        double high = panels.stream().mapToDouble(Panel::high).max().orElse(1);
        double low = panels.stream().mapToDouble(Panel::low).min().orElse(0);
        panels.forEach(panel -> panel.range(0, Math.max(1, last), bottom(low, high), ceiling(high)));
        List<Key> keys = new ArrayList<>(List.of(
                new Key("median over runs", Key.Sign.LINE, DARK, new BasicStroke(2)),
                new Key("quartiles", Key.Sign.AREA, new Color(0xd4, 0xd6, 0xda), null)));
        if (published) {
            keys.add(new Key("the paper's median", Key.Sign.LINE, MethodStyle.PAPER, DASHED));
        }
        return Figure.grid(
                prefix(version) + "curves",
                "Champion's score in each generation: median and quartiles over runs" + behind(published) + ".",
                panels,
                keys);
    }

    /** The labels beside the curves. */
    private static List<String> names(List<Experiment> experiments) {
        return experiments.stream().map(Experiment::label).toList();
    }

    static String prefix(String version) {
        return version.isEmpty() ? "" : version + "-";
    }

    static String behind(boolean published) {
        return published ? "; in grey the paper's (" + PublishedResults.SOURCE + ")" : "";
    }

    /** Places near the given ones, none closer to another than the gap. */
    private static double[] apart(double[] wanted, double gap) {
        double[] places = wanted.clone();
        Integer[] order = IntStream.range(0, wanted.length).boxed().toArray(Integer[]::new);
        Arrays.sort(order, Comparator.comparingDouble(i -> wanted[i]));
        for (int round = 0; round < 200; round++) {
            for (int k = 1; k < order.length; k++) {
                double missing = gap - (places[order[k]] - places[order[k - 1]]);
                if (missing > 0) {
                    places[order[k]] += missing / 2;
                    places[order[k - 1]] -= missing / 2;
                }
            }
        }
        return places;
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
