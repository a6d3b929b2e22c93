package mmneat.neat.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.util.regex.Pattern;
import mmneat.GoldenData;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.neat.variation.GoldenGenotypes;
import mmneat.neat.variation.InitialNetworks;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class GenotypeXmlTest {

    private static final Genotype NETWORK =
            new InitialNetworks(3, ModuleLayout.withPreferenceNeurons(2, 1)).create(7, new ResumableRandom(5));

    @Tag("conformance")
    @ParameterizedTest
    @ValueSource(strings = {"small_genotype", "run_member_two_modules"})
    void originalsFile_readsAsItsTwin(String name) throws IOException {
        JsonNode twin = GoldenGenotypes.file(name);

        Genotype genotype = GenotypeXml.read(golden(name));

        assertThat(genotype).isEqualTo(GoldenGenotypes.genotype(twin.required("stored")));
    }

    @Tag("conformance")
    @ParameterizedTest
    @ValueSource(strings = {"small_genotype", "run_member_two_modules"})
    void originalsFile_isWrittenAgain_characterForCharacter(String name) throws IOException {
        String original = golden(name);

        assertThat(withoutSparePlaces(GenotypeXml.write(GenotypeXml.read(original))))
                .isEqualTo(withoutSparePlaces(original));
    }

    /**
     * How many spare places a list has depends on how it came to be, and means nothing; and versions of Java differ in the last
     * digits that they print of a double.
     */
    private static String withoutSparePlaces(String xml) {
        String filled = xml.replace("<object />", "").replaceAll("(\"java.lang.Object\" length)=\"\\d+\"", "$1=any");
        return Pattern.compile("(?<=type=\"double\" value=\")[^\"]+")
                .matcher(filled)
                .replaceAll(number -> Double.toString(Double.parseDouble(number.group())));
    }

    @Tag("conformance")
    @Test
    void originalsArchetype_readsAsItsTwin_andIsWrittenAgain() throws IOException {
        String original = golden("small_archetype");
        JsonNode twin = GoldenGenotypes.file("small_genotype");

        assertThat(GenotypeXml.readArchetype(original))
                .isEqualTo(GoldenGenotypes.archetype(twin.required("archetype")));
        assertThat(GenotypeXml.writeArchetype(GenotypeXml.readArchetype(original)))
                .isEqualTo(original);
    }

    private static String golden(String name) throws IOException {
        return Files.readString(GoldenData.folder("networks").resolve(name + ".xml"));
    }

    @Test
    void writtenGenotype_readsAsItself() throws IOException {
        assertThat(GenotypeXml.read(GenotypeXml.write(NETWORK))).isEqualTo(NETWORK);
    }

    @Test
    void laterPackageOfTheOriginal_isRead() throws IOException {
        String xml = GenotypeXml.write(NETWORK).replace("edu.utexas.cs.nn.", "edu.southwestern.");

        assertThat(GenotypeXml.read(xml)).isEqualTo(NETWORK);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    name="numIn" type="int" value="3"      | name="numIn" type="int" value="three"   | numIn: must be a whole number, is "three"
                    name="numIn" type="int" value="3"      | name="numIn" type="int" value="4"       | nodes: 7 are too few for 4 inputs and 4 outputs
                    name="numIn"                           | name="inputs"                           | unknown field inputs
                    name="numModes" type="int" value="2"   | name="numModes" type="int" value="3"    | outputs: 4 cannot be 3 modules
                    name="ntype" type="int" value="2"      | name="ntype" type="int" value="9"       | node type must be 0, 1 or 2, is 9
                    name="active" type="boolean" value="true" | name="active" type="boolean" value="1" | links[0].active: must be true or false
                    name="sourceInnovation" type="long" value="-1" | name="sourceInnovation" type="long" value="99" | links[0]: no node has innovation 99
                    name="hierarchicalMultitask" type="boolean" value="false" | name="hierarchicalMultitask" type="boolean" value="true" | hierarchicalMultitask: hierarchical multitask networks are not supported
                    name="size" type="int" value="7"       | name="size" type="int" value="70"       | nodes.size: is 70 but there are 10 elements
                    TWEANNGenotype"                        | MLPGenotype"                            | document: must be a TWEANNGenotype
                    id="0">                                | id="0"                                  | not well-formed XML
                    """)
    void damagedFile_isRefused_namingTheField(String good, String bad, String message) {
        String xml = GenotypeXml.write(NETWORK);
        assertThat(xml).contains(good);

        assertThatThrownBy(() -> GenotypeXml.read(xml.replace(good, bad)))
                .isInstanceOf(GenotypeFormatException.class)
                .hasMessageContaining(message)
                .hasMessageNotContaining("\n");
    }

    @Test
    void missingField_isRefused_byName() {
        String xml = GenotypeXml.write(NETWORK).replaceFirst("<field name=\"id\"[^>]*>", "");

        assertThatThrownBy(() -> GenotypeXml.read(xml)).hasMessage("id: is missing");
    }

    @Test
    void entities_areRefused() {
        String xml = "<!DOCTYPE object [<!ENTITY secret SYSTEM \"file:///etc/hostname\">]>"
                + GenotypeXml.write(NETWORK).replace("modeUsage\">", "modeUsage\">&secret;");

        assertThatThrownBy(() -> GenotypeXml.read(xml))
                .isInstanceOf(GenotypeFormatException.class)
                .hasMessageContaining("not allowed");
    }

    @Test
    void expandingEntities_areRefused() {
        StringBuilder types = new StringBuilder("<!DOCTYPE object [<!ENTITY a0 \"boom\">");
        for (int i = 1; i < 30; i++) {
            String previous = "&a" + (i - 1) + ";";
            types.append("<!ENTITY a" + i + " \"" + previous.repeat(10) + "\">");
        }

        assertThatThrownBy(() -> GenotypeXml.read(types + "]><object>&a29;</object>"))
                .isInstanceOf(GenotypeFormatException.class);
    }

    @Test
    void tooManyElements_areRefused() {
        assertThatThrownBy(() -> GenotypeXml.read("<object>" + "<a/>".repeat(500_000) + "</object>"))
                .isInstanceOf(GenotypeFormatException.class)
                .hasMessageStartingWith("more than 500000 XML elements");
    }

    @Test
    void deepNests_areRefused() {
        assertThatThrownBy(() -> GenotypeXml.read("<object>".repeat(100_000)))
                .isInstanceOf(GenotypeFormatException.class)
                .hasMessageContaining("nested deeper");
    }

    @Test
    void shadowEntry_isNoNodeOfANetwork() throws IOException {
        String shadow = "name=\"fromCombiningCrossover\" type=\"boolean\" value=\"%s\"";
        String xml = GenotypeXml.write(NETWORK).replaceFirst(shadow.formatted(false), shadow.formatted(true));
        assertThatThrownBy(() -> GenotypeXml.read(xml))
                .isInstanceOf(GenotypeFormatException.class)
                .hasMessage("nodes[0].fromCombiningCrossover: is true, as only entries of an archetype are");
    }
}
