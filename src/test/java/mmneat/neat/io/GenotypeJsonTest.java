package mmneat.neat.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.neat.variation.InitialNetworks;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class GenotypeJsonTest {

    private static final Genotype NETWORK =
            new InitialNetworks(3, ModuleLayout.withPreferenceNeurons(2, 1)).create(7, new ResumableRandom(5));

    @Test
    void writtenGenotype_isReadUnchanged() throws IOException {
        assertThat(GenotypeJson.read(GenotypeJson.write(NETWORK))).isEqualTo(NETWORK);
    }

    @Test
    void writtenGenotype_hasOneGenePerLine() {
        assertThat(GenotypeJson.write(NETWORK).lines())
                .contains("  \"version\" : 1,")
                .contains("    { \"innovation\" : -1, \"type\" : \"input\", \"activation\" : \"tanh\" },");
    }

    @Test
    void exampleOfTheDocumentation_isWrittenAgain_characterForCharacter() throws IOException {
        String page = Files.readString(Path.of("docs", "genotype-format.md"));
        int start = page.indexOf("```json\n") + "```json\n".length();
        String example = page.substring(start, page.indexOf("```", start));

        assertThat(GenotypeJson.write(GenotypeJson.read(example))).isEqualTo(example);
    }

    @Test
    void genotypeInsideAnotherDocument_isReadUnchanged() throws IOException {
        JsonMapper mapper =
                JsonMapper.builder().addModule(GenotypeJson.module()).build();
        record Checkpoint(int generation, List<Genotype> population) {}
        Checkpoint checkpoint = new Checkpoint(3, List.of(NETWORK, NETWORK.withId(8)));

        String json = mapper.writeValueAsString(checkpoint);

        assertThat(mapper.readValue(json, Checkpoint.class)).isEqualTo(checkpoint);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    "version" : 1               | "version" : 2                | version: this program reads version 1, the file has 2
                    "mmneat-genotype"           | "neat-python"                | format: must be "mmneat-genotype", is "neat-python"
                    "inputs" : 3                | "inputs" : "3"               | inputs: must be a whole number
                    "inputs" : 3                | "inputs" : 2                 | nodes[2]: must be of type HIDDEN
                    "inputs" : 3                | "inputs" : null              | inputs: must be a whole number
                    "inputs" : 3                | "inputs" : 3, "bias" : 1     | bias: unknown field
                    "inputs" : 3,               |                              | inputs: is missing
                    "id" : 7                    | "id" : 7, "id" : 7           | Duplicate field 'id'
                    "modules" : 2               | "modules" : 2.5              | modules: must be a whole number
                    "type" : "output"           | "type" : "motor"             | nodes[3].type: must be one of input, hidden, output, is "motor"
                    "activation" : "tanh"       | "activation" : "relu"        | nodes[0].activation: must be one of logistic, tanh
                    "source" : -1               | "source" : 12                | links[0]: no node has innovation 12
                    "active" : true             | "active" : "yes"             | links[0].active: must be true or false
                    "nodes" : [                 | "nodes" : {}, "links" : [    | nodes: must be a list
                    "type" : "output"           | "type" : {}                  | nodes[3].type: must be a text
                    "version" : 1,              | "version" : 2, "genes" : [], | version: this program reads version 1, the file has 2
                    "format"                    | "form"                       | format: is missing
                    "outputs" : 4               | "outputs" : 5                | outputs: 5 cannot be 2 modules
                    "outputs" : 4               | "outputs" : -2147483648      | outputs: -2147483648 cannot be 2 modules
                    "inputs" : 3                | "inputs" : 2147483647        | too few for 2147483647 inputs
                    "active" : true             | "active" : true, "delay" : 1 | links[0].delay: unknown field
                    "moduleUsage" : [           | "moduleUsage" : [ 1, 1,      | moduleUsage: has 4 numbers, more than the 2 modules
                    """)
    void damagedDocument_isRefused_namingTheField(String good, String bad, String message) {
        String json = GenotypeJson.write(NETWORK);
        assertThat(json).contains(good);

        assertThatThrownBy(() -> GenotypeJson.read(json.replace(good, bad == null ? "" : bad)))
                .isInstanceOf(GenotypeFormatException.class)
                .hasMessageContaining(message)
                .hasMessageNotContaining("\n");
    }

    @Test
    void documentThatEndsTooEarly_isRefused_namingOnePlace() {
        String json = GenotypeJson.write(NETWORK);

        assertThatThrownBy(() -> GenotypeJson.read(json.substring(0, json.indexOf("links"))))
                .hasMessageMatching("(\\w+: )?the file ends too early \\(line \\d+, column \\d+\\)");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "null", "[]", "{", "{} {}", "17", "\"text\"", "{\"format\": {}}"})
    void foreignJson_isRefused(String json) {
        assertThatThrownBy(() -> GenotypeJson.read(json))
                .isInstanceOf(GenotypeFormatException.class)
                .hasMessageNotContaining("\n");
    }

    @Test
    void infiniteWeight_isRefused() {
        String json = GenotypeJson.write(NETWORK).replaceFirst("\"weight\" : [-0-9.E]+", "\"weight\" : 1e999");

        assertThatThrownBy(() -> GenotypeJson.read(json)).hasMessage("links[0]: weight must be finite, is Infinity");
    }

    @Test
    void deepNests_areRefused() {
        assertThatThrownBy(() -> GenotypeJson.read("{\"other\":" + "[".repeat(100_000)))
                .isInstanceOf(GenotypeFormatException.class)
                .hasMessageContaining("nesting depth");
    }

    @Test
    void byteOrderMark_isNoPartOfTheText(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("champion.json"), "\uFEFF" + GenotypeJson.write(NETWORK));

        assertThat(GenotypeFiles.read(file)).isEqualTo(NETWORK);
    }

    @Test
    void endlessFile_isRefused() {
        Path zeros = Path.of("/dev/zero");
        assumeThat(zeros).exists();

        assertThatThrownBy(() -> GenotypeFiles.read(zeros)).hasMessage("/dev/zero: is larger than 64 MiB");
    }

    @Test
    void fileOfNeitherForm_isRefused_namingIt(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("champion.txt"), "hello");

        assertThatThrownBy(() -> GenotypeFiles.read(file))
                .isInstanceOf(GenotypeFormatException.class)
                .hasMessage(file + ": is neither a genotype in JSON nor an XML file of the original; "
                        + "give a file with a network, such as champion.json in the folder of a run");
    }

    @Test
    void binaryFile_isRefused(@TempDir Path folder) throws IOException {
        Path file = Files.write(folder.resolve("champion.bin"), new byte[] {(byte) 0xff, (byte) 0xfe, 0, 1});

        assertThatThrownBy(() -> GenotypeFiles.read(file)).hasMessage(file + ": is not a text file");
    }

    @Test
    void filesOfBothForms_areRecognised(@TempDir Path folder) throws IOException {
        Path json = Files.writeString(folder.resolve("a"), GenotypeJson.write(NETWORK));
        Path xml = Files.writeString(folder.resolve("b"), GenotypeXml.write(NETWORK));

        assertThat(GenotypeFiles.read(json)).isEqualTo(NETWORK);
        assertThat(GenotypeFiles.read(xml)).isEqualTo(NETWORK);
    }
}
