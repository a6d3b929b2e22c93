package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.Properties;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Random lineages of every method equal recorded ones. They were recorded with code that reproduced all recorded cases
 * of the original. So this test checks exactness where the golden files are not available.
 */
class RecordedLineagesTest {

    @ParameterizedTest
    @CsvSource({
        "1M,  1, false, false, 0",
        "2M,  2, true,  false, 0",
        "3M,  3, true,  false, 0",
        "MMD, 1, true,  false, 0.1",
        "MT2, 2, false, true,  0",
        "MT3, 3, false, true,  0"
    })
    void lineages_endAsRecorded(String method, int modules, boolean preference, boolean multitask, double mmdRate)
            throws IOException, NoSuchAlgorithmException {
        ModuleLayout layout = multitask
                ? ModuleLayout.multitask(modules, 1)
                : preference ? ModuleLayout.withPreferenceNeurons(modules, 1) : ModuleLayout.single(1);
        RandomLineages lineages = new RandomLineages(
                new InitialNetworks(26, layout),
                new VariationSettings(MutationRates.PUBLISHED.withModuleDuplication(mmdRate)),
                10,
                7);
        MessageDigest digest = MessageDigest.getInstance("SHA-256");

        lineages.reproduce(200, child -> {
            digest.update(genesOf(child.genotype()).getBytes(StandardCharsets.UTF_8));
            digest.update((child.firstParent() + " " + child.mutations()).getBytes(StandardCharsets.UTF_8));
        });

        GenePool.State end = lineages.pool().state();
        String outcome = end.nextInnovation() + " " + end.nextGenotypeId() + " "
                + end.archetype().entries().size() + " "
                + end.archetype().shadows().size() + " "
                + HexFormat.of().formatHex(digest.digest(), 0, 8);
        assertThat(outcome).isEqualTo(recorded().getProperty(method));
    }

    /**
     * Returns all genes as text; weights as bits, because the decimal form of a double differs between versions of
     * Java.
     */
    private static String genesOf(Genotype genotype) {
        StringBuilder genes = new StringBuilder().append(genotype.id());
        genotype.nodes().forEach(node -> genes.append(' ').append(node.innovation()));
        for (LinkGene link : genotype.links()) {
            genes.append(' ').append(link.innovation());
            genes.append(' ').append(link.source()).append('>').append(link.target());
            genes.append(' ').append(Double.doubleToLongBits(link.weight()));
            genes.append(link.active()).append(link.recurrent());
        }
        return genes.toString();
    }

    private static Properties recorded() throws IOException {
        Properties properties = new Properties();
        try (InputStream file = RecordedLineagesTest.class.getResourceAsStream("recorded-lineages.properties")) {
            properties.load(file);
        }
        return properties;
    }
}
