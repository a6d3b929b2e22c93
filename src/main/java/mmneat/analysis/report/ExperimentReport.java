package mmneat.analysis.report;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.stream.Collectors;
import mmneat.analysis.ExperimentComparison;
import mmneat.analysis.Page;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.ChampionLabels;
import mmneat.analysis.figures.Figure;
import mmneat.analysis.figures.LearningCurveFigure;
import mmneat.analysis.figures.ModuleUseFigure;
import mmneat.analysis.results.ChampionEvaluation;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.PublishedResults;
import mmneat.analysis.results.RunResult;
import mmneat.analysis.statistics.ComparisonReport;
import mmneat.analysis.statistics.Numbers;
import mmneat.analysis.statistics.TextTable;
import mmneat.experiment.store.RunLayout;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.neat.io.NetworkSvg;

/** The report of a set of experiments as one HTML file. Only the replays are separate files, to which it links. */
public final class ExperimentReport {

    /** Names of the parameters in the table of settings, in its order. */
    private static final List<String> SETTINGS = List.of(
            "task",
            "mu",
            "maxGens",
            "trials",
            "startingModes",
            "mmdRate",
            "multitaskModes",
            "pacmanMultitaskScheme",
            "crossoverRate",
            "netLinkRate",
            "netSpliceRate",
            "perLinkMutateRate",
            "edibleTime",
            "lairTime",
            "pacManLevelTimeLimit",
            "parallelEvaluations");

    /** Columns of the table of champions. */
    private static final int COLUMNS = 11;

    private final List<Experiment> experiments;
    /** One comparison per version of the task. */
    private final List<ExperimentComparison> comparisons;

    private final Optional<Path> jar;

    private final PublishedResults paper = PublishedResults.read();

    /**
     * A report.
     *
     * @param comparisons one per version of the task
     * @param jar the jar with the user's own classes that the runs' parameters name, such as a task or sensors. They
     *     give the inputs of the networks their names in the pictures. If empty, the classes are not loaded, and these
     *     inputs are numbered
     */
    public ExperimentReport(List<Experiment> experiments, List<ExperimentComparison> comparisons, Optional<Path> jar) {
        this.jar = jar;
        this.experiments = List.copyOf(experiments);
        this.comparisons = List.copyOf(comparisons);
    }

    /**
     * Draws the figures of each version of the task: learning curves and module use. The caller passes them to {@link
     * #html}, and can save them as files, too.
     */
    public List<Figure> figures() {
        List<Figure> figures = new ArrayList<>();
        Experiment.byVersion(experiments).forEach((version, ofVersion) -> {
            figures.add(LearningCurveFigure.overview(version, ofVersion, paper));
            figures.add(LearningCurveFigure.panels(version, ofVersion, paper));
            ModuleUseFigure.of(version, ofVersion, paper).ifPresent(figures::add);
        });
        return figures;
    }

    /**
     * The report as HTML.
     *
     * @param title heading of the page
     * @param figures the figures for the top of the page, usually the result of {@link #figures}
     * @param replays gives the link to the replay of a run's champion, or null if it has none
     */
    public String html(String title, List<Figure> figures, BiFunction<Experiment, RunResult, String> replays) {
        int runs = experiments.stream().mapToInt(e -> e.runs().size()).sum();
        boolean hasReplays = experiments.stream().anyMatch(experiment -> experiment.runs().stream()
                .anyMatch(run -> replays.apply(experiment, run) != null));
        return new Page("report", "report.html")
                .withText("title", title)
                .withText(
                        "subtitle",
                        Numbers.counted(experiments.size(), "experiment") + ", " + Numbers.counted(runs, "run"))
                .with(
                        "notes",
                        comparisons.stream()
                                .flatMap(comparison -> comparison.notes().stream())
                                .distinct()
                                .map(note -> "<p class=\"note\">" + Page.escape(note) + "</p>\n")
                                .collect(Collectors.joining()))
                .with(
                        "figures",
                        figures.stream()
                                .map(figure -> "<figure>"
                                        + Html.drawing(figure.svg(), "drawing wide", figure.caption())
                                        + Html.drawing(figure.narrowSvg(), "drawing narrow", figure.caption())
                                        + "<figcaption>" + Page.escape(figure.caption()) + "</figcaption></figure>\n")
                                .collect(Collectors.joining()))
                .with("statistics", comparisons.stream().map(this::statistics).collect(Collectors.joining()))
                .with(
                        "champions",
                        experiments.stream()
                                .map(experiment -> champions(experiment, replays))
                                .collect(Collectors.joining()))
                .with("settings", settings())
                .withText("replays", hasReplays ? "; the replays are in the folder beside it" : "")
                .html();
    }

    private String statistics(ExperimentComparison comparison) {
        ComparisonReport report = comparison.report();
        StringBuilder html = new StringBuilder();
        html.append("<h3>")
                .append(Page.escape(comparison.heading(comparisons.size() > 1)))
                .append("</h3>\n");
        html.append(Html.table(report.groups()));
        html.append("<p>").append(Page.escape(report.overall())).append("</p>\n");
        if (!report.pairs().rows().isEmpty()) {
            html.append("<h4>All pairs</h4>\n").append(Html.table(report.pairs()));
            html.append(
                    "<p>Two-sided Mann-Whitney U test with Bonferroni correction; A is the probability that the first"
                            + " method scores higher; * marks corrected p below 0.05.</p>\n");
        }
        if (report.hasPaper()) {
            html.append("<h4>Against the paper's champions</h4>\n").append(Html.table(report.againstPaper()));
        }
        return html.toString();
    }

