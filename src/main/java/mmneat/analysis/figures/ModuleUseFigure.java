package mmneat.analysis.figures;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.PublishedResults;
import mmneat.analysis.results.RunResult;

/** The paper's Figures 5b, 7b and 8b: each champion's average score against the share of its most-used module. */
public final class ModuleUseFigure {

    private ModuleUseFigure() {}

    /**
     * Draws one panel per experiment that has an evaluated run.
     *
     * @param version the version of the task; empty for a task of the user's own
     * @param all the experiments; all must be of this version
     * @return empty if no experiment has an evaluated run
     */
    public static Optional<Figure> of(String version, List<Experiment> all, PublishedResults paper) {
        List<Experiment> experiments = all.stream()
                .filter(experiment -> experiment.runs().stream().anyMatch(RunResult::isComparable))
                .toList();
        if (experiments.isEmpty()) {
            return Optional.empty();
        }
        List<Panel> panels = new ArrayList<>();
        double low = Double.POSITIVE_INFINITY;
        double high = 0;
        List<Swatch> ours = new ArrayList<>();
        List<Swatch> published = new ArrayList<>();
        for (int i = 0; i < experiments.size(); i++) {
            Experiment experiment = experiments.get(i);
            MethodStyle style = MethodStyle.of(all, all.indexOf(experiment));
            Panel panel = new Panel(experiment.label(), "Champion's average score", "Most-used module, % of steps");
            List<PublishedResults.Champion> champions = paper.champions(experiment.version(), experiment.paperMethod());
            double[] theirs = champions.stream()
                    .mapToDouble(PublishedResults.Champion::averageScore)
                    .toArray();
            if (theirs.length > 0) {
                published.add(new Swatch.Point(style.marker(), MethodStyle.PAPER));
                double[] shares = champions.stream()
                        .mapToDouble(PublishedResults.Champion::mostUsedModulePercent)
                        .toArray();
                panel.points(theirs, shares, new MethodStyle(MethodStyle.PAPER, style.dash(), style.marker()));
            }
            double[] scores = experiment.championScores(true);
            double[] shares = experiment.runs().stream()
                    .filter(RunResult::isComparable)
                    .mapToDouble(run -> run.evaluation().orElseThrow().mostUsedModulePercent())
                    .toArray();
            panel.points(scores, shares, style);
            ours.add(new Swatch.Point(style.marker(), style.color()));
            low = Stream.of(scores, theirs).flatMapToDouble(Arrays::stream).reduce(low, Math::min);
            high = Stream.of(scores, theirs).flatMapToDouble(Arrays::stream).reduce(high, Math::max);
            panels.add(panel);
        }
        double margin = 0.05 * Math.max(1, high - low);
        for (Panel panel : panels) {
            panel.range(low - margin, high + margin, 0, 105);
        }
        List<LegendEntry> legend = published.isEmpty()
                ? List.of()
                : List.of(new LegendEntry("ours", ours), new LegendEntry("the paper's", published));
        return Optional.of(Figure.grid(
                LearningCurveFigure.prefix(version) + "modules",
                "Each champion's average score after evolution against the share of time steps in which its most-used"
                        + " module decided" + LearningCurveFigure.paperNote(!published.isEmpty()) + ".",
                panels,
                legend));
    }
}
