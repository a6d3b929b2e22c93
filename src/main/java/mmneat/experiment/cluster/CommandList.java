package mmneat.experiment.cluster;

import java.util.List;

/** One shell command per run, for GNU parallel, {@code xargs} or any other dispatcher that starts command lines. */
public final class CommandList {

    private CommandList() {}

    /** The commands of all runs of {@code job}, each complete: it changes into the working folder by itself. */
    public static List<String> of(ExperimentJob job, JobResources resources) {
        return job.runs().stream().map(run -> command(job, resources, run)).toList();
    }

    private static String command(ExperimentJob job, JobResources resources, int run) {
        List<String> words = job.command(resources, ShellWord::quote, "run=" + run);
        return "cd " + ShellWord.quote(job.workingFolder().toString()) + " && " + String.join(" ", words);
    }
}
