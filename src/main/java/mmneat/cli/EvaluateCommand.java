package mmneat.cli;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.ChampionEvaluator;
import mmneat.analysis.evaluation.EvaluationReport;
import mmneat.analysis.evaluation.Rules;
import mmneat.analysis.results.ChampionEvaluation;
import mmneat.analysis.results.ExperimentFinder;
import mmneat.analysis.statistics.Numbers;
import mmneat.analysis.statistics.TextTable;
import mmneat.cli.options.ChampionChoice;
import mmneat.cli.options.GhostsOption;
import mmneat.cli.options.JarOption;
import mmneat.cli.options.Range;
import mmneat.cli.options.RulesOption;
import mmneat.cli.options.TaskOption;
import mmneat.cli.output.ProgressTicker;
import mmneat.cli.output.QuantityText;
import mmneat.experiment.ExitGuard;
import mmneat.experiment.FolderPlace;
import mmneat.experiment.UserError;
import mmneat.neat.ModuleLayout;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The command {@code evaluate}: champions play many games after evolution. */
@Command(
        name = "evaluate",
        customSynopsis = "mmneat evaluate EXPERIMENT|FILE... [name=value...]",
        description = {
            "Plays many games with champions and prints average scores.",
            "",
            "Prints for each champion the average score with its confidence interval, the use of modules "
                    + "and the deaths by maze. Every game is written to a CSV file in the run's folder.",
            "The result does not depend on the number of threads. To continue an interrupted evaluation, "
                    + "give the same command again. The commands compare and report use the evaluations under "
                    + "training rules.",
            "",
            "Example: mmneat evaluate results/blended games=1000",
            "Example: mmneat evaluate results/blended/2M0 rules=FourMaze",
            "Example: mmneat evaluate champion=blended games=100",
            "",
        })
final class EvaluateCommand extends ConsoleCommand implements Runnable {

    @Parameters(
            arity = "0..*",
            paramLabel = "EXPERIMENT|FILE",
            description = "Folder of runs, a prefix of such folders' names, or file of a network.")
    private @Nullable List<Path> paths;

    @Mixin
    private ChampionChoice choice;

    @Option(
            names = "games",
            paramLabel = "N",
            defaultValue = "1000",
            description = "Games per champion; a champion that has played more keeps all of them"
                    + " (default: ${DEFAULT-VALUE}).")
    @Range(min = 1, max = 1_000_000)
    private int games;

    @Mixin
    private RulesOption rulesOption;

    @Option(
            names = "seed",
            paramLabel = "N",
            defaultValue = "0",
            description = "Seed from which the games' seeds are drawn; an evaluation with another seed is kept as"
                    + " another file (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(
            names = "threads",
            paramLabel = "N",
            description = "Games played at the same time (default: the number of cores).")
    @Range(min = 1, max = 4096)
    private @Nullable Integer threads;

    @Option(
            names = "report",
            paramLabel = "true|false",
            arity = "1",
            defaultValue = "false",
            description =
                    "Writes the original's evaluation report instead: one champion after the other, game after game,"
                            + " with random numbers drawn from the run's seed as in the original (default: ${DEFAULT-VALUE}).")
    private boolean report;

    @Mixin
    private TaskOption task;

    @Mixin
    private GhostsOption ghosts;

    @Mixin
    private JarOption jar;

    @Override
    public void run() {
        Rules rules = rulesOption.rules();
        List<ChampionEvaluator.Entry> entries = champions().stream()
                .map(champion -> new ChampionEvaluator.Entry(champion, ghosts.settings(champion, task, rules)))
                .toList();
        if (report) {
            for (String name : List.of("seed", "threads")) {
                requireEffect(
                        name, false, "the games of report=true are drawn one after the other from the run's seed");
            }
            report(entries);
            return;
        }
        int threads = this.threads == null ? Runtime.getRuntime().availableProcessors() : this.threads;
        try (ChampionEvaluator evaluator = new ChampionEvaluator(rules, games, seed, threads);
                ChampionEvaluator.Evaluations started = evaluator.begin(entries)) {
            started.remarks().forEach(notes()::println);
            notes().flush();
            print(entries, finish(evaluator, started, (long) games * entries.size()));
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new UserError("interrupted; to continue, give the same command again", e);
        }
    }

