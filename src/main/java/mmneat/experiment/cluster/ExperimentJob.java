package mmneat.experiment.cluster;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import mmneat.experiment.PlainText;

/**
 * The unfinished runs of one experiment as jobs of a scheduler. Run r is the command {@code java -jar mmneat.jar run=r
 * <words>}.
 *
 * @param name name of the experiment and of its jobs, for instance {@code blended-2M}
 * @param folder folder of the job files and of the jobs' output, for instance {@code results/blended}
 * @param workingFolder absolute folder in which the jobs start, so that relative paths in {@code words} stay valid
 * @param jar absolute path of {@code mmneat.jar} as the jobs see it
 * @param words the parameters of the experiment as arguments of the command line, each {@code name=value}, without
 *     {@code run} and {@code runs}
 * @param runs numbers of the runs, ascending, without repetition, not empty
 */
public record ExperimentJob(
        String name, Path folder, Path workingFolder, Path jar, List<String> words, List<Integer> runs) {

    public ExperimentJob {
        PlainText.require("the name of the experiment", name);
        PlainText.require("the folder of the experiment", folder.toString());
        PlainText.require("the working folder", workingFolder.toString());
        PlainText.require("the path of the jar", jar.toString());
        words.forEach(word -> PlainText.require("a word of the experiment", word));
        words = List.copyOf(words);
        runs = List.copyOf(runs);
        if (runs.isEmpty()) {
            throw new IllegalArgumentException("a job needs at least one run");
        }
        for (int i = 1; i < runs.size(); i++) {
            if (runs.get(i - 1) >= runs.get(i)) {
                throw new IllegalArgumentException("runs must ascend, are " + runs);
            }
        }
    }

    /**
     * The command of one run.
     *
     * @param quote quotes a word for the scheduler
     * @param run the run's number in the scheduler's notation; it is inserted unquoted
     * @return the quoted words: the Java command, {@code run=<run>}, and the words of the experiment
     */
    List<String> command(JobResources resources, UnaryOperator<String> quote, String run) {
        List<String> before = new ArrayList<>(resources.javaCommand());
        before.addAll(List.of("-jar", jar.toString()));
        List<String> after = new ArrayList<>(words);
        after.add("threads=" + resources.cpus());
        return Stream.of(
                        before.stream().map(quote),
                        Stream.of(run),
                        after.stream().map(quote))
                .flatMap(part -> part)
                .toList();
    }

    /** Returns the job file of this experiment for a scheduler: {@code <folder>/<name>.<ending>}. */
    public Path file(String ending) {
        return folder.resolve(name + "." + ending);
    }
}
