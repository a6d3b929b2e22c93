package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Folders whose names the locale cannot tell: Java would take another folder of a similar name, and make it. */
class FolderNameIT {

    private static final Path JAR =
            Path.of(System.getProperty("mmneat.jar", "target/mmneat.jar")).toAbsolutePath();

    @TempDir
    Path folder;

    @Test
    void inAFolderThatTheLocaleCannotTell_nothingIsWritten_andTheReasonIsSaid() throws Exception {
        assertThat(runIn("C"))
                .contains("exit 2")
                .contains("letters that the locale cannot tell")
                .contains("LC_ALL=C.UTF-8");
        assertThat(folder.toFile().list()).hasSize(1);
    }

    @Test
    void inAFolderThatTheLocaleCanTell_theProgramRuns() throws Exception {
        assertThat(runIn("C.UTF-8")).contains("exit 0").contains("MM-NEAT");
    }

    private String runIn(String locale) throws Exception {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        Process shell = new ProcessBuilder(
                        "sh",
                        "-c",
                        "name=$(printf 'M\\303\\274hle'); mkdir \"$name\"; cd \"$name\"; LC_ALL=" + locale + " '" + java
                                + "' -jar '" + JAR + "' --version; echo exit $?")
                .directory(new File(folder.toString()))
                .redirectErrorStream(true)
                .start();
        return new String(shell.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
}
