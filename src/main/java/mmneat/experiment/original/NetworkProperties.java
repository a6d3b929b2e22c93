package mmneat.experiment.original;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;

/**
 * The properties of one network that the log of networks (TWEANNData) records: sizes, module usage, and which inputs
 * are used. {@link PopulationLog} makes a row of the log from them: minimum, mean, maximum and deviation of each
 * property over a population.
 *
 * <p>Source: docs/specification/evolution.md, section 5.2 (TWEANNData).
 */
final class NetworkProperties {

    private static final int MODULES_SHOWN = 4;

    private NetworkProperties() {}

    /** Names of the properties. */
    static List<String> labels(List<String> inputLabels) {
        List<String> labels = new ArrayList<>(List.of(
                "Number of Links",
                "Number of Forward Links",
                "Number of Recurrent Links",
                "Number of Neurons",
                "Number of Modes",
                "Max Mode Usage",
                "Min Mode Usage"));
        for (int module = 0; module < MODULES_SHOWN; module++) {
            labels.add("Mode " + module + " Usage");
        }
        labels.add("Archetype Nodes");
        inputLabels.forEach(input -> labels.add(input + " Usage"));
        return labels;
    }

    /** The properties of a network. */
    static double[] of(Genotype genotype, int archetypeSize) {
        double[] usage = usageShares(genotype.moduleUsage());
        long recurrent = genotype.links().stream().filter(LinkGene::recurrent).count();
        double[] sizes = {
            genotype.links().size(),
            genotype.links().size() - recurrent,
            recurrent,
            genotype.nodes().size(),
            genotype.modules(),
            Arrays.stream(usage).max().orElse(0),
            Arrays.stream(usage).min().orElse(0)
        };
        double[] properties = Arrays.copyOf(sizes, sizes.length + MODULES_SHOWN + 1 + genotype.inputs());
        int next = sizes.length;
        for (int module = 0; module < MODULES_SHOWN; module++) {
            properties[next++] = module < usage.length ? usage[module] : 0;
        }
        properties[next++] = archetypeSize;
        Set<Long> sources = new HashSet<>();
        genotype.links().forEach(link -> sources.add(link.source()));
        for (int input = 0; input < genotype.inputs(); input++) {
            properties[next++] = sources.contains(genotype.nodes().get(input).innovation()) ? 1 : 0;
        }
        return properties;
    }

    /** Returns each module's share of all choices; empty if there were no choices. */
    private static double[] usageShares(int[] usage) {
        double total = Arrays.stream(usage).asLongStream().sum();
        return total == 0
                ? new double[0]
                : Arrays.stream(usage).mapToDouble(count -> count / total).toArray();
    }
}
