package mmneat.experiment.cluster;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import mmneat.experiment.UserError;

/** Calls Slurm's commands {@code scontrol} and {@code sbatch}, which must be on the PATH. */
public final class SlurmSubmission {

    private static final Pattern ARRAY_LIMIT = Pattern.compile("MaxArraySize\\s*=\\s*(\\d+)");
    private static final int SECONDS = 60;

    private SlurmSubmission() {}

    /** Returns the site's {@code MaxArraySize}; array indices must be below it. */
    public static int arrayLimit() {
        String configuration = run(List.of("scontrol", "show", "config"));
        Matcher limit = ARRAY_LIMIT.matcher(configuration);
        if (!limit.find() || Integer.parseInt(limit.group(1)) < 1) {
            throw new UserError("Slurm allows no job arrays here (MaxArraySize); use engine=parallel");
        }
        return Integer.parseInt(limit.group(1));
    }

    /**
     * Submits the script of a job. The caller must have written it ({@link SlurmScript#of}) to {@code
     * job.file("slurm")}.
     *
     * @return the ids that Slurm gave to the jobs
     */
    public static List<String> submit(ExperimentJob job, int arrayLimit) {
        List<String> ids = new ArrayList<>();
        for (List<String> command : SlurmScript.submitCommands(job, arrayLimit)) {
            // "12345" or, on a federation, "12345;cluster"
            ids.add(run(command).strip().split(";")[0]);
        }
        return ids;
    }

    private static String run(List<String> command) {
        try {
            Process process =
                    new ProcessBuilder(command).redirectErrorStream(true).start();
            process.getOutputStream().close();
            String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            if (!process.waitFor(SECONDS, TimeUnit.SECONDS)) {
                process.destroyForcibly();
                throw new UserError(command.get(0) + " does not answer; check that Slurm is running");
            }
            if (process.exitValue() != 0) {
                throw new UserError(
                        command.get(0) + " refused: " + output.strip().lines().reduce("", (first, last) -> last));
            }
            return output;
        } catch (IOException e) {
            throw new UserError(
                    command.get(0) + " cannot be started; run this on a machine of the cluster, or use dryRun=true", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new UserError("interrupted while " + command.get(0) + " was running", e);
        }
    }
}
