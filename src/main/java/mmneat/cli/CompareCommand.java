package mmneat.cli;

import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import mmneat.analysis.ExperimentComparison;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.ExperimentFinder;
import mmneat.analysis.statistics.ComparisonCsv;
import mmneat.analysis.statistics.ComparisonReport;
import picocli.CommandLine.Command;

/** Compares the champions of several experiments with the paper's statistics. */
@Command(
        name = "compare",
        customSynopsis = "mmneat compare EXPERIMENT... [name=value...]",
        description = {
            "Compares the champions of experiments: Kruskal-Wallis, all pairs Mann-Whitney with Bonferroni's correction,"
                    + " effect sizes, medians with bootstrap intervals.",
            "",
            "EXPERIMENT is a folder of runs (all its methods) or what the folders of an experiment's runs begin with.",
            "Example: mmneat compare results/blended paper=true",
            "Example: mmneat compare results/blended/1M results/blended/2M csv=pairs.csv latex=pairs.tex",
            "",
        })
final class CompareCommand extends WordCommand implements Runnable {

    @Override
    List<Word> knownWords() {
        return List.of(
                new Word(
                        "scores",
                        "auto|evaluation|training",
                        "champions' scores from their evaluation after evolution, or from the last generation"
                                + " (default auto: the evaluations if all are there)"),
                new Word("paper", "true", "puts the paper's champions beside ours (default false)"),
                new Word("csv", "FILE", "writes every test in full precision"),
                new Word("latex", "FILE", "writes the tables for LaTeX"));
    }

    @Override
    public void run() {
        Words words = wordsAboutExperiments();
        List<Experiment> experiments = ExperimentFinder.find(experimentPaths(words));
        String scores = words.choice("scores", "auto", List.of("auto", "evaluation", "training"));
        List<ExperimentComparison> comparisons = ExperimentComparison.ofEachVersion(
                experiments,
                ExperimentComparison.Scores.valueOf(scores.toUpperCase(Locale.ROOT)),
                words.flag("paper", false));
        comparisons.forEach(comparison -> print(comparison, comparisons.size() > 1));
        List<ComparisonReport> reports =
                comparisons.stream().map(ExperimentComparison::report).toList();
        words.path("csv").ifPresent(file -> OutputFile.write(file, ComparisonCsv.of(reports)));
        words.path("latex")
                .ifPresent(file -> OutputFile.write(
                        file, reports.stream().map(ComparisonReport::latex).collect(Collectors.joining("\n"))));
    }

    private void print(ExperimentComparison comparison, boolean ofSeveral) {
        PrintWriter out = out();
        out.println(comparison.heading(ofSeveral));
        out.println();
        out.print(comparison.report().text());
        comparison.notes().forEach(note -> out.println("\nNote: " + note));
        if (ofSeveral) {
            out.println();
        }
        out.flush();
    }
}
