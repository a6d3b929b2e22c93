package mmneat.experiment.cluster;

import java.util.List;
import java.util.stream.Collectors;
import mmneat.experiment.UserError;

/**
 * The submit file of one experiment for HTCondor: one job per run, on a file system that the machines share.
 *
 * <p>A job that is evicted gets SIGTERM, saves, and is started again by HTCondor; a run that ends with another exit
 * code than 0 or 2 is tried again three times.
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

    /**
     * Returns the text of the submit file.
     *
     * @throws UserError if the name of a folder or of the Java program cannot be written in a submit file
     */
    public static String of(ExperimentJob job, JobResources resources) {
        List<String> command = job.command(resources, CondorSubmitFile::quote, "run=$(run)");
        String label = job.name().replaceAll("[^\\w.-]", "-");
        return SUBMIT_FILE.formatted(
                label,
                job.file("condor"),
                value(resources.java()),
                command.stream().skip(1).collect(Collectors.joining(" ")),
                value(job.workingFolder().toString()),
                resources.cpus(),
                resources.memoryMebibytes(),
                resources.time().toSeconds(),
                value(job.folder().resolve(job.name()).toString()),
                job.runs().stream().map(String::valueOf).collect(Collectors.joining(" ")));
    }

    /**
     * Quotes a word in HTCondor's new syntax: the whole line in double quotes, words with blanks in single quotes,
     * quotes doubled.
     */
    private static String quote(String word) {
        String doubled = literal(word).replace("\"", "\"\"");
        boolean special = doubled.isEmpty() || doubled.matches(".*[\\s'].*");
        return special ? "'" + doubled.replace("'", "''") + "'" : doubled;
    }

    /**
     * Quotes the value of a line. HTCondor trims such a value, allows quotes, and continues it after a backslash at its
     * end.
     */
    private static String value(String text) {
        if (!text.equals(text.strip()) || text.endsWith("\\") || text.contains("\"")) {
            throw new UserError(
                    text + ": HTCondor cannot read a name with a double quote, with a blank at an end, or with a"
                            + " backslash at its end; use another folder");
        }
        return literal(text);
    }

    /** Escapes dollar signs, which would start a macro name. */
    private static String literal(String text) {
        if (text.contains("$$(") || text.contains("$$[")) {
            throw new UserError(text + ": HTCondor would replace the text after $$; use a value without $$");
        }
        return text.replace("$", "$(DOLLAR)");
    }
}
