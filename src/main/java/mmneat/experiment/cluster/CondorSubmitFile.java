package mmneat.experiment.cluster;

import java.util.List;
import java.util.stream.Collectors;

/**
 * The submit file of one experiment for HTCondor: one job per run, on a file system that the machines share.
 *
 * <p>A job that is evicted gets SIGTERM, saves, and is started again by HTCondor; a run that ends with another exit code
 * than 0 or 2 is tried again three times.
 */
public final class CondorSubmitFile {

    private static final String SUBMIT_FILE = """
            # %1$s: one job per run. Written by "mmneat submit"; submit it with
            #   condor_submit %2$s
            universe                = vanilla
            executable              = %3$s
            transfer_executable     = false
            arguments               = "%4$s"
            initialdir              = %5$s
            should_transfer_files   = NO
            request_cpus            = %6$d
            request_memory          = %7$dMB
            allowed_job_duration    = %8$d
            kill_sig                = SIGTERM
            max_retries             = 3
            retry_until             = ExitCode == 2
            batch_name              = %1$s
            output                  = %9$s-$(run).out
            error                   = %9$s-$(run).err
            log                     = %9$s.condor.log
            queue run in (%10$s)
            """;

    private CondorSubmitFile() {}

    /** The submit file. */
    public static String of(ExperimentJob job, JobResources resources) {
        List<String> command = job.command(resources, "$(run)");
        return SUBMIT_FILE.formatted(
                job.name(),
                job.file("condor"),
                command.get(0),
                command.stream().skip(1).map(CondorSubmitFile::quote).collect(Collectors.joining(" ")),
                job.workingFolder(),
                resources.cpus(),
                resources.memoryMebibytes(),
                resources.time().toSeconds(),
                job.folder().resolve(job.name()),
                job.runs().stream().map(String::valueOf).collect(Collectors.joining(" ")));
    }

    /** HTCondor's new syntax: the whole line in double quotes, words with blanks in single ones, quotes doubled. */
    private static String quote(String word) {
        String doubled = word.replace("\"", "\"\"");
        boolean special = doubled.contains(" ") || doubled.contains("\t") || doubled.contains("'");
        return special ? "'" + doubled.replace("'", "''") + "'" : doubled;
    }
}
