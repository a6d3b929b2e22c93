package mmneat.experiment.run;

import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import mmneat.experiment.FolderPlace;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.Parameters;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.experiment.store.RunLayout;
import mmneat.mspacman.TaskVersion;

/**
 * The plan of an experiment: its runs with their folders and parameters. For example, {@code runs=30} means the runs 0
 * to 29 with the seeds 0 to 29.
 *
 * @param parameters the common parameters of all runs
 * @param name prefix of the files of all runs, for instance {@code blended-2M}
 * @param base folder of the experiment, for instance {@code results/blended}
 * @param runs the runs, by ascending number
 */
public record ExperimentPlan(Parameters parameters, String name, Path base, List<RunPlan> runs) {

    /** The longest file name of common file systems, in bytes. */
    private static final int LONGEST_NAME = 255;

    public ExperimentPlan {
        runs = List.copyOf(runs);
    }

    /**
     * Returns the plan that the parameters describe.
     *
     * @throws UserError if they contradict each other, or the folder of the runs is a file
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
        String base = named("base", parameters).orElse("results/" + task);
        FolderPlace.requireNoFile("base", Path.of(base));
        Optional<String> ownName = named("saveTo", parameters);
        ownName.ifPresent(ExperimentPlan::requireInBase);
        String saveTo = ownName.orElse(method);
        // Experiments that differ in the names of their runs must not share the files of all runs.
        String label = ownName.map(ExperimentPlan::label).orElse(method);
        String log = named("log", parameters).orElse(task + "-" + label);
        requireNames(saveTo, log, numbers.get(numbers.size() - 1), parameters);
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

    /** The value of a parameter that names a folder or files; empty if the program chooses the name. */
    private static Optional<String> named(String name, Parameters parameters) {
        return Optional.of(parameters.text(name)).filter(text -> parameters.isGiven(name) && !text.isEmpty());
    }

    /** Checks that the folders of runs lie in the base folder, also if a file of another person names them. */
    private static void requireInBase(String saveTo) {
        List<String> parts = List.of(saveTo.split("[/\\\\]", -1));
        if (saveTo.matches("[/\\\\].*|[A-Za-z]:.*") || parts.contains("..")) {
            throw new UserError("saveTo=" + saveTo + ": the folders of runs stay inside base=; name them without .. and"
                    + " without a path from the root");
        }
        if (parts.get(parts.size() - 1).startsWith(".")) {
            throw new UserError("saveTo=" + saveTo + ": the folders of runs would be hidden; give a name that does not"
                    + " begin with a dot");
        }
    }

    /** The part of file names that stands for a folder's name: a backslash separates folders on Windows only. */
    private static String label(String saveTo) {
        return saveTo.replaceAll("[-_]+$", "").replace('/', '-').replace('\\', File.separatorChar == '\\' ? '-' : '_');
    }

    /** Checks that the names of the last run's files are not too long, before any run is started. */
    private static void requireNames(String saveTo, String log, int lastRun, Parameters parameters) {
        if (log.matches(".*[/\\\\].*")) {
            throw new UserError("log=" + log + ": must not contain / or \\, because names of files begin with it;"
                    + " choose the folder with base=FOLDER");
        }
        if (log.startsWith(".")) {
            throw new UserError("log=" + log + ": the run's files would be hidden; give a name that does not begin with"
                    + " a dot");
        }
        int ending = RunLayout.longestEnding(parameters.integer("maxGens"));
        boolean isTooLong = bytes(log + lastRun + "_") + ending > LONGEST_NAME
                || Stream.of((saveTo + lastRun).split("[/\\\\]")).anyMatch(part -> bytes(part) > LONGEST_NAME);
        if (isTooLong) {
            boolean isByFolder = named("log", parameters).isEmpty()
                    && named("saveTo", parameters).isPresent();
            String name = isByFolder ? "saveTo=" + saveTo : "log=" + log;
            throw new UserError(name + ": too long, the names of the run's files would have more than " + LONGEST_NAME
                    + " bytes; give a shorter name");
        }
    }

    private static int bytes(String name) {
        return name.getBytes(StandardCharsets.UTF_8).length;
    }

    private static List<Integer> numbers(Parameters parameters) {
        List<String> given = Stream.of("run", "runs", "runNumber")
                .filter(parameters::isGiven)
                .toList();
        if (given.size() > 1) {
            throw new UserError(
                    "'" + given.get(0) + "' and '" + given.get(1) + "' cannot be combined; give one of them");
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
     * Returns the name of the method in folder names: the given name, or the name that follows from the parameters. The
     * latter always contains the number of modules, as in folders of earlier runs.
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
