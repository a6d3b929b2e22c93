package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import pacman.game.GhostLocations;

/** No data are lost: processes of the packaged jar are killed, stopped, started twice and run out of disk space. */
class CrashSafetyIT {

    private static final Path JAR = Path.of(System.getProperty("mmneat.jar", "target/mmneat.jar"));
    private static final List<String> EXPERIMENT =
            List.of("task=blended", "runs=2", "mu=4", "maxGens=4", "trials=1", "threads=2");

    @TempDir
    Path folder;

    private Path whole;

    @BeforeEach
    void experimentThatNothingHappensTo() throws Exception {
        whole = folder.resolve("whole");
        assertThat(finish(start(whole))).isZero();
    }

    private ProcessBuilder command(Path base, String... more) {
        // A shell that runs this test in the background ignores Ctrl-C; the program must not inherit that.
        List<String> command = new ArrayList<>(List.of(
                "env",
                "--default-signal=INT",
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx512m",
                "-jar",
                JAR.toString()));
        // A repeated word overrides the earlier one.
        Map<String, String> words = new LinkedHashMap<>();
        Stream.concat(EXPERIMENT.stream(), Arrays.stream(more))
                .forEach(word -> words.put(word.substring(0, word.indexOf('=')), word));
        command.addAll(words.values());
        command.add("base=" + base);
        return new ProcessBuilder(command)
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.appendTo(new File(folder.toFile(), "output.txt")));
    }

    private Process start(Path base, String... more) throws IOException {
        return command(base, more).start();
    }

    private int finish(Process process) throws InterruptedException {
        assertThat(process.waitFor(5, TimeUnit.MINUTES)).isTrue();
        return process.exitValue();
    }

    /** Waits until a file exists or the process has ended. */
    private static void awaitFile(Process process, Path file) {
        while (process.isAlive() && !Files.exists(file)) {
            Thread.onSpinWait();
        }
    }

    private void signal(String name, Process process) throws Exception {
        assertThat(new ProcessBuilder("kill", "-" + name, Long.toString(process.pid()))
                        .start()
                        .waitFor())
                .isZero();
    }

    private String output() throws IOException {
        return Files.readString(folder.resolve("output.txt"));
    }

    private void assertSameAsWhole(Path base) throws IOException {
        for (String run : List.of("2M0", "2M1")) {
            assertThat(content(base.resolve(run)))
                    .isEqualTo(content(whole.resolve(run)))
                    .hasSizeGreaterThan(20);
        }
    }

    private static Map<String, String> content(Path run) throws IOException {
        Map<String, String> content = new TreeMap<>();
        try (Stream<Path> files = Files.walk(run)) {
            for (Path file : (Iterable<Path>) files.filter(Files::isRegularFile)::iterator) {
                String name = run.relativize(file).toString();
                boolean differs = name.endsWith("_Performance_log.txt")
                        || name.startsWith("checkpoint")
                        || name.equals("status.json")
                        || name.equals("parameters.properties");
                if (!differs) {
                    content.put(name, Files.readString(file));
                }
            }
        }
        return content;
    }

    @Test
    void killedAgainAndAgain_theSameCommandCompletes_withTheSameFiles() throws Exception {
        Path base = folder.resolve("killed");
        // In the middle of writing a generation, just after a checkpoint, and in between.
        for (String moment : List.of(
                "initial",
                "blended-2M0_child_gen0.txt",
                "gen1",
                "checkpoint.json.gz",
                "checkpoint-previous.json.gz",
                "blended-2M0_parents_gen1.txt",
                "blended-2M0_child_other_scores_gen2.txt",
                "gen4",
                "blended-2M0_child_gen3.txt")) {
            Process process = start(base);
            awaitFile(process, base.resolve("2M0").resolve(moment));
            signal("KILL", process);
            assertThat(finish(process)).as(moment).isEqualTo(137);
        }
        assertThat(finish(start(base))).isZero();
        assertSameAsWhole(base);
    }

    @Test
    void terminatedRun_ends_saysHowToContinue_andContinues() throws Exception {
        for (Map.Entry<String, Integer> signal : Map.of("TERM", 143, "INT", 130).entrySet()) {
            Path base = folder.resolve(signal.getKey());
            Process process = start(base);
            awaitFile(process, base.resolve("2M0/checkpoint.json.gz"));
            signal(signal.getKey(), process);
            long before = System.nanoTime();
            assertThat(finish(process)).isEqualTo(signal.getValue());
            assertThat(Duration.ofNanos(System.nanoTime() - before)).isLessThan(Duration.ofMinutes(1));
            assertThat(output()).contains("give the same command again").contains("base=" + base);
            assertThat(base.resolve("2M0/lock.json")).doesNotExist();
            assertThat(finish(start(base))).isZero();
            assertSameAsWhole(base);
        }
    }

    @Test
    void isolatedRun_movedWithoutTheFileOfGhostLocations_continues() throws Exception {
        Path recording = Files.writeString(folder.resolve("recording.txt"), GhostLocations.shippedText() + "\n");
        String[] words = {"task=isolated", "runs=1", "mazePowerPillGhostMapping=" + recording};
        Path unmoved = folder.resolve("unmoved");
        assertThat(finish(start(unmoved, words))).isZero();

        Path here = folder.resolve("here");
        Process process = start(here, words);
        awaitFile(process, here.resolve("2M0/isolated-2M0_parents_gen1.txt"));
        signal("KILL", process);
        assertThat(finish(process)).isEqualTo(137);
        Path there = folder.resolve("there/deeper");
        Files.createDirectories(there);
        Files.move(here.resolve("2M0"), there.resolve("2M0"));
        Files.delete(recording);
        assertThat(finish(start(there, words))).as(output()).isZero();
        assertThat(content(there.resolve("2M0")))
                .isEqualTo(content(unmoved.resolve("2M0")))
                .containsKey("ghost-locations.txt");

        // The folder is sufficient: its parameters name its own ghost locations.
        Path again = folder.resolve("again");
        List<String> fromFile = new ArrayList<>(command(again).command());
        fromFile.removeAll(EXPERIMENT);
        fromFile.add("config=" + there.resolve("2M0/parameters.properties"));
        assertThat(finish(new ProcessBuilder(fromFile).inheritIO().start())).isZero();
        assertThat(content(again.resolve("2M0"))).isEqualTo(content(unmoved.resolve("2M0")));
    }

    @Test
    void secondProcess_isRefused_andChangesNoFile() throws Exception {
        Path base = folder.resolve("twice");
        Process first = start(base);
        awaitFile(first, base.resolve("2M0/lock.json"));
        signal("STOP", first);
        List<String> single = new ArrayList<>(command(base).command());
        single.set(single.indexOf("runs=2"), "run=0");
        Process second = new ProcessBuilder(single)
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.appendTo(new File(folder.toFile(), "output.txt")))
                .start();
        assertThat(finish(second)).as(output()).isEqualTo(3);
        assertThat(output()).contains("is in use by process " + first.pid());
        signal("CONT", first);
        assertThat(finish(first)).isZero();
        assertSameAsWhole(base);
    }

    @Test
    void fullDisk_endsWithOneLine_andTheSameCommandContinues() throws Exception {
        Path base = folder.resolve("full");
        List<String> limited = new ArrayList<>(List.of("bash", "-c", "ulimit -f 24; exec \"$@\"", "bash"));
        limited.addAll(command(base).command());
        // A limit on the size of files makes writing larger files fail, like a full disk.
        limited.add(limited.indexOf("-Xmx512m"), "-XX:-UsePerfData");
        Process process = new ProcessBuilder(limited)
                .redirectErrorStream(true)
                .redirectOutput(new File(folder.toFile(), "full.txt"))
                .start();
        assertThat(finish(process)).isEqualTo(1);
        assertThat(Files.readString(folder.resolve("full.txt")))
                .contains("complete generations are kept")
                .doesNotContain("\tat ");
        assertThat(finish(start(base))).isZero();
        assertSameAsWhole(base);
    }
}
