package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import mmneat.analysis.results.RunFixture;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.neat.io.GenotypeFiles;
import mmneat.neat.io.GenotypeJson;
import mmneat.neat.variation.InitialNetworks;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class NetworkCommandTest extends CommandTest {

    private static final Genotype NETWORK =
            new InitialNetworks(3, ModuleLayout.withPreferenceNeurons(2, 1)).create(7, new ResumableRandom(5));

    @TempDir
    private Path folder;

    private Path file;

    @BeforeEach
    void writeNetwork() throws IOException {
        file = Files.writeString(folder.resolve("champion.json"), GenotypeJson.write(NETWORK));
    }

    @Test
    void network_isDrawnAsSvg_byDefault() {
        assertThat(execute("network", file.toString(), "out=-")).isZero();
        assertThat(out.toString()).startsWith("<svg").contains("Network 7: 3 inputs");
    }

    @Test
    void format_isTakenFromTheEndingOfTheFile() throws IOException {
        Path xml = folder.resolve("champion.xml");

        assertThat(execute("network", file.toString(), "out=" + xml)).isZero();

        assertThat(GenotypeFiles.read(xml)).isEqualTo(NETWORK);
        assertThat(out.toString().strip()).isEqualTo(xml.toString());
    }

    @Test
    void network_isWrittenToAFile_whoseNameIsPrinted() throws IOException {
        Path written = Path.of("champion-blended-network.svg");
        try {
            assertThat(execute("network", "champion=blended")).isZero();
            assertThat(out.toString().strip()).isEqualTo(written.toString());
            assertThat(written).content().startsWith("<svg");
        } finally {
            Files.deleteIfExists(written);
        }
    }

    @Test
    void format_canBeNamed() {
        assertThat(execute("network", file.toString(), "format=dot", "out=-")).isZero();
        assertThat(out.toString()).startsWith("digraph");
        assertThat(execute("network", file.toString(), "format=graphml", "out=-"))
                .isZero();
        assertThat(out.toString()).contains("<graphml");
    }

    @Test
    void unknownFormat_isAnError() {
        assertThat(execute("network", file.toString(), "format=pdf")).isEqualTo(2);
        assertThat(errors.toString()).startsWith("mmneat: format=pdf: must be one of svg, dot, graphml, json, xml");
    }

    @Test
    void inputs_areNamed_byTheTaskOfTheRun() throws IOException {
        Path run = RunFixture.run(folder, "blended", "2M", 0, 1000, 2000);
        Path champion = Files.writeString(
                run.resolve("champion.json"),
                GenotypeJson.write(new InitialNetworks(30, ModuleLayout.withPreferenceNeurons(2, 1))
                        .create(1, new ResumableRandom(5))));
        assertThat(execute("network", run.toString(), "out=-")).isZero();
        assertThat(out.toString()).contains("Ghost 4 approaching", "module 2");
        assertThat(errors.toString()).isEmpty();

        Path alone = Files.copy(champion, folder.resolve("alone.json"));
        assertThat(execute("network", alone.toString(), "out=-")).isZero();
        assertThat(errors.toString())
                .startsWith("network: inputs named as in task=blended, which has the same number of inputs");
        assertThat(execute("network", alone.toString(), "task=isolated")).isEqualTo(2);
        assertThat(errors.toString()).contains("30 inputs, but this version of the task has 26 sensors");
    }

    @Test
    void inputs_ofAnUnknownTask_areNumbered_andTheReasonIsTold() {
        assertThat(execute("network", file.toString(), "out=-")).isZero();
        assertThat(out.toString()).contains("input 2", "module 1");
        assertThat(errors.toString().lines()).hasSize(1);
        assertThat(errors.toString()).startsWith("network: inputs are numbered: ");
        assertThat(execute("network", file.toString(), "task=none", "out=-")).isZero();
        assertThat(errors.toString()).isEmpty();
    }

    @Test
    void missingFile_isAnError() {
        assertThat(execute("network", folder.resolve("none.json").toString())).isEqualTo(2);
        assertThat(errors.toString()).contains("none.json: there is no such file");
    }

    @Test
    void folderWithoutChampion_isAnError() throws IOException {
        Path empty = Files.createDirectory(folder.resolve("empty"));
        assertThat(execute("network", empty.toString())).isEqualTo(2);
        assertThat(errors.toString()).contains("there is no champion in this folder");
    }

    @Test
    void folderOfAnExperiment_isAnError_thatNamesARun() throws IOException {
        for (int number : new int[] {1, 0}) {
            Path run = RunFixture.run(folder, "blended", "2M", number, 1000);
            RunFixture.champion(run, ModuleLayout.withPreferenceNeurons(2, 1), 1);
        }
        Path experiment = folder.resolve("blended");
        assertMistake(
                "; give the folder of a run, for example " + experiment.resolve("2M0"),
                "network",
                experiment.toString());
    }

    @Test
    void missingName_isAnError() {
        assertThat(execute("network")).isEqualTo(2);
        assertThat(errors.toString()).contains("no network is given");
    }

    @Test
    void damagedFile_isAnError_inOneLine() throws IOException {
        Files.writeString(file, GenotypeJson.write(NETWORK).replace("\"modules\" : 2", "\"modules\" : \"two\""));

        assertThat(execute("network", file.toString())).isEqualTo(2);
        assertThat(errors.toString().lines()).hasSize(1);
        assertThat(errors.toString()).contains("champion.json: modules: ");
    }
}
