package mmneat.experiment.cluster;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The script in a real bash, with fake java and scontrol programs that record their arguments. */
@EnabledIf(value = "hasBash", disabledReason = "this machine has no bash")
class SlurmScriptBehaviourTest {

    private static final String REQUEUED = "requeue 77_4";

    @TempDir
    Path folder;

    private Path script;

    static boolean hasBash() {
        return Files.isExecutable(Path.of("/bin/bash"));
    }

    @BeforeEach
    void writeScript() throws IOException {
        program("scontrol", "echo \"$@\" >> " + folder.resolve("scontrol.txt"));
        program("sleep", "exit 0");
        ExperimentJob job = new ExperimentJob(
                "blended-2M", folder, folder, folder.resolve("mmneat.jar"), List.of("task=blended"), List.of(4));
        JobResources resources = new JobResources(
                1, 1024, Duration.ofHours(1), folder.resolve("java").toString());
        script = Files.writeString(folder.resolve("job.sh"), SlurmScript.of(job, resources, Map.of()));
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0, false",
        "2, 0, false", // complete; an error that a restart cannot fix
        "143, 0, false", // scancel or pre-emption: Slurm decides
        "1, 0, true",
        "137, 2, true",
        "137, 3, false", // a crash: queued again three times
        "3, 0, false",
        "3, 1, true" // locked: started twice by mistake, or by the killed predecessor
    })
    void exitCodeOfTheRun_decidesWhetherItIsQueuedAgain(int code, int restarts, boolean queuedAgain) throws Exception {
        program("java", "exit " + code);

        Process process = start(restarts);

        assertThat(process.waitFor(20, TimeUnit.SECONDS)).isTrue();
        assertThat(process.exitValue()).isEqualTo(code);
        assertThat(requests()).isEqualTo(queuedAgain ? REQUEUED : "");
    }

    @Test
    void run_isTheTaskPlusTheOffset() throws Exception {
        program("java", "echo \"$@\"");

        Process process = start(0, Map.of("MMNEAT_FIRST_RUN", "1000"));

        assertThat(process.inputReader().lines().toList()).anyMatch(line -> line.contains(" run=1004 task=blended "));
    }

    @ParameterizedTest
    @CsvSource({"USR1, true", "TERM, false"})
    void signal_reachesTheRun_andOnlyTheTimeLimitQueuesItAgain(String signal, boolean queuedAgain) throws Exception {
        // Takes a moment to save when terminated, like a run.
        program(
                "java",
                "trap 'read -r -t 0.3 <> <(:); exit 143' TERM; echo ready; while :; do read -r -t 0.1 <> <(:); done");
        Process process = start(0);
        BufferedReader output = process.inputReader();
        String line = output.readLine();
        while (!"ready".equals(line)) {
            line = output.readLine();
        }

        new ProcessBuilder("kill", "-" + signal, Long.toString(process.pid()))
                .start()
                .waitFor();

        assertThat(process.waitFor(20, TimeUnit.SECONDS)).isTrue();
        assertThat(process.exitValue()).isEqualTo(143);
        assertThat(requests()).isEqualTo(queuedAgain ? REQUEUED : "");
    }

    private Process start(int restarts) throws IOException {
        return start(restarts, Map.of());
    }

    private Process start(int restarts, Map<String, String> environment) throws IOException {
        ProcessBuilder builder = new ProcessBuilder("/bin/bash", script.toString()).redirectErrorStream(true);
        builder.environment().put("PATH", folder + ":" + System.getenv("PATH"));
        builder.environment().put("SLURM_ARRAY_JOB_ID", "77");
        builder.environment().put("SLURM_ARRAY_TASK_ID", "4");
        builder.environment().put("SLURM_RESTART_COUNT", Integer.toString(restarts));
        builder.environment().putAll(environment);
        return builder.start();
    }

    private String requests() throws IOException {
        Path file = folder.resolve("scontrol.txt");
        return Files.exists(file) ? Files.readString(file).strip() : "";
    }

    private void program(String name, String body) throws IOException {
        Path file = Files.writeString(folder.resolve(name), "#!/bin/bash\n" + body + "\n");
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwxr-xr-x"));
    }
}
