package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import mmneat.GoldenData;
import mmneat.neat.io.GenotypeXml;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Commands read the folder of a run of the original's later versions. */
@Tag("conformance")
class LaterVersionRunTest extends CommandTest {

    private static final String PARAMETERS = "P-MMD0_parameters.txt";

    @TempDir
    private Path folder;

    private Path run;

    /** Makes the files of a recorded run with the names, packages and parameters of later versions. */
    @BeforeEach
    void makeRun() throws IOException {
        run = Files.createDirectories(folder.resolve("MMD0"));
        try (Stream<Path> files = Files.list(GoldenData.folder("logs"))) {
            for (Path file : files.filter(f -> f.getFileName().toString().startsWith("P-MMD0_"))
                    .toList()) {
                Files.copy(file, run.resolve(file.getFileName().toString()));
            }
        }
        String parameters = Files.readString(run.resolve(PARAMETERS))
                .replace("edu.utexas.cs.nn.", "edu.southwestern.")
                .replace("startingModes:", "startingModules:")
                .replaceFirst(
                        "(?m)^experiment:.*$", "experiment:edu.southwestern.experiment.post.BestNetworkExperiment")
                .replaceFirst("(?m)^ignorePillScore:.*$", "ignorePillScore:true")
                .replaceFirst("(?m)^watch:.*$", "watch:true");
        Files.writeString(
                run.resolve(PARAMETERS),
                parameters + "minecraftRange:10\nbiasChance:0.0\nsmallerGenotypes:false\nnewAgent:x=y;z\n");
        Path champion = Files.createDirectories(run.resolve("bestPacMan")).resolve("bestPacMan.xml");
        try (InputStream xml = GenotypeXml.class.getResourceAsStream("champion-of-2016-10.xml.gz")) {
            Files.write(champion, new GZIPInputStream(xml).readAllBytes());
        }
    }

    private void replaceParameter(String name, String value) throws IOException {
        Path file = run.resolve(PARAMETERS);
        List<String> lines = Files.readAllLines(file).stream()
                .map(line -> line.startsWith(name + ":") ? name + ":" + value : line)
                .toList();
        Files.write(file, lines);
    }

    @Test
    void network_isDrawn_withItsSensors() throws IOException {
        Path graph = folder.resolve("network.dot");
        assertThat(execute("network", run.toString(), "out=" + graph)).isZero();
        assertThat(graph).content().contains("Edible ghosts").contains("Ghost 4 edible");
    }

    @Test
    void champion_isEvaluatedWatchedAndPlayed() {
        assertThat(execute("evaluate", run.toString(), "games=2"))
                .as(errors.toString())
                .isZero();
        Path page = folder.resolve("game.html");
        assertThat(execute("watch", run.toString(), "out=" + page)).isZero();
        assertThat(page).isNotEmptyFile();
        assertThat(execute("play", "pacman=" + run)).isZero();
    }

    @Test
    void run_isComparedAndReported() {
        assertThat(execute("compare", folder.toString())).as(errors.toString()).isZero();
        Path report = folder.resolve("report");
        assertThat(execute("report", folder.toString(), "out=" + report))
                .as(errors.toString())
                .isZero();
    }

    @Test
    void champion_ofAScoreInAnotherColumn_isFoundByTheScript() throws IOException {
        Path log = run.resolve("P-MMD0_parents_log.txt");
        Path script = run.resolve("P-MMD0_parents_log.plot");
        // One more objective before the others: four more columns.
        Files.write(
                log,
                Files.readAllLines(log).stream()
                        .map(line -> line.replaceFirst("\t", "\t1.0\t2.0\t3.0\t0.5\t"))
                        .toList());
        String shifted = Files.readString(script);
        for (int column = 150; column >= 2; column--) {
            shifted = shifted.replace(" u 1:" + column + " t", " u 1:" + (column + 4) + " t");
        }
        execute("compare", folder.toString());
        String expected = out.toString();
        Files.writeString(script, shifted);
        out.getBuffer().setLength(0);

        assertThat(execute("compare", folder.toString())).isZero();
        assertThat(out.toString()).isNotEqualTo(expected);
    }

    @Test
    void missingGhostLocations_areAnError_onlyIfGamesNeedThem() throws IOException {
        replaceParameter("task", "edu.southwestern.tasks.mspacman.MsPacManPillsVsEdibleFromCornersMultitask");
        replaceParameter("imprisonedWhileEdible", "true");
        replaceParameter("mazePowerPillGhostMapping", "data/pacman/PowerPillToGhostLocationMapping.txt");
        Path champion = run.resolve("bestPacMan/bestPacMan.xml");
        Path network = run.resolveSibling("network.xml");
        assertThat(execute("network", "champion=isolated", "format=xml", "out=" + network))
                .isZero();
        Files.move(network, champion, StandardCopyOption.REPLACE_EXISTING);

        assertThat(execute("play", "pacman=" + run)).as(errors.toString()).isZero();
        assertMistake(
                "the file with the ghost locations of its run is not in the run's folder",
                "evaluate",
                run.toString(),
                "games=2");
        Path locations = GoldenData.folder("ghost-locations").resolve("PowerPillToGhostLocationMapping.txt");
        assertThat(execute("evaluate", run.toString(), "games=2", "ghosts=" + locations))
                .as(errors.toString())
                .isZero();
    }

    @Test
    void featureThatGamesNeed_isNamed_ifItIsMissing() throws IOException {
        replaceParameter("absenceNegative", "true");

        assertThat(execute("evaluate", run.toString(), "games=2")).isEqualTo(2);
        assertThat(errors.toString()).contains("absenceNegative");
    }
}