    /** Waits for the games and shows their progress. If the program is stopped, it prints how to continue. */
    private List<ChampionEvaluation> finish(
            ChampionEvaluator evaluator, ChampionEvaluator.Evaluations started, long all) throws InterruptedException {
        List<String> words = commandLine().getParseResult().originalArgs();
        // An exit that the user's own classes call is reported by the guard around all commands.
        ExitGuard guard = ExitGuard.within(() -> {
            notes().println("\nmmneat: stopped; finished games are saved in blocks of " + ChampionEvaluator.BLOCK
                    + ". To continue, give the same command again:");
            notes().println("  " + ShellCommand.command(words.toArray(String[]::new)));
            notes().flush();
        });
        try {
            long start = System.nanoTime();
            return ProgressTicker.during(
                    notes(), () -> List.of(progressLine(evaluator, all, System.nanoTime() - start)), started::finish);
        } finally {
            guard.remove();
        }
    }

    /** Returns the champions of all runs in the folders, the networks in the files, or the shipped champion. */
    private List<Champion> champions() {
        List<Champion> champions = new ArrayList<>();
        if (choice.isGiven()) {
            champions.add(jar.allow(choice.read(paths == null ? null : paths.get(0), null)));
            return champions;
        }
        for (Path path : requireExperiments(paths)) {
            if (Files.isRegularFile(path)) {
                champions.add(jar.allow(Champion.read(path)));
            } else {
                ExperimentFinder.find(List.of(path)).stream()
                        .flatMap(experiment -> experiment.runs().stream())
                        .forEach(run -> champions.add(jar.allow(Champion.read(run.folder()))));
            }
        }
        // A champion that is named twice, for example as a folder and as a file or a link, plays once.
        Map<Path, Champion> byFile = new LinkedHashMap<>();
        champions.forEach(champion -> byFile.putIfAbsent(FolderPlace.real(champion.file()), champion));
        return List.copyOf(byFile.values());
    }

    private void report(List<ChampionEvaluator.Entry> entries) {
        for (ChampionEvaluator.Entry entry : entries) {
            Path file = EvaluationReport.write(entry.champion(), entry.settings(), games);
            out().println(file);
        }
        out().flush();
    }

    private static String progressLine(ChampionEvaluator evaluator, long all, long nanoseconds) {
        long played = evaluator.played();
        long done = evaluator.found() + played;
        String line = String.format(Locale.ROOT, "evaluate: %,d of %,d games", done, all);
        if (played == 0) {
            return line;
        }
        double perSecond = played / (nanoseconds * 1e-9);
        Duration left = Duration.ofMillis((long) (1000 * (all - done) / perSecond));
        return line
                + String.format(Locale.ROOT, ", %.1f games/s, about %s left", perSecond, QuantityText.duration(left));
    }

    private void print(List<ChampionEvaluator.Entry> entries, List<ChampionEvaluation> evaluations) {
        TextTable table = new TextTable(
                "champion", "games", "mean", "sd", "95 % interval", "most-used module", "deaths in A B C D");
        for (int i = 0; i < entries.size(); i++) {
            ChampionEvaluation evaluation = evaluations.get(i);
            table.row(
                    entries.get(i).champion().label(),
                    String.valueOf(evaluation.games()),
                    Numbers.score(evaluation.meanScore()),
                    Numbers.score(evaluation.standardDeviation()),
                    Numbers.interval(evaluation.low(), evaluation.high()),
                    Numbers.decimal(evaluation.mostUsedModulePercent(), 1) + " %",
                    Arrays.stream(evaluation.deathsByMaze())
                            .mapToObj(Long::toString)
                            .collect(Collectors.joining(" ")));
        }
        PrintWriter out = out();
        out.print(table.text());
        if (entries.size() == 1) {
            out.println();
            out.print(moduleUse(
                            evaluations.get(0),
                            entries.get(0).champion().genotype().layout())
                    .text());
        }
        out.flush();
    }

    private static TextTable moduleUse(ChampionEvaluation evaluation, ModuleLayout layout) {
        int modules = evaluation.moduleUse().get(0).length;
        String[] header = new String[modules + 1];
        header[0] = "module use, % of steps";
        for (int m = 0; m < modules; m++) {
            header[m + 1] =
                    (layout.isGrouped() ? "group " + (layout.choiceOf(m) + 1) + ": " : "") + "module " + (m + 1);
        }
        TextTable table = new TextTable(header);
        for (int s = 0; s < ChampionEvaluation.SITUATIONS.size(); s++) {
            long[] counts = evaluation.moduleUse().get(s);
            double all = Arrays.stream(counts).sum();
            String[] row = new String[modules + 1];
            row[0] = ChampionEvaluation.SITUATIONS.get(s);
            for (int m = 0; m < modules; m++) {
                row[m + 1] = all == 0 ? "-" : Numbers.decimal(100 * counts[m] / all, 1);
            }
            table.row(row);
        }
        return table;
    }
}
