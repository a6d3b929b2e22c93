package mmneat.neat.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.regex.Pattern;
import java.util.zip.GZIPInputStream;
import mmneat.GoldenData;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
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
     * Removes the unused elements of lists, whose number depends on how a list was filled, and parses and prints
     * doubles again: versions of Java differ in the last printed digits of a double.
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
    void writtenGenotype_isReadUnchanged() throws IOException {
        assertThat(GenotypeXml.read(GenotypeXml.write(NETWORK))).isEqualTo(NETWORK);
    }

    @Test
    void laterPackageOfTheOriginal_isRead() throws IOException {
        String xml = GenotypeXml.write(NETWORK).replace("edu.utexas.cs.nn.", "edu.southwestern.");

        assertThat(GenotypeXml.read(xml)).isEqualTo(NETWORK);
    }

    /** Renames fields and package to those of the original since 2016. */
    private static String later(String xml) {
        return xml.replace("edu.utexas.cs.nn.", "edu.southwestern.")
                .replace("$NodeGene", "$FullNodeGene")
                .replace("$LinkGene", "$FullLinkGene")
                .replace("\"numModes\"", "\"numModules\"")
                .replace("\"neuronsPerMode\"", "\"neuronsPerModule\"")
                .replace("\"modeAssociations\"", "\"moduleAssociations\"")
                .replace("\"modeUsage\"", "\"moduleUsage\"")
                .replace(
                        "<field name=\"fromCombiningCrossover\"",
                        "<field name=\"bias\" type=\"double\" value=\"0.0\" /><field name=\"fromCombiningCrossover\"")
                .replace(
                        "<field name=\"recurrent\"",
                        "<field name=\"moduleSource\" type=\"int\" value=\"1\" /><field name=\"recurrent\"")
                .replace(
                        "<field name=\"archetypeIndex\"",
                        "<field name=\"parents\"><object type=\"java.util.ArrayList\" id=\"999\"/></field>"
                                + "<field name=\"smallerGenotypes\" type=\"boolean\" value=\"false\" />"
                                + "<field name=\"archetypeIndex\"");
    }

    @Test
    void laterFields_areRead() throws IOException {
        assertThat(GenotypeXml.read(later(GenotypeXml.write(NETWORK)))).isEqualTo(NETWORK);
    }

    @Test
    void fileOfOctober2016_isTheShippedChampion() throws IOException {
        try (InputStream file = GenotypeXmlTest.class.getResourceAsStream("champion-of-2016-10.xml.gz");
                InputStream champion =
                        Genotype.class.getResourceAsStream("/mmneat/analysis/evaluation/champion-blended.json")) {
            String xml = new String(new GZIPInputStream(file).readAllBytes(), StandardCharsets.UTF_8);

            assertThat(GenotypeJson.write(GenotypeXml.read(xml)))
                    .isEqualTo(new String(champion.readAllBytes(), StandardCharsets.UTF_8));
        }
    }

    @Test
    void smallGenes_areActive_andTheirOrderTellsWhichAreRecurrent() throws IOException {
        String xml = GenotypeXml.write(NETWORK)
                .replaceAll("<field name=\"(active|recurrent|frozen|fromCombiningCrossover)\"[^>]*>", "");

        assertThat(GenotypeXml.read(xml)).isEqualTo(NETWORK);

        String backwards = xml.replaceFirst("(sourceInnovation\" type=\"long\") value=\"-1\"", "$1 value=\"-6\"")
                .replaceFirst("(targetInnovation\" type=\"long\") value=\"-4\"", "$1 value=\"-4\"");
        assertThat(GenotypeXml.read(backwards).links()).anyMatch(LinkGene::recurrent);
    }

    @Test
    void completeGenes_needAllFields() {
        String xml = later(GenotypeXml.write(NETWORK)).replaceFirst("<field name=\"frozen\"[^>]*>", "");

        assertThatThrownBy(() -> GenotypeXml.read(xml)).hasMessage("nodes[0].frozen: is missing");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                    name="bias" type="double" value="0.0" | name="bias" type="double" value="0.5" | nodes[0].bias: is 0.5; neurons with a bias, a feature of later versions of the original, are not supported
                    name="ftype" type="int" value="1"     | name="ftype" type="int" value="6"     | nodes[0].ftype: is 6; activation functions of later versions of the original are not supported
                    genotypes.TWEANNGenotype" id="0"      | genotypes.HyperNEATCPPNGenotype" id="0" | document: must be a TWEANNGenotype, is a HyperNEATCPPNGenotype: networks that a CPPN makes (HyperNEAT) are not supported
                    """)
    void featuresOfLaterVersions_areRefused_byName(String good, String bad, String message) {
        String xml = later(GenotypeXml.write(NETWORK));
        assertThat(xml).contains(good);

        assertThatThrownBy(() -> GenotypeXml.read(xml.replace(good, bad)))
                .isInstanceOf(GenotypeFormatException.class)
                .hasMessage(message);
    }

    /** Source: docs/specification/networks.md, section 6.3. */
    @Test
    void hierarchicalMultitaskNetwork_isAHybrid() throws GenotypeFormatException {
        String hierarchical = GenotypeXml.write(NETWORK)
                .replace(
                        "name=\"hierarchicalMultitask\" type=\"boolean\" value=\"false\"",
                        "name=\"hierarchicalMultitask\" type=\"boolean\" value=\"true\"");
        Genotype hybrid = GenotypeXml.read(hierarchical);
        assertThat(hybrid.layout().groups()).containsExactly(0, 1);
        assertThat(GenotypeXml.write(hybrid)).isEqualTo(hierarchical);
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
                .hasMessage(
                        "nodes[0].fromCombiningCrossover: must be false, as it is only for entries of an archetype");
    }
}
