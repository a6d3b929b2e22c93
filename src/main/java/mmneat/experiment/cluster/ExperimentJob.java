package mmneat.experiment.cluster;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The unfinished runs of one experiment, as jobs: run r is the command {@code java -jar mmneat.jar run=r <words>}.
 *
 * @param name name of the experiment and of its jobs, for instance {@code blended-2M}
 * @param folder where the job files are written and the jobs' output goes, for instance {@code results/blended}
 * @param workingFolder absolute folder that the jobs start in, so that relative paths in {@code words} mean the same
 * @param jar absolute path of {@code mmneat.jar} as the jobs see it
 * @param words the words that describe the experiment, without {@code run} and {@code runs}
 * @param runs numbers of the runs to do, ascending, without repetition, not empty
 */
public record ExperimentJob(
        String name, Path folder, Path workingFolder, Path jar, List<String> words, List<Integer> runs) {

    public ExperimentJob {
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

    /** The command of one run. {@code run} may be a number or what the scheduler's shell makes a number of. */
    List<String> command(JobResources resources, String run) {
        List<String> command = new ArrayList<>(resources.javaCommand());
        command.add("-jar");
        command.add(jar.toString());
        command.add("run=" + run);
        command.addAll(words);
        command.add("threads=" + resources.cpus());
        return command;
    }

    /** The file of this experiment for an engine: {@code <folder>/<name>.<ending>}. */
    public Path file(String ending) {
        return folder.resolve(name + "." + ending);
    }
}
