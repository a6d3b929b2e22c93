package mmneat.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import mmneat.analysis.statistics.Numbers;
import mmneat.analysis.statistics.TextTable;
import mmneat.cli.output.QuantityText;
import mmneat.experiment.UserError;
import mmneat.experiment.run.ExperimentView;
import mmneat.experiment.store.RunStatus;
import mmneat.experiment.store.RunView;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Parameters;

/**
 * The command {@code status}: shows the progress of experiments. It only reads their files, so it works while they run
 * on any machine.
 */
@Command(
        name = "status",
        customSynopsis = "mmneat status [FOLDER]",
        description = {
            "Shows the progress of experiments, read from their files.",
            "",
            "The runs may be running on this machine or on another.",
            "Exit code: 0 all runs are finished, 4 some are not finished, 5 some have failed.",
            "",
            "Example: mmneat status results/blended",
            "",
        })
final class StatusCommand extends ConsoleCommand implements Callable<Integer> {

    private static final int UNFINISHED = 4;
    private static final int FAILED = 5;

    private static final DateTimeFormatter CLOCK = DateTimeFormatter.ofPattern("EEE HH:mm", Locale.ROOT);

    @Parameters(
            arity = "0..1",
            paramLabel = "FOLDER",
            defaultValue = "results",
            description = "Folder with experiments or runs (default: results).")
    private Path folder;

    @Override
    public Integer call() throws IOException {
        if (!Files.isDirectory(folder)) {
            throw new UserError(folder
                    + (Files.exists(folder)
                            ? ": is a file; give the folder of a run or an experiment"
                            : ": there is no such folder"));
        }
        Instant now = Instant.now();
        List<ExperimentView> experiments = ExperimentView.readAll(folder, now);
        if (experiments.isEmpty()) {
            throw new UserError(folder + ": holds no runs");
        }
        PrintWriter out = out();
        experiments.forEach(experiment -> print(out, experiment, now));
        out.flush();
        if (experiments.stream().allMatch(ExperimentView::isFinished)) {
            return ExitCode.OK;
        }
        boolean someFailed = experiments.stream().anyMatch(experiment -> experiment.count(RunView.State.FAILED) > 0);
        return someFailed ? FAILED : UNFINISHED;
    }

    private static void print(PrintWriter out, ExperimentView experiment, Instant now) {
        out.println(experiment.name() + " in " + experiment.base() + ": " + summary(experiment));
        TextTable table =
                new TextTable("run", "state", "generation", "best", "median", "details").alignLeft("state", "details");
        for (RunView run : experiment.runs()) {
            RunStatus status = run.status();
            table.row(
                    String.valueOf(run.number()),
                    run.state().name().toLowerCase(Locale.ROOT),
                    status == null ? "" : status.generation() + "/" + status.generations(),
                    status == null || Double.isNaN(status.best()) ? "" : Numbers.score(status.best()),
                    status == null || Double.isNaN(status.median()) ? "" : Numbers.score(status.median()),
                    details(run, now));
        }
        out.print(table.text());
        out.println();
    }

    private static String summary(ExperimentView experiment) {
        StringBuilder summary = new StringBuilder(experiment.count(RunView.State.FINISHED) + " of "
                + experiment.runs().size() + " finished");
        for (RunView.State state : List.of(
                RunView.State.RUNNING, RunView.State.INTERRUPTED, RunView.State.FAILED, RunView.State.WAITING)) {
            if (experiment.count(state) > 0) {
                summary.append(", ")
                        .append(experiment.count(state))
                        .append(' ')
                        .append(state.name().toLowerCase(Locale.ROOT));
            }
        }
        experiment.best().ifPresent(run -> summary.append("; best of the last generation ")
                .append(Numbers.score(run.bestScore()))
                .append(" (run ")
                .append(run.number())
                .append("), median ")
                .append(Numbers.score(experiment.medianChampion())));
        return summary.toString();
    }

    private static String details(RunView run, Instant now) {
        return switch (run.state()) {
            case RUNNING -> running(run, now);
            case FAILED -> run.failure();
            case INTERRUPTED -> "to continue, give the same command again";
            case FINISHED, WAITING -> "";
        };
    }

    private static String running(RunView run, Instant now) {
        StringBuilder details = new StringBuilder();
        if (run.status() != null && run.status().stepsPerSecond() > 0) {
            details.append(QuantityText.rate(run.status().stepsPerSecond())).append(", ");
        }
        details.append("last written ")
                .append(QuantityText.duration(
                        Duration.between(run.signOfLife(), now).abs()))
                .append(" ago");
        if (run.estimatedEnd() != null) {
            details.append(", estimated end ")
                    .append(CLOCK.format(run.estimatedEnd().atZone(ZoneId.systemDefault())));
        }
        return details.toString();
    }
}