    private String champions(Experiment experiment, BiFunction<Experiment, RunResult, String> replays) {
        RunResult best = experiment.best();
        StringBuilder html =
                new StringBuilder("<h3>" + Page.escape(experiment.label()) + "</h3>\n<div class=\"scroll\">"
                        + "<table><thead><tr><th>run</th><th>score when chosen</th><th>games after evolution</th><th>mean</th><th>95 % interval</th>"
                        + "<th>most-used module</th><th>modules</th><th>neurons</th><th>links</th><th>replay</th>"
                        + "<th>network</th></tr></thead><tbody>\n");
        for (RunResult run : experiment.runs()) {
            html.append(run == best ? "<tr class=\"best\">" : "<tr>");
            cell(html, String.valueOf(run.number()));
            cell(html, Numbers.score(run.scoreOfChampion()));
            ChampionEvaluation evaluation = run.evaluation().orElse(null);
            cell(html, evaluation == null ? "-" : String.format(Locale.ROOT, "%,d", evaluation.games()));
            cell(html, evaluation == null ? "-" : Numbers.score(evaluation.meanScore()));
            cell(html, evaluation == null ? "-" : Numbers.interval(evaluation.low(), evaluation.high()));
            cell(html, evaluation == null ? "-" : Numbers.decimal(evaluation.mostUsedModulePercent(), 1) + " %");
            network(html, run, replays.apply(experiment, run));
        }
        return html.append(
                        "</tbody></table></div>\n<p>\u2605 marks the best champion. A champion is chosen in the last generation that has children,"
                                + " by the score in the column \"score when chosen\"; the learning curves show one generation more.</p>\n")
                .toString();
    }

    private void network(StringBuilder html, RunResult run, String replay) {
        if (!Champion.isIn(run.folder())) {
            for (int column = 0; column < 5; column++) {
                cell(html, "-");
            }
            html.append("</tr>\n");
            return;
        }
        Champion champion = Champion.read(run.folder()).withJar(jar);
        Genotype genotype = champion.genotype();
        ChampionLabels labels = ChampionLabels.of(champion, Optional.empty());
        cell(html, modules(genotype.layout()));
        cell(html, String.valueOf(genotype.nodes().size()));
        cell(html, String.valueOf(genotype.links().size()));
        html.append("<td>")
                .append(replay == null ? "-" : "<a href=\"" + Page.escape(replay) + "\">watch</a>")
                .append("</td><td><label><input type=\"checkbox\">show</label></td></tr>\n");
        // The network is a row of its own, so that the run's row stays where it is when the network opens.
        html.append("<tr class=\"network\"><td colspan=\"" + COLUMNS + "\">")
                .append(Html.drawing(
                        NetworkSvg.of(genotype, labels.labels()), "drawing", "network of run " + run.number()))
                .append(labels.remark().isEmpty() ? "" : "<p>" + Page.escape(labels.remark()) + "</p>")
                .append("</td></tr>\n");
    }

    /** The number of modules; of a hybrid also that of each group. */
    private static String modules(ModuleLayout layout) {
        return layout.modules()
                + (layout.isGrouped()
                        ? layout.sizesOfGroups().stream()
                                .map(String::valueOf)
                                .collect(Collectors.joining(" + ", " (", ")"))
                        : "");
    }

    private static void cell(StringBuilder html, String text) {
        html.append("<td>").append(Page.escape(text)).append("</td>");
    }

    private String settings() {
        String[] header = new String[experiments.size() + 1];
        header[0] = "parameter";
        for (int i = 0; i < experiments.size(); i++) {
            header[i + 1] = experiments.get(i).label();
        }
        TextTable table = new TextTable(header);
        for (String name : SETTINGS) {
            String[] row = new String[header.length];
            row[0] = name;
            boolean known = false;
            for (int i = 0; i < experiments.size(); i++) {
                String value = experiments.get(i).runs().get(0).parameters().get(name);
                known |= value != null && !value.isEmpty();
                row[i + 1] = Objects.requireNonNullElse(value, "-");
            }
            if (known) {
                table.row(row);
            }
        }
        StringBuilder html = new StringBuilder(Html.table(table));
        html.append("<p>Every run's folder holds all parameters in " + RunLayout.PARAMETERS + ".</p><ul>");
        for (Experiment experiment : experiments) {
            String numbers = experiment.runs().stream()
                    .map(run -> String.valueOf(run.number()))
                    .collect(Collectors.joining(", "));
            Path folder = experiment.runs().get(0).folder().getParent();
            html.append("<li>")
                    .append(Page.escape(experiment.label() + ": runs " + numbers + " in "
                            + (folder == null ? "this folder" : folder.toString())))
                    .append("</li>");
        }
        return html.append("</ul>\n").toString();
    }
}
