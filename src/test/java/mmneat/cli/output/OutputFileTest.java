package mmneat.cli.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

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

    @ParameterizedTest
    @ValueSource(
            strings = {
                "parameters.properties",
                "champion.json",
                "generations.csv",
                "checkpoint.json.gz",
                "checkpoint-previous.json.gz",
                "checkpoint.json.gz.unfinished",
                "status.json",
                "lock.json",
                "ghost-locations.txt",
                "archetype0.xml",
                "bestPacMan/bestPacMan.xml",
                "bestObjectives/score1.txt",
                "evaluation-training.json",
                "evaluation-training.csv",
                "blended-2M0_parents_log.txt",
                "blended-2M0_Eval-Net55_log.txt",
                "blended-2M0_child_gen7.txt",
                "gen7/blended-2M0_gen7_3.xml"
            })
    void fileOfARun_isRefused(String name) throws IOException {
        Path run = Files.createDirectories(folder.resolve("2M0"));
        Files.writeString(run.resolve("parameters.properties"), "task=blended");
        Files.writeString(run.resolve("blended-2M0_parents_log.txt"), "");
        Path link = Files.createSymbolicLink(folder.resolve("link"), run);
        for (Path file : List.of(
                run.resolve(name), link.resolve(name), run.resolve("../2M0").resolve(name))) {
            assertThatThrownBy(() -> OutputFile.require("out", file))
                    .isInstanceOf(UserError.class)
                    .hasMessageStartingWith("out=" + file + ": a file of this name belongs to the run in ")
                    .hasMessageEndingWith("2M0; give another name");
            assertThatThrownBy(() -> OutputFile.write(file, "x")).isInstanceOf(UserError.class);
        }
        assertThat(run.resolve("parameters.properties")).hasContent("task=blended");
        // In other folders the name is free.
        OutputFile.require("out", folder.resolve("own").resolve(name));
        OutputFile.write(folder.resolve("own").resolve(name), "x");
    }

    @Test
    void listOfTheRunsOfAnExperiment_isRefused() throws IOException {
        Path file = Files.writeString(folder.resolve("blended-2M.runs.json"), "{}");
        assertThatThrownBy(() -> OutputFile.require("out", file))
                .isInstanceOf(UserError.class)
                .hasMessage("out=" + file + ": this is the list of an experiment's runs; give another name");
        assertThatThrownBy(() -> OutputFile.write(file, "x")).isInstanceOf(UserError.class);
        assertThat(file).hasContent("{}");
    }

    @Test
    void linkToAFileOfARun_isRefused() throws IOException {
        Path run = Files.createDirectories(folder.resolve("2M0"));
        Path file = Files.writeString(run.resolve("parameters.properties"), "task=blended");
        Path link = Files.createSymbolicLink(folder.resolve("page.html"), file);
        assertThatThrownBy(() -> OutputFile.write(link, "x")).hasMessageContaining("belongs to the run in");
    }

    @Test
    void newFileInTheFolderOfARun_isAllowed() throws IOException {
        Path run = Files.createDirectories(folder.resolve("2M0"));
        Files.writeString(run.resolve("parameters.properties"), "task=blended");
        for (String name : List.of("game.html", "pairs.csv", "notes.txt", "net.json", "pictures/champion.json")) {
            OutputFile.require("out", run.resolve(name));
            OutputFile.write(run.resolve(name), "1");
            OutputFile.write(run.resolve(name), "2");
            assertThat(run.resolve(name)).hasContent("2");
        }
    }

    @Test
    void oneFileForTwoPurposes_isRefused() throws IOException {
        Path file = Files.writeString(folder.resolve("a.txt"), "");
        Path link = Files.createSymbolicLink(folder.resolve("b.txt"), file);
        assertThatThrownBy(() -> OutputFile.requireOther("latex", link, "csv=a.txt", file))
                .isInstanceOf(UserError.class)
                .hasMessage("latex=" + link + ": this is also the file of csv=a.txt; give another name");
        assertThatThrownBy(() -> OutputFile.requireOther(
                        "latex", folder.resolve("new/../c.txt"), "csv=c.txt", folder.resolve("c.txt")))
                .isInstanceOf(UserError.class);
        OutputFile.requireOther("latex", folder.resolve("c.txt"), "csv", file);
    }

    @Test
    void standardOutput_isRefused_notAFileOfThisName() {
        assertThatThrownBy(() -> OutputFile.require("out", Path.of("-")))
                .hasMessage("out=-: standard output is not possible here; name a file or folder");
        assertThatThrownBy(() -> OutputFile.requireFolder("figures", Path.of("-")))
                .hasMessage("figures=-: standard output is not possible here; name a file or folder");
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
