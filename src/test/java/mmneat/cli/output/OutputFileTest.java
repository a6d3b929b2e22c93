package mmneat.cli.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files that a command writes for the user. */
class OutputFileTest {

    @TempDir
    private Path folder;

    @Test
    void file_isReplaced_andNothingElseIsLeft() throws IOException {
        Path file = Files.writeString(folder.resolve("page.html"), "old");
        OutputFile.write(file, "new");
        assertThat(file).hasContent("new");
        OutputFile.write(folder.resolve("a/b.svg"), "made");
        assertThat(folder.resolve("a/b.svg")).hasContent("made");
        try (var files = Files.list(folder)) {
            assertThat(files).containsExactlyInAnyOrder(file, folder.resolve("a"));
        }
    }

    @Test
    void failedWrite_leavesTheOldFile() throws IOException {
        Path file = Files.writeString(folder.resolve("page.html"), "old");
        // A folder with the name of the temporary file prevents writing the new content, like a full disk.
        Files.createDirectories(folder.resolve("page.html.unfinished"));
        assertThatThrownBy(() -> OutputFile.write(file, "new"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("page.html: cannot be written");
        assertThat(file).hasContent("old");
    }

    @Test
    void symbolicLink_stays_andItsFileIsReplaced() throws IOException {
        Path file = Files.writeString(folder.resolve("page.html"), "old");
        Path link = Files.createSymbolicLink(folder.resolve("link.html"), file);
        OutputFile.write(link, "new");
        assertThat(link).isSymbolicLink();
        assertThat(file).hasContent("new");
    }

    @Test
    void device_isWrittenTo() {
        Path device = Path.of("/dev/null");
        assumeThat(device).exists();
        OutputFile.write(device, "gone");
        assertThat(Files.isRegularFile(device)).isFalse();
        Path full = Path.of("/dev/full");
        assumeThat(full).exists();
        assertThatThrownBy(() -> OutputFile.write(full, "x")).hasMessageContaining("No space left on device");
    }
}
