package mmneat.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import mmneat.analysis.ExperimentComparison;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.ExperimentFinder;
import mmneat.analysis.statistics.ComparisonCsv;
import mmneat.experiment.UserError;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Compares the champions of several experiments with the paper's statistics. */
@Command(
        name = "compare",
        mixinStandardHelpOptions = true,
        sortOptions = false,
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
final class CompareCommand implements Runnable, WordCommand {

    private static final int MOST_EXPERIMENTS = 1000;

    @Spec
    private CommandSpec command;

    @Parameters(hidden = true, paramLabel = "EXPERIMENT")
    private List<String> arguments = new ArrayList<>();

    @Override
    public List<Word> knownWords() {
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
        Words words = Words.parse(arguments, this, MOST_EXPERIMENTS);
        List<Experiment> experiments = ExperimentFinder.find(experimentPaths(words, "compare"));
        String scores = words.choice("scores", "auto", List.of("auto", "evaluation", "training"));
        ExperimentComparison comparison = ExperimentComparison.of(
                experiments,
                ExperimentComparison.Scores.valueOf(scores.toUpperCase(Locale.ROOT)),
                words.flag("paper", false));
        PrintWriter out = command.commandLine().getOut();
        out.println(comparison.heading());
        out.println();
        out.print(comparison.report().text());
        comparison.notes().forEach(note -> out.println("\nNote: " + note));
        out.flush();
        words.path("csv").ifPresent(file -> OutputFile.write(file, ComparisonCsv.of(comparison.report())));
        words.path("latex")
                .ifPresent(file -> OutputFile.write(file, comparison.report().latex()));
    }

    /** The words that name experiments; at least one. */
    static List<Path> experimentPaths(Words words, String command) {
        if (words.plain().isEmpty()) {
            throw new UserError("no experiment is given; write mmneat " + command + " results/blended, for example");
        }
        return words.plain().stream().map(Path::of).toList();
    }
}
