package mmneat.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import mmneat.analysis.evaluation.Champion;
import mmneat.cli.output.LearningCurve;
import mmneat.cli.output.Progress;
import mmneat.cli.output.ResultTable;
import mmneat.experiment.ExitGuard;
import mmneat.experiment.parameters.NamedCode;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.experiment.run.ExperimentPlan;
import mmneat.experiment.run.ExperimentRunner;
import mmneat.experiment.run.RunMonitor;
import mmneat.experiment.run.RunOutcome;
import mmneat.experiment.store.RunLayout;
import mmneat.neat.Thrown;
import pacman.game.MachineFonts;
import picocli.CommandLine.ExitCode;

/**
 * The main job: runs the evolutions that the parameters describe, shows their progress and prints their scores.
 *
 * <p>The exit code ({@link Main} lists all) is 0 if all runs are complete; 1 if at least one failed; otherwise 2 if at
 * least one could not start because of an error of the user; otherwise 3: runs are locked by another process. If the
 * program is interrupted, each run is saved up to its last complete generation, and the exit code is 130 after Ctrl-C,
 * 143 after SIGTERM.
 */
final class MainJob implements Callable<Integer> {

    /** Exit code: a run is locked by another process. */
    static final int IN_USE = 3;

    /** Time limit for current writes of an interrupted program; schedulers wait at least five seconds. */
    private static final Duration LAST_WRITES = Duration.ofSeconds(4);

    private static final Set<RunMonitor.Phase> FAILURES = EnumSet.of(RunMonitor.Phase.FAILED, RunMonitor.Phase.STOPPED);

    private final List<String> words;
    private final PrintWriter out;
    private final PrintWriter errors;

    MainJob(List<String> words, PrintWriter out, PrintWriter errors) {
        this.words = words;
        this.out = out;
        this.errors = errors;
    }

    @Override
    public Integer call() throws InterruptedException, IOException {
        ParameterReader.Result read = new ParameterReader(ParameterCatalogue.load()).read(words);
        read.remarks().forEach(remark -> errors.println("mmneat: " + remark));
        ExperimentPlan plan = ExperimentPlan.of(read.parameters());
        ExperimentRunner experiment = ExitGuard.guard(errors, () -> new ExperimentRunner(plan));
        boolean quiet = read.parameters().flag("quiet");

        Progress progress = Progress.start(quiet, out, plan, experiment.monitors());
        ExitGuard guard = new ExitGuard(ExitCode.SOFTWARE, caller -> halt(experiment, progress, caller));
        List<RunOutcome> outcomes;
        boolean goesOn;
        try {
            outcomes = experiment.run();
        } finally {
            progress.close();
            goesOn = guard.remove();
        }
        if (!goesOn) {
            return ExitCode.SOFTWARE;
        }

        for (RunOutcome outcome : outcomes) {
            reportTrouble(outcome);
        }
        // A run that is one of many jobs writes only into its own folder.
        boolean oneOfMany =
                plan.parameters().isGiven("run") || plan.parameters().isGiven("runNumber");
        if (!quiet) {
            new ResultTable(plan, outcomes).print(out);
        }
        Optional<Path> curve = oneOfMany ? Optional.empty() : LearningCurve.write(plan, outcomes);
        if (!quiet) {
            showFurther(plan, outcomes, curve);
        }
        return exitCode(outcomes);
    }

    private void showFurther(ExperimentPlan plan, List<RunOutcome> outcomes, Optional<Path> curve) {
        Optional<Path> best = new ResultTable(plan, outcomes).best().map(outcome -> outcome.run()
                .directory());
        if (curve.isPresent() && best.isPresent()) {
            out.println();
            String png = MachineFonts.areAvailable() ? " (and .png)" : " (no .png: " + MachineFonts.MISSING + ")";
            out.println("Learning curve: " + curve.get() + png);
            out.println("Next:");
            boolean hasChampion = Champion.isIn(best.get());
            if (hasChampion && PublishedTask.version(plan.parameters()).isPresent()) {
                out.println("  " + withJar(plan, "watch", best.get().toString()));
            }
            if (hasChampion) {
                String network = best.get().resolve(RunLayout.CHAMPION).toString();
                out.println("  " + withJar(plan, "network", network));
            }
            out.println("  " + ShellCommand.command("status", plan.base().toString()));
            out.println("  " + ShellCommand.command("compare", plan.base().toString()));
            out.flush();
        }
    }

    /** A command about a champion that allows the user's own classes if the runs have some. */
    private static String withJar(ExperimentPlan plan, String... words) {
        List<String> all = new ArrayList<>(List.of(words));
        String jar = plan.parameters().text("jar");
        boolean isGame = PublishedTask.version(plan.parameters()).isPresent();
        if (!jar.isEmpty() || NamedCode.isOnClassPath(plan.parameters(), isGame)) {
            all.add("jar=" + jar);
        }
        return ShellCommand.command(all.toArray(String[]::new));
    }

    /** Called when the process is asked to end: Ctrl-C, SIGTERM, or a class of the user's own that calls exit. */
    private void halt(ExperimentRunner experiment, Progress progress, Optional<String> caller) {
        progress.close();
        boolean finished;
        try {
            finished = experiment.halt(LAST_WRITES);
        } catch (InterruptedException | IOException e) {
            finished = false;
        }
        errors.println();
        errors.println("mmneat: "
                + caller.map(name -> ExitGuard.sentence(name) + "; remove that call")
                        .orElse("stopped")
                + (finished ? "" : " while writing")
                + "; every run is saved up to its last complete generation. To continue, give the same command again:");
        errors.println("  " + ShellCommand.command(words.toArray(String[]::new)));
        errors.flush();
    }

    private void reportTrouble(RunOutcome outcome) {
        if (outcome.message() != null) {
            errors.println("mmneat: run " + outcome.run().number() + ": " + outcome.message());
        }
        if (outcome.failure() != null) {
            errors.print(new Thrown(outcome.failure()).trace());
        }
        errors.flush();
    }

    /** Returns the exit code of two main jobs: a failed run matters most, then an error of the user, then a lock. */
    static int worse(int first, int second) {
        return Stream.of(ExitCode.SOFTWARE, ExitCode.USAGE, IN_USE)
                .filter(code -> code == first || code == second)
                .findFirst()
                .orElse(ExitCode.OK);
    }

    private static int exitCode(List<RunOutcome> outcomes) {
        if (outcomes.stream().allMatch(RunOutcome::isComplete)) {
            return ExitCode.OK;
        }
        boolean onlyInUse = outcomes.stream()
                .allMatch(outcome -> outcome.isComplete() || outcome.phase() == RunMonitor.Phase.IN_USE);
        boolean noneFailed = outcomes.stream().noneMatch(outcome -> FAILURES.contains(outcome.phase()));
        return onlyInUse ? IN_USE : noneFailed ? ExitCode.USAGE : ExitCode.SOFTWARE;
    }
}
