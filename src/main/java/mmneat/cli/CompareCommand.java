package mmneat.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import mmneat.analysis.ExperimentComparison;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.statistics.ComparisonCsv;
import mmneat.analysis.statistics.ComparisonReport;
import mmneat.cli.output.OutputFile;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The command {@code compare}: compares the champions of several experiments with the paper's statistics. */
@Command(
        name = "compare",
        customSynopsis = "mmneat compare EXPERIMENT... [name=value...]",
        description = {
            "Compares the champions of experiments with statistical tests.",
            "",
            "The tests are those of the paper: Kruskal-Wallis over all methods, Mann-Whitney for each "
                    + "pair with Bonferroni's correction, effect sizes, and medians with bootstrap intervals.",
            "",
            "Example: mmneat compare results/blended paper=true",
            "Example: mmneat compare results/blended/1M results/blended/2M csv=pairs.csv latex=pairs.tex",
            "",
        })
final class CompareCommand extends ConsoleCommand implements Runnable {

    private static final class Sources extends ArrayList<String> {
        Sources() {
            super(List.of("auto", "evaluation", "training"));
        }
    }

    @Mixin
    private ExperimentsArgument experimentsArgument;

    @Option(
            names = "scores",
            paramLabel = "SOURCE",
            defaultValue = "auto",
            completionCandidates = Sources.class,
            description =
                    "Scores of the champions: evaluation (games after evolution), training (the last generation), or"
                            + " auto: the evaluations if each method has an evaluated champion, otherwise the last"
                            + " generation. Runs without such a score are listed and left out (default: ${DEFAULT-VALUE}).")
    private String scores;

    @Option(
            names = "paper",
            paramLabel = "true|false",
            arity = "1",
            defaultValue = "false",
            description = "Adds the paper's champions (default: ${DEFAULT-VALUE}).")
    private boolean paper;

    @Option(names = "csv", paramLabel = "FILE", description = "Also writes all tests in full precision to this file.")
    private @Nullable Path csv;

    @Option(names = "latex", paramLabel = "FILE", description = "Also writes the tables in LaTeX to this file.")
    private @Nullable Path latex;

    @Override
    public void run() {
        if (csv != null) {
            OutputFile.require("csv", csv);
        }
        if (latex != null) {
            OutputFile.require("latex", latex);
            if (csv != null) {
                OutputFile.requireOther("latex", latex, "csv=" + csv, csv);
            }
        }
        List<Experiment> experiments = experimentsArgument.find(this);
        List<ExperimentComparison> comparisons = ExperimentComparison.ofEachVersion(
                experiments, ExperimentComparison.Scores.valueOf(scores.toUpperCase(Locale.ROOT)), paper);
        comparisons.forEach(comparison -> print(comparison, comparisons.size() > 1));
        List<ComparisonReport> reports =
                comparisons.stream().map(ExperimentComparison::report).toList();
        if (csv != null) {
            OutputFile.write(csv, ComparisonCsv.of(reports));
        }
        if (latex != null) {
            OutputFile.write(
                    latex, reports.stream().map(ComparisonReport::latex).collect(Collectors.joining("\n")));
        }
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
