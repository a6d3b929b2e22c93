package mmneat.experiment.cluster;

import java.util.List;

/**
 * A list of shell commands, one per run, for GNU parallel, {@code xargs} or any other program that starts command
 * lines.
 */
public final class CommandList {

    private CommandList() {}

    /**
     * Returns the commands of all runs of {@code job}. Each command is complete: it first changes into the working
     * folder.
     *
     * @param resources the Java program, the number of threads and the size of Java's heap in each command; the time
     *     limit is not used
     */
    public static List<String> of(ExperimentJob job, JobResources resources) {
        return job.runs().stream().map(run -> command(job, resources, run)).toList();
    }

    private static String command(ExperimentJob job, JobResources resources, int run) {
        List<String> words = job.command(resources, ShellWord::quote, "run=" + run);
        return "cd " + ShellWord.quote(job.workingFolder().toString()) + " && " + String.join(" ", words);
    }
}
