package mmneat.experiment.store;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RunFolderTest {

    @TempDir
    Path directory;

    @Test
    void appendedRows_reachTheirFilesWithTheNextFlush() throws IOException {
        RunFolder folder = new RunFolder(directory, "x0_");
        folder.append("x0_a_log.txt", "0\n");
        assertThat(directory).isEmptyDirectory();
        assertThat(folder.flush()).isEqualTo(Map.of("x0_a_log.txt", 2L));
        folder.append("x0_a_log.txt", "1\n");
        folder.append("sub/b.txt", "\u00e9\n");
        assertThat(folder.flush()).isEqualTo(Map.of("x0_a_log.txt", 4L, "sub/b.txt", 3L));
        assertThat(directory.resolve("x0_a_log.txt")).hasContent("0\n1\n");
    }

    @Test
    void cutTo_removesRowsAfterTheCheckpoint() throws IOException {
        RunFolder folder = new RunFolder(directory, "x0_");
        folder.append("log.txt", "0\n");
        Map<String, Long> checkpoint = folder.flush();
        folder.append("log.txt", "half a ro");
        folder.append("later.txt", "0\n");
        folder.flush();

        RunFolder resumed = new RunFolder(directory, "x0_");
        resumed.cutTo(checkpoint);
        assertThat(directory.resolve("log.txt")).hasContent("0\n");
        resumed.append("log.txt", "1\n");
        resumed.append("later.txt", "1\n");
        resumed.flush();
        assertThat(directory.resolve("log.txt")).hasContent("0\n1\n");
        assertThat(directory.resolve("later.txt")).hasContent("1\n");
    }

    @Test
    void logShorterThanInTheCheckpoint_isAnErrorWithAdvice() throws IOException {
        Files.writeString(directory.resolve("log.txt"), "0");
        assertThatThrownBy(() -> new RunFolder(directory, "x0_").cutTo(Map.of("log.txt", 2L)))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("has 1 bytes")
                .hasMessageContaining("restore the file");
    }

    @Test
    void fileThatCannotBeWritten_leavesTheOldOne() throws IOException {
        RunFolder folder = new RunFolder(directory, "x0_");
        folder.write("score.txt", "old");
        folder.flush();
        // A folder with the name of the temporary file makes the write fail, like a full disk.
        Files.createDirectory(directory.resolve("score.txt.unfinished"));
        folder.write("score.txt", "new");
        assertThatThrownBy(folder::flush).isInstanceOf(UncheckedIOException.class);
        assertThat(directory.resolve("score.txt")).hasContent("old");
    }

    @Test
    void deletedFolder_isNoLongerUnsynced() throws IOException {
        RunFolder folder = new RunFolder(directory, "x0_");
        folder.write("gen1/a.xml", "x");
        folder.write("gen10/a.xml", "x");
        folder.flush();
        folder.writeDerived("gen1/b.xml", "x");
        folder.deleteFolder("gen1");
        assertThat(folder.unsynced().stretches()).containsOnlyKeys("gen10/a.xml");
        folder.syncAll();
        assertThat(folder.unsynced().count()).isZero();
    }

    @Test
    void deleteFolder_deletesItsFiles_andNothingElse() throws IOException {
        RunFolder folder = new RunFolder(directory, "x0_");
        folder.write("gen1/a/b.xml", "x");
        folder.write("gen2/b.xml", "x");
        folder.flush();
        folder.deleteFolder("gen1");
        folder.deleteFolder("gen7");
        assertThat(directory.resolve("gen1")).doesNotExist();
        assertThat(directory.resolve("gen2/b.xml")).hasContent("x");
    }
}
