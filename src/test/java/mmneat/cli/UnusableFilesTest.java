package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Folders of runs with files that cannot be read as what they are called: each command says so in one line. */
class UnusableFilesTest extends CommandTest {

    @TempDir
    Path base;

    private Path folder;

    @BeforeEach
    void finishedRun() {
        folder = run("blended");
    }

    /** Makes a finished run and returns its folder. */
    private Path run(String task) {
        Path experiment = base.resolve(task);
        assertThat(execute("task=" + task, "mu=4", "maxGens=1", "trials=1", "quiet=true", "base=" + experiment))
                .as(errors.toString())
                .isZero();
        return experiment.resolve("2M0");
    }

    static Stream<Arguments> tooLarge() {
        return Stream.of(
                Arguments.of("status.json", "status"),
                Arguments.of("parameters.properties", "status"),
                Arguments.of("lock.json", "status"),
                Arguments.of("parameters.properties", "compare"),
                Arguments.of("generations.csv", "compare"),
                Arguments.of("evaluation-training.csv", "evaluate"),
                Arguments.of("evaluation-training.csv", "report"),
                Arguments.of("champion.json", "watch"));
    }

    @ParameterizedTest
    @MethodSource("tooLarge")
    void filesLargerThanTheMemory_areNamed(String name, String command) throws IOException {
        try (RandomAccessFile file = new RandomAccessFile(folder.resolve(name).toFile(), "rw")) {
            file.setLength(3L << 30);
        }
        String argument =
                command.equals("watch") ? folder.toString() : folder.getParent().toString();
        assertMistake(name + ": ", command, argument);
        assertThat(errors.toString()).contains("larger than");
    }

    @ParameterizedTest
    @ValueSource(strings = {"{}", "{\"state\":null}", "null", "[]", "{\"state\":\"RUNNING\",\"generation\":-1}", "1"})
    void statusThatSaysNothing_countsAsNone(String json) throws IOException {
        Files.writeString(folder.resolve("status.json"), json);
        assertNotFinished();
    }

    /** Asserts that {@code status} sees an unfinished run: exit code 4. */
    private void assertNotFinished() {
        assertThat(execute("status", folder.getParent().toString())).isEqualTo(4);
        assertThat(errors.toString()).isEmpty();
        assertThat(out.toString()).contains("0 of 1 finished");
    }

    @ParameterizedTest
    @ValueSource(strings = {"null", "[]", "{}", "1", "{\"pid\":null}"})
    void lockThatNamesNoHolder_isJudgedByItsAge(String json) throws IOException {
        Files.writeString(folder.resolve("lock.json"), json);
        assertNotFinished();
        String experiment = folder.getParent().toString();
        assertThat(execute("task=blended", "mu=4", "maxGens=2", "trials=1", "quiet=true", "base=" + experiment))
                .isEqualTo(3);
        assertThat(errors.toString())
                .contains("is in use by an unknown process")
                .hasLineCount(1);
    }

    @Test
    void folderInPlaceOfAFile_isNamed() throws IOException {
        Files.delete(folder.resolve("status.json"));
        Files.createDirectory(folder.resolve("status.json"));
        assertMistake(
                "status.json: it is a folder", "status", folder.getParent().toString());
    }

    @ParameterizedTest
    @CsvSource({"watch", "evaluate", "play"})
    void recordingOutsideOfTheFolder_isNotRead(String command) throws IOException {
        folder = run("isolated");
        Path secret = Files.writeString(base.resolve("secret.txt"), "token-123\n");
        Path parameters = folder.resolve("parameters.properties");
        String text = Files.readString(parameters);
        for (String name :
                new String[] {secret.toString(), "../../secret.txt", "/dev/zero", "./ghost-locations.txt", "/"}) {
            Files.writeString(
                    parameters,
                    text.replaceFirst("(?m)^mazePowerPillGhostMapping=.*$", "mazePowerPillGhostMapping=" + name));
            String[] words = command.equals("play")
                    ? new String[] {"play", "pacman=" + folder, "games=1"}
                    : new String[] {command, folder.toString()};
            int code = execute(words);
            assertThat(errors.toString()).doesNotContain("token");
            assertThat(out.toString()).doesNotContain("token");
            if (!command.equals("play")) {
                assertThat(code).isEqualTo(2);
                assertThat(errors.toString())
                        .contains("is not in the run's folder: " + name)
                        .hasLineCount(1);
            }
        }
    }
}
