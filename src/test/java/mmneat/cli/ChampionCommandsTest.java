package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import mmneat.neat.io.GenotypeJson;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Commands with the shipped champions, as a user types them. */
class ChampionCommandsTest extends CommandTest {

    @TempDir
    private Path folder;

    /** Asserts a user's error that may be found late; a slow machine may print progress before it. */
    private void assertMistakeAtWork(String message, String... arguments) {
        assertThat(execute(arguments)).isEqualTo(2);
        assertThat(errors.toString().lines().filter(line -> line.startsWith("mmneat: ")))
                .hasSize(1);
        assertThat(errors.toString()).contains(message);
    }

    @Test
    void everyShippedChampion_isWatched() throws IOException {
        for (String version : new String[] {"blended", "interleaved", "isolated"}) {
            Path page = folder.resolve(version + ".html");
            assertThat(execute("watch", "champion=" + version, "out=" + page)).isZero();
            assertThat(out.toString()).startsWith("champion-" + version + ", training: ");
            assertThat(Files.size(page)).isLessThan(3_000_000);
        }
    }

    @Test
    void fileOfARun_isNotReplaced() throws IOException {
        Path run = Files.createDirectory(folder.resolve("2M0"));
        Files.writeString(run.resolve("parameters.properties"), "task=blended");
        Path champion = Files.writeString(run.resolve("champion.json"), "{}");
        String mistake = "champion.json: a file of this name belongs to the run in ";
        assertMistake(mistake, "network", "champion=blended", "out=" + champion);
        assertMistake(mistake, "record-ghosts", "out=" + champion);
        assertMistake(mistake, "play", "record=" + champion);
        assertMistake(mistake, "tasks", "task=blended", "games=1", "out=" + champion);
        Path page = Files.createSymbolicLink(folder.resolve("page.html"), champion);
        assertMistake("belongs to the run in", "watch", "champion=blended", "out=" + page);
        assertMistake("belongs to the run in", "replay", "game.txt", "out=" + page);
        assertThat(champion).hasContent("{}");
    }

    @Test
    void fileThatIsRead_isNotReplaced() throws IOException {
        Path network = folder.resolve("net.json");
        assertThat(execute("network", "champion=blended", "out=" + network)).isZero();
        String before = Files.readString(network);
        String mistake = "this is also the file of ";
        assertMistake(mistake, "network", network.toString(), "out=" + network);
        assertMistake(mistake, "record-ghosts", network.toString(), "out=" + network);
        assertMistake(mistake, "play", "pacman=" + network, "record=" + network);
        assertMistake(mistake, "tasks", "task=blended", "players=" + network, "out=" + network);
        assertThat(network).hasContent(before);
    }

    @Test
    void gameAsGif_isWritten() throws IOException {
        Path gif = folder.resolve("game.gif");
        assertThat(execute("watch", "champion=blended", "out=" + gif)).isZero();
        assertThat(new String(Files.readAllBytes(gif), 0, 6, java.nio.charset.StandardCharsets.US_ASCII))
                .isEqualTo("GIF89a");
    }

    @Test
    void windowWithoutDisplay_isRefusedInOneLine() {
        org.junit.jupiter.api.Assumptions.assumeTrue(java.awt.GraphicsEnvironment.isHeadless());
        assertMistakeAtWork(
                "window=true needs a display, and there is none", "watch", "champion=blended", "window=true");
    }

    @Test
    void championIsPlayed() {
        assertThat(execute("play", "pacman=champion:blended", "rules=blended")).isZero();
        assertThat(out.toString()).startsWith("champion:blended against Legacy, 1 game");
        assertMistakeAtWork(
                "pacman=champion:x: must be champion: and one of blended, interleaved, isolated, blended-2M2",
                "play",
                "pacman=champion:x");
    }

    @Test
    void bestChampionOfTheStudy_isShippedAsTheStudyHasIt() throws IOException {
        Path written = folder.resolve("champion.json");
        assertThat(execute("network", "champion=blended-2M2", "format=json", "out=" + written))
                .isZero();
        assertThat(GenotypeJson.read(Files.readString(written)))
                .isEqualTo(GenotypeJson.read(Files.readString(Path.of("docs/study/blended/2M2/champion.json"))));
        assertThat(execute("play", "pacman=champion:blended-2M2", "rules=blended"))
                .isZero();
    }

    @Test
    void unknownOrAmbiguousChampion_isAnError() {
        assertMistakeAtWork("no network is given", "watch");
        assertMistakeAtWork(
                "champion=x: must be one of blended, interleaved, isolated, blended-2M2", "watch", "champion=x");
        assertMistakeAtWork("both a file and champion= are given", "watch", "champion.json", "champion=blended");
    }

    @Test
    void ghosts_areRecorded_reproducibly() throws IOException {
        Path first = folder.resolve("first.txt");
        Path second = folder.resolve("second.txt");
        assertThat(execute("record-ghosts", "situations=1", "seed=3", "out=" + first))
                .isZero();
        assertThat(out.toString()).contains("16 situations from ").contains("mazePowerPillGhostMapping=" + first);
        assertThat(execute("record-ghosts", "situations=1", "seed=3", "out=" + second))
                .isZero();
        assertThat(first).hasSameTextualContentAs(second);
        assertThat(Files.readAllLines(first)).hasSize(16).allMatch(line -> line.matches("[0-3](\t\\d+){5}"));
    }

    @Test
    void recordingThatGivesUp_reportsMissingObservations_andKeepsTheOthers() {
        Path file = folder.resolve("few.txt");
        assertMistakeAtWork("out=" + folder + ": this is a folder", "record-ghosts", "out=" + folder);
        assertMistakeAtWork("out=" + folder + ": this is a folder", "tasks", "out=" + folder);
        assertMistakeAtWork("have no power pills to be eaten", "record-ghosts", "champion=isolated");
        assertMistakeAtWork("gave up after 1 games, with", "record-ghosts", "games=1", "situations=5", "out=" + file);
        assertThat(errors.toString()).contains("still missing: maze 0 power pill 0 (");
        assertThat(file).doesNotExist();
        assertThat(folder.resolve("few.txt.incomplete")).exists();
    }

    @Test
    void tasks_areMeasured_forEveryVersion() throws IOException {
        Path csv = folder.resolve("tasks.csv");
        assertThat(execute(
                        "tasks", "games=3", "players=NearestPillPacMan,champion:blended", "task=blended", "out=" + csv))
                .isZero();
        assertThat(out.toString())
                .startsWith("blended, divided by threats,edible")
                .contains("NearestPillPacMan")
                .contains("overlap in");
        assertThat(Files.readAllLines(csv)).hasSize(7);
        assertMistakeAtWork("players=,: a name is missing", "tasks", "players=,");
        assertMistakeAtWork("players=StarterPacMan,: a name is missing", "tasks", "players=StarterPacMan,");
        assertMistakeAtWork("predicates=,: '' is not one of threats", "tasks", "predicates=,");
        assertMistakeAtWork("predicates=threats,edible,: '' is not one", "tasks", "predicates=threats,edible,");
        assertMistakeAtWork("predicates=x: must be two or more of threats", "tasks", "predicates=x");
    }
}
