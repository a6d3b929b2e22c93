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
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.ChampionEvaluator;
import mmneat.analysis.evaluation.EvaluationReport;
import mmneat.analysis.evaluation.Rules;
import mmneat.analysis.results.ChampionEvaluation;
import mmneat.analysis.results.ExperimentFinder;
import mmneat.analysis.statistics.Numbers;
import mmneat.analysis.statistics.TextTable;
import mmneat.evolution.DaemonThreads;
import mmneat.experiment.UserError;
import picocli.CommandLine.Command;

/** Lets champions play many games after evolution. */
@Command(
        name = "evaluate",
        customSynopsis = "mmneat evaluate EXPERIMENT|FILE... [name=value...]",
        description = {
            "Lets champions play many games on all cores: average score with its confidence interval, module use by observation,"
                    + " deaths by maze, and every game in a CSV in the run's folder.",
            "",
            "The result does not depend on the number of threads. An interrupted evaluation goes on when the command is given"
                    + " again. compare, report and the figures use the evaluations under training rules.",
            "Example: mmneat evaluate results/blended games=1000",
            "Example: mmneat evaluate results/blended/2M0 rules=FourMaze",
            "Example: mmneat evaluate champion=blended games=100",
            "",
        })
final class EvaluateCommand extends WordCommand implements Runnable {

    private static final int PROGRESS_SECONDS = 5;

    @Override
    List<Word> knownWords() {
        return List.of(
                ChosenChampion.WORD,
                new Word(
                        "games",
                        "1000",
                        "games per champion (default 1000); where more were played already, all of them count"),
                ChampionWords.RULES,
                new Word(
                        "seed",
                        "0",
                        "seed of the games' seeds (default 0); games with another seed replace those that are there"),
                new Word("threads", "2", "games played at the same time (default: all cores)"),
                new Word(
                        "report",
                        "true",
                        "writes the original's eval report instead, one champion after the other and game after game, drawn"
                                + " as the original draws from the run's seed (default false)"),
                ChampionWords.TASK,
                ChampionWords.GHOSTS);
    }

    @Override
    public void run() {
        Words words = wordsAboutExperiments();
        Rules rules = ChampionWords.rules(words);
        int games = words.integer("games", 1000, 1, 1_000_000);
        List<ChampionEvaluator.Entry> entries = champions(words).stream()
                .map(champion -> new ChampionEvaluator.Entry(champion, ChampionWords.settings(words, champion, rules)))
                .toList();
        if (words.flag("report", false)) {
            for (String name : List.of("seed", "threads")) {
                words.requireEffect(
                        name, false, "the games of report=true are drawn one after the other from the run's seed");
            }
            report(entries, games);
            return;
        }
        int threads = words.integer("threads", Runtime.getRuntime().availableProcessors(), 1, 4096);
        long seed = words.longInteger("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE);
        try (ChampionEvaluator evaluator = new ChampionEvaluator(rules, games, seed, threads)) {
            ScheduledExecutorService progress = progress(evaluator, (long) games * entries.size());
            List<ChampionEvaluation> evaluations = evaluator.evaluate(entries);
            progress.shutdownNow();
            print(entries, evaluations);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new UserError("interrupted; give the same command again to go on", e);
        }
    }

    /** The champions of all runs that the plain words lead to, or the networks that they name, or the shipped one. */
    private List<Champion> champions(Words words) {
        List<Champion> champions = new ArrayList<>();
        if (words.has(ChosenChampion.WORD.name())) {
            champions.add(ChosenChampion.of(words, null));
            return champions;
        }
        for (Path path : experimentPaths(words)) {
            if (Files.isRegularFile(path)) {
                champions.add(Champion.read(path));
            } else {
                ExperimentFinder.find(List.of(path)).stream()
                        .flatMap(experiment -> experiment.runs().stream())
                        .forEach(run -> champions.add(Champion.read(run.folder())));
            }
        }
        // Who is named twice, as a folder and as a file for example, plays once.
        Map<Path, Champion> byFile = new LinkedHashMap<>();
        champions.forEach(
                champion -> byFile.putIfAbsent(champion.file().toAbsolutePath().normalize(), champion));
        return List.copyOf(byFile.values());
    }

    private void report(List<ChampionEvaluator.Entry> entries, int games) {
        for (ChampionEvaluator.Entry entry : entries) {
            Path file = EvaluationReport.write(entry.champion(), entry.settings(), games);
            out().println(file);
        }
        out().flush();
    }

    private ScheduledExecutorService progress(ChampionEvaluator evaluator, long all) {
        PrintWriter notes = notes();
        long start = System.nanoTime();
        ScheduledExecutorService clock = Executors.newSingleThreadScheduledExecutor(DaemonThreads.named("progress"));
        clock.scheduleAtFixedRate(
                () -> {
                    notes.println(progressLine(evaluator, all, System.nanoTime() - start));
                    notes.flush();
                },
                PROGRESS_SECONDS,
                PROGRESS_SECONDS,
                TimeUnit.SECONDS);
        return clock;
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
        return line + String.format(Locale.ROOT, ", %.1f games/s, about %s left", perSecond, Texts.duration(left));
    }

    private void print(List<ChampionEvaluator.Entry> entries, List<ChampionEvaluation> evaluations) {
        TextTable table = new TextTable(
                "champion", "games", "mean", "sd", "95 % interval", "most-used module", "deaths in A B C D");
        for (int i = 0; i < entries.size(); i++) {
            ChampionEvaluation evaluation = evaluations.get(i);
            table.row(
                    entries.get(i).champion().name(),
                    String.valueOf(evaluation.games()),
                    Numbers.score(evaluation.meanScore()),
                    Numbers.score(evaluation.standardDeviation()),
                    Numbers.score(evaluation.low()) + " to " + Numbers.score(evaluation.high()),
                    Numbers.decimal(evaluation.mostUsedModulePercent(), 1) + " %",
                    Arrays.stream(evaluation.deathsByMaze())
                            .mapToObj(Long::toString)
                            .collect(Collectors.joining(" ")));
        }
        PrintWriter out = out();
        out.print(table.text());
        if (entries.size() == 1) {
            out.println();
            out.print(moduleUse(evaluations.get(0)).text());
        }
        out.flush();
    }

    private static TextTable moduleUse(ChampionEvaluation evaluation) {
        int modules = evaluation.moduleUse().get(0).length;
        String[] header = new String[modules + 1];
        header[0] = "module use, % of steps";
        for (int m = 0; m < modules; m++) {
            header[m + 1] = "module " + (m + 1);
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
