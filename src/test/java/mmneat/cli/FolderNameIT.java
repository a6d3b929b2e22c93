package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import mmneat.ProgramRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Folders with names that the locale cannot represent: Java would create and use another folder with a similar name.
 */
class FolderNameIT {

    private static final Path JAR =
            Path.of(System.getProperty("mmneat.jar", "target/mmneat.jar")).toAbsolutePath();

    @TempDir
    Path folder;

    @Test
    void inAFolderThatTheLocaleCannotRepresent_nothingIsWritten_andTheReasonIsReported() throws Exception {
        ProgramRun run = runIn("C");
        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.errors())
                .contains("letters that the locale cannot represent")
                .contains("LC_ALL=C.UTF-8");
        assertThat(place().toFile().list()).hasSize(1);
    }

    @Test
    void inAFolderThatTheLocaleCanRepresent_theProgramRuns() throws Exception {
        ProgramRun run = runIn("C.UTF-8");
        assertThat(run.exitCode()).isZero();
        assertThat(run.output()).contains("MM-NEAT");
    }

    private ProgramRun runIn(String locale) throws Exception {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        Files.createDirectory(place());
        String script = "cd place; name=$(printf 'M\\303\\274hle'); mkdir \"$name\"; cd \"$name\"; LC_ALL=" + locale
                + " '" + java + "' -jar '" + JAR + "' --version";
        return ProgramRun.of(folder, List.of("sh", "-c", script));
    }

    private Path place() {
        return folder.resolve("place");
    }
}
