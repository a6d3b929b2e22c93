package mmneat.experiment.cluster;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;

/**
 * The batch script of one experiment for Slurm: a job array with one task per run.
 *
 * <p>The script runs {@code mmneat.jar} and acts on its exit code:
 *
 * <table>
 *   <caption>Exit codes</caption>
 *   <tr><th>code</th><th>meaning</th><th>what the script does</th></tr>
 *   <tr><td>0</td><td>the run is complete</td><td>ends</td></tr>
 *   <tr><td>2</td><td>an error in the parameters</td><td>ends: a restart cannot fix it</td></tr>
 *   <tr><td>3</td><td>another process holds the lock of the run's folder</td><td>ends if this is the first start. After
 *       a restart, the lock is probably that of the killed process of the previous start: the script waits three
 *       minutes, until such a lock no longer counts, and queues the job again</td></tr>
 *   <tr><td>143</td><td>the run saved and ended after the signal SIGTERM</td><td>queues the job again if the reason was
 *       the time limit, of which Slurm warns two minutes before. Otherwise (scancel, pre-emption) it ends, and Slurm
 *       decides by its own settings whether the job starts again</td></tr>
 *   <tr><td>other</td><td>a crash</td><td>queues the job again, at most three times</td></tr>
 * </table>
 */
public final class SlurmScript {

    /** The environment variable that is added to the task index to get the run number, because arrays may be split. */
    private static final String OFFSET = "MMNEAT_FIRST_RUN";

    private static final String SCRIPT = """
            #!/bin/bash
            # %1$s: one task per run. Written by "mmneat submit"; read it, edit it, submit it by hand with
            #   sbatch --array=%2$s %3$s
            #SBATCH --job-name=%1$s
            #SBATCH --array=%2$s
            #SBATCH --ntasks=1
            #SBATCH --cpus-per-task=%4$d
            #SBATCH --mem=%5$dM
            #SBATCH --time=%6$s
            %7$s#SBATCH --chdir=%8$s
            #SBATCH --output=%9$s
            #SBATCH --open-mode=append
            #SBATCH --requeue
            # Two minutes before the time limit the run saves, leaves and is queued again.
            #SBATCH --signal=B:USR1@120

            run=$((SLURM_ARRAY_TASK_ID + ${%10$s:-0}))
            task="${SLURM_ARRAY_JOB_ID}_${SLURM_ARRAY_TASK_ID}"
            restarts=${SLURM_RESTART_COUNT:-0}
            echo "$(date -u +%%FT%%TZ) run $run starts on $(hostname), restart $restarts"

            %11$s &
            child=$!
            time_is_up=no
            trap 'time_is_up=yes; kill -TERM "$child"' USR1
            trap 'kill -TERM "$child"' TERM

            # A signal interrupts "wait"; the exit code counts only once the run is gone.
            while :; do
              wait "$child"
              code=$?
              kill -0 "$child" 2>/dev/null || break
            done
            wait "$child" 2>/dev/null
            last=$?
            [ "$last" -eq 127 ] || code=$last
            echo "$(date -u +%%FT%%TZ) run $run ends with exit code $code"

            case $code in
              0 | 2) ;;
              143) [ "$time_is_up" = no ] || scontrol requeue "$task" ;;
              3) [ "$restarts" -eq 0 ] || { sleep 180; scontrol requeue "$task"; } ;;
              *) [ "$restarts" -ge 3 ] || scontrol requeue "$task" ;;
            esac
            exit "$code"
            """;

    private SlurmScript() {}

    /**
     * Returns the output file of a task as a Slurm file name pattern. In a pattern a literal percent sign is doubled. A
     * backslash would disable the pattern.
     *
     * @throws UserError if the name has a backslash
     */
    private static String log(ExperimentJob job) {
        String place = job.folder().resolve(job.name()).toString();
        if (place.contains("\\")) {
            throw new UserError(
                    place + ": Slurm cannot write its output to a name with a backslash; give base= and log="
                            + " without backslashes");
        }
        return place.replace("%", "%%") + "-%A_%a.log";
    }

    /**
     * Returns the text of the script.
     *
     * @param options additional options of sbatch by name, for instance {@code partition} = {@code long}; the values
     *     are unquoted, and this method quotes them for the {@code #SBATCH} lines
     */
    public static String of(ExperimentJob job, JobResources resources, Map<String, String> options) {
        StringBuilder furtherOptions = new StringBuilder();
        options.forEach((name, value) -> PlainText.require(name, value));
        options.forEach((name, value) -> furtherOptions
                .append("#SBATCH --")
                .append(name)
                .append('=')
                .append(ShellWord.quote(value))
                .append('\n'));
        List<String> command = job.command(resources, ShellWord::quote, "\"run=$run\"");
        return SCRIPT.formatted(
                ShellWord.quote(job.name()),
                RunRanges.of(job.runs()),
                ShellWord.quote(job.file("slurm").toString()),
                resources.cpus(),
                resources.memoryMebibytes(),
                resources.clockTime(),
                furtherOptions,
                ShellWord.quote(job.workingFolder().toString()),
                ShellWord.quote(log(job)),
                OFFSET,
                String.join(" ", command));
    }

    /**
     * Returns the commands that submit the script, in the file {@code job.file("slurm")}: one, or more if run numbers
     * reach the site's array limit.
     *
     * @param arrayLimit the site's {@code MaxArraySize}: array indices are smaller than it
     */
    public static List<List<String>> submitCommands(ExperimentJob job, int arrayLimit) {
        List<List<String>> commands = new ArrayList<>();
        RunRanges.split(job.runs(), arrayLimit).forEach((offset, indices) -> {
            List<String> command = new ArrayList<>(List.of("sbatch", "--parsable"));
            command.add("--array=" + RunRanges.of(indices));
            if (offset > 0) {
                command.add("--export=ALL," + OFFSET + "=" + offset);
            }
            command.add(job.file("slurm").toString());
            commands.add(command);
        });
        return commands;
    }
}
