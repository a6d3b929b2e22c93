package mmneat.experiment.run;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.Parameters;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.mspacman.TaskVersion;

/**
 * The runs of an experiment: {@code runs=30} means the runs 0 to 29 with the seeds 0 to 29.
 *
 * @param parameters what is common to all runs
 * @param name what the files of all runs start with, for instance {@code blended-2M}
 * @param base folder of the experiment, for instance {@code results/blended}
 * @param runs the runs, by ascending number
 */
public record ExperimentPlan(Parameters parameters, String name, Path base, List<RunPlan> runs) {

    public ExperimentPlan {
        runs = List.copyOf(runs);
    }

    /**
     * The plan that the parameters describe.
     *
     * @throws UserError if they contradict each other
     */
    public static ExperimentPlan of(Parameters parameters) {
        List<Integer> numbers = numbers(parameters);
        boolean oneSeed = parameters.integer("randomSeed") != -1;
        if (oneSeed && numbers.size() > 1) {
            throw new UserError("randomSeed=" + parameters.text("randomSeed") + " would make " + numbers.size()
                    + " equal runs: leave it out, then run r has the seed r; or ask for one run with run=NUMBER");
        }
        String task = PublishedTask.version(parameters)
                .map(TaskVersion::label)
                .orElseGet(() -> simpleName(parameters.text("task")));
        String method = methodLabel(parameters);
        String base = parameters.isGiven("base") ? parameters.text("base") : "results/" + task;
        String saveTo = parameters.isGiven("saveTo") ? parameters.text("saveTo") : method;
        // Experiments that differ in the names of their runs must not share the files of all runs.
        String label =
                parameters.isGiven("saveTo") ? saveTo.replaceAll("[-_]+$", "").replace('/', '-') : method;
        String log = parameters.isGiven("log") ? parameters.text("log") : task + "-" + label;
        Parameters placed = parameters.with("base", base).with("saveTo", saveTo).with("log", log);
        List<RunPlan> runs = numbers.stream()
                .map(number -> new RunPlan(
                        number,
                        Path.of(base, saveTo + number),
                        log + number + "_",
                        placed.with("runNumber", number)
                                .with("randomSeed", oneSeed ? parameters.text("randomSeed") : number)))
                .toList();
        return new ExperimentPlan(placed, log, Path.of(base), runs);
    }

    private static List<Integer> numbers(Parameters parameters) {
        List<String> given = Stream.of("run", "runs", "runNumber")
                .filter(parameters::isGiven)
                .toList();
        if (given.size() > 1) {
            throw new UserError(
                    "'" + given.get(0) + "' and '" + given.get(1) + "' do not go together: give one of them");
        }
        if (parameters.isGiven("run")) {
            return List.of(parameters.integer("run"));
        }
        if (parameters.isGiven("runNumber")) {
            return List.of(parameters.integer("runNumber"));
        }
        return IntStream.range(0, parameters.integer("runs")).boxed().toList();
    }

    /**
     * The name that folders have for the method: the one that was named, or what the parameters amount to. The second form
     * always has the number of modules, as folders of earlier runs do.
     */
    private static String methodLabel(Parameters parameters) {
        if (parameters.isGiven("method") || TaskVersion.labels().contains(parameters.text("task"))) {
            return parameters.text("method");
        }
        int modules = parameters.integer("multitaskModes");
        return modules > 1
                ? PublishedTask.multitask(Optional.empty(), modules)
                : PublishedTask.method(parameters.values()).orElse("MMD");
    }

    private static String simpleName(String className) {
        return className.substring(className.lastIndexOf('.') + 1);
    }
}
