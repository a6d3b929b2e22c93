package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkState;
import mmneat.random.ResumableRandom;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;

/**
 * The operators have the same statistics as the original's in 10,000 trials each. Seeds are fixed. The limits are four
 * standard errors of the difference between two samples, slightly more where hundreds of numbers are compared.
 */
@Tag("conformance")
class GoldenStatisticsTest {

    private static final int TRIALS = 10_000;
    private static final int INPUTS = 30;
    private static final ActivationFunction TANH = ActivationFunction.TANH;

    private final JsonNode golden = GoldenGenotypes.file("statistics");
    private final ResumableRandom random = new ResumableRandom(20160601);

    private static ModuleLayout layoutOf(String variant) {
        return switch (variant) {
            case "OneModule" -> ModuleLayout.single(1);
            case "TwoModules" -> ModuleLayout.withPreferenceNeurons(2, 1);
            case "ThreeModules" -> ModuleLayout.withPreferenceNeurons(3, 1);
            case "Multitask2" -> ModuleLayout.multitask(2, 1);
            case "Multitask3" -> ModuleLayout.multitask(3, 1);
            case "MMD" -> ModuleLayout.withPreferenceNeurons(1, 1);
            default -> throw new IllegalArgumentException(variant);
        };
    }

    private static void assertMean(String what, SummaryStatistics ours, JsonNode theirs) {
        double mean = theirs.required("mean").doubleValue();
        double sd = theirs.required("sd").doubleValue();
        double n = theirs.required("n").doubleValue();
        double standardError = Math.sqrt(sd * sd / n + ours.getVariance() / ours.getN());
        assertThat(Math.abs(ours.getMean() - mean))
                .as("mean of %s: ours %s, the original's %s", what, ours.getMean(), mean)
                .isLessThanOrEqualTo(4 * standardError);
        double kurtosis = theirs.required("kurtosis").doubleValue();
        double errorOfSd = sd * Math.sqrt(Math.max(0, kurtosis - 1) / 4 * (1 / n + 1.0 / ours.getN()));
        assertThat(Math.abs(ours.getStandardDeviation() - sd))
                .as("standard deviation of %s: ours %s, the original's %s", what, ours.getStandardDeviation(), sd)
                .isLessThanOrEqualTo(4.5 * errorOfSd);
    }

    /** Compares two counts of the same event. If the original's count is 0, ours must be 0. */
    private static void assertCount(String what, int ours, int oursOf, int theirs, int theirsOf) {
        if (theirs == 0) {
            assertThat(ours).as(what).isZero();
            return;
        }
        double p = (ours + theirs) / (double) (oursOf + theirsOf);
        double standardError = Math.sqrt(p * (1 - p) * (1.0 / oursOf + 1.0 / theirsOf));
        assertThat(Math.abs(ours / (double) oursOf - theirs / (double) theirsOf))
                .as("%s: ours %s of %s, the original's %s of %s", what, ours, oursOf, theirs, theirsOf)
                .isLessThanOrEqualTo(4.5 * standardError);
    }

    private static void assertCounts(String what, int[] ours, int oursOf, JsonNode theirs, int theirsOf) {
        for (int i = 0; i < ours.length; i++) {
            JsonNode count = theirs.get(Integer.toString(i));
            assertCount(what + " " + i, ours[i], oursOf, count == null ? 0 : count.intValue(), theirsOf);
        }
    }

    private static GenePool poolFor(Genotype genotype) {
        return GenePool.foundedOn(genotype);
    }

    @TestFactory
    Stream<DynamicTest> lineages_grow_asTheOriginals() {
        JsonNode growth = golden.required("growth_10000_lineages");
        List<String> variants = new ArrayList<>();
        growth.fieldNames().forEachRemaining(variants::add);
        assertThat(variants).hasSize(6);
        return variants.stream().map(v -> dynamicTest(v, () -> checkGrowth(v, growth.get(v))));
    }

    private void checkGrowth(String variant, JsonNode golden) {
        int lineages = 2_000;
        InitialNetworks networks = new InitialNetworks(INPUTS, layoutOf(variant));
        MutationRates rates = MutationRates.PUBLISHED.withModuleDuplication(variant.equals("MMD") ? 0.1 : 0);
        Map<String, SummaryStatistics> statistics = new HashMap<>();
        Map<String, int[]> modules = new HashMap<>();
        for (int lineage = 0; lineage < lineages; lineage++) {
            Genotype genotype = networks.create(0, random);
            GenePool pool = poolFor(genotype);
            Reproduction reproduction = new Reproduction(new VariationSettings(rates), pool);
            for (int round = 1; round <= 20; round++) {
                int[] equalUsage = new int[genotype.modules()];
                java.util.Arrays.fill(equalUsage, 40);
                genotype = reproduction
                        .fromOne(genotype.withModuleUsage(equalUsage), random)
                        .genotype();
                String after = "after_" + round;
                if (golden.has(after)) {
                    measure(genotype, pool.state().nextInnovation(), after + ".", statistics);
                    modules.computeIfAbsent(after, k -> new int[12])[genotype.modules()]++;
                }
            }
        }
        assertThat(modules).hasSize(golden.size());
        modules.forEach((after, counts) -> assertCounts(
                variant + " " + after + " modules",
                counts,
                lineages,
                golden.get(after).get("modules"),
                TRIALS));
        statistics.forEach((name, ours) -> {
            String[] path = name.split("\\.");
            assertMean(variant + " " + name, ours, golden.get(path[0]).required(path[1]));
        });
    }

    private static void measure(
            Genotype genotype, long innovations, String after, Map<String, SummaryStatistics> statistics) {
        List<LinkGene> links = genotype.links();
        long active = links.stream().filter(LinkGene::active).count();
        long recurrent = links.stream().filter(l -> l.active() && l.recurrent()).count();
        Map<String, Long> values = Map.of(
                "active_links", active,
                "inactive_links", links.size() - active,
                "active_recurrent_links", recurrent,
                "hidden_neurons", (long) genotype.hidden(),
                "innovations_used", innovations);
        values.forEach((name, value) -> statistics
                .computeIfAbsent(after + name, k -> new SummaryStatistics())
                .addValue(value));
    }

    @Test
    void weights_change_asTheOriginals() {
        JsonNode theirs = golden.required("weight_perturbation");
        Genotype parent = new InitialNetworks(INPUTS, layoutOf("TwoModules")).create(0, random);
        assertThat(parent.links()).hasSize(theirs.required("links").intValue());
        SummaryStatistics perturbed = new SummaryStatistics();
        SummaryStatistics delta = new SummaryStatistics();
        for (int trial = 0; trial < TRIALS; trial++) {
            GenotypeDraft child = GenotypeDraft.of(parent);
            new AllWeightMutation(theirs.required("rate").doubleValue()).apply(child, poolFor(parent), random);
            int count = 0;
            for (int i = 0; i < parent.links().size(); i++) {
                double change =
                        child.links().get(i).weight() - parent.links().get(i).weight();
                if (change != 0) {
                    delta.addValue(change);
                    count++;
                }
            }
            perturbed.addValue(count);
        }
        assertMean("perturbed links", perturbed, theirs.required("perturbed_links_per_offspring"));
        assertMean("delta", delta, theirs.required("delta"));
    }

    @Test
    void initialNetworks_areSpread_asTheOriginals() {
        JsonNode theirs = golden.required("initial_networks_three_modules");
        InitialNetworks networks = new InitialNetworks(INPUTS, layoutOf("ThreeModules"));
        SummaryStatistics weights = new SummaryStatistics();
        int[] sources = new int[INPUTS];
        for (int trial = 0; trial < TRIALS; trial++) {
            Genotype network = networks.create(0, random);
            assertThat(network.links()).hasSize(93);
            for (LinkGene link : network.links()) {
                weights.addValue(link.weight());
                int output = (int) (-link.target() - 1 - INPUTS);
                if (output % 2 == 1) {
                    sources[(int) (-link.source() - 1)]++;
                }
            }
        }
        assertMean("initial weight", weights, theirs.required("weight"));
        assertCounts(
                "source",
                sources,
                3 * TRIALS,
                theirs.required("preference_link_source_index_counts"),
                3 * theirs.required("networks").intValue());
    }

    @TestFactory
    Stream<DynamicTest> newLinks_areAdded_asTheOriginals() {
        JsonNode kinds = golden.required("link_mutation");
        List<String> names = new ArrayList<>();
        kinds.fieldNames().forEachRemaining(names::add);
        assertThat(names).hasSize(7);
        return names.stream().map(name -> dynamicTest(name, () -> checkNewLinks(name, kinds.get(name))));
    }

    private void checkNewLinks(String name, JsonNode theirs) {
        int attempts = theirs.required("attempts").intValue();
        Genotype given = theirs.has("genotype") ? GoldenGenotypes.genotype(theirs.get("genotype")) : null;
        int nodes = theirs.required("nodes").intValue();
        int[] sources = new int[nodes];
        int[] targets = new int[nodes];
        int recurrent = 0;
        int self = 0;
        SummaryStatistics weights = new SummaryStatistics();
        for (int attempt = 0; attempt < attempts; attempt++) {
            Genotype parent = given != null ? given : new InitialNetworks(INPUTS, layoutOf(name)).create(0, random);
            GenotypeDraft child = GenotypeDraft.of(parent);
            new NewLinkMutation().apply(child, poolFor(parent), random);
            if (child.links().size() > parent.links().size()) {
                LinkGene added = child.links().get(parent.links().size());
                sources[child.indexOf(added.source())]++;
                targets[child.indexOf(added.target())]++;
                recurrent += added.recurrent() ? 1 : 0;
                self += added.source() == added.target() ? 1 : 0;
                weights.addValue(added.weight());
            }
        }
        assertCount(
                "added",
                (int) weights.getN(),
                attempts,
                theirs.required("added").intValue(),
                attempts);
        assertCount(
                "recurrent", recurrent, attempts, theirs.required("recurrent").intValue(), attempts);
        assertCount("self", self, attempts, theirs.required("self").intValue(), attempts);
        assertCounts("source", sources, attempts, theirs.required("source_index_counts"), attempts);
        assertCounts("target", targets, attempts, theirs.required("target_index_counts"), attempts);
        assertMean("weight", weights, theirs.required("weight"));
    }

    @Test
    void splices_areSpread_asTheOriginals() {
        JsonNode theirs = golden.required("splice");
        int attempts = theirs.required("attempts").intValue();
        Genotype parent = GoldenGenotypes.genotype(theirs.required("genotype"));
        int[] spliced = new int[parent.links().size()];
        int[] positions = new int[parent.nodes().size() + 1];
        int recurrentIn = 0;
        int recurrentOut = 0;
        SummaryStatistics weightIn = new SummaryStatistics();
        SummaryStatistics weightOut = new SummaryStatistics();
        for (int attempt = 0; attempt < attempts; attempt++) {
            GenotypeDraft child = GenotypeDraft.of(parent);
            new SpliceNeuronMutation(TANH).apply(child, poolFor(parent), random);
            int size = child.links().size();
            LinkGene in = child.links().get(size - 2);
            LinkGene out = child.links().get(size - 1);
            for (int i = 0; i < spliced.length; i++) {
                spliced[i] +=
                        parent.links().get(i).active() && !child.links().get(i).active() ? 1 : 0;
            }
            positions[child.indexOf(in.target())]++;
            recurrentIn += in.recurrent() ? 1 : 0;
            recurrentOut += out.recurrent() ? 1 : 0;
            weightIn.addValue(in.weight());
            weightOut.addValue(out.weight());
        }
        assertCounts("spliced link", spliced, attempts, theirs.required("spliced_link_index_counts"), attempts);
        assertCounts("place", positions, attempts, theirs.required("new_node_index_counts"), attempts);
        assertCount(
                "in",
                recurrentIn,
                attempts,
                theirs.required("recurrent_into_new").intValue(),
                attempts);
        assertCount(
                "out",
                recurrentOut,
                attempts,
                theirs.required("recurrent_out_of_new").intValue(),
                attempts);
        assertMean("weight in", weightIn, theirs.required("weight_into_new"));
        assertMean("weight out", weightOut, theirs.required("weight_out_of_new"));
    }

    @Test
    void duplicatedModules_areSpread_asTheOriginals() {
        JsonNode theirs = golden.required("module_duplication");
        int attempts = theirs.required("attempts").intValue();
        Genotype parent = GoldenGenotypes.genotype(theirs.required("genotype"));
        Map<Set<Double>, Integer> moduleOfWeights = new HashMap<>();
        for (int module = 0; module < parent.modules(); module++) {
            moduleOfWeights.put(weightsInto(parent.links(), outputOf(parent, module)), module);
        }
        int[] duplicated = new int[parent.modules()];
        int[] sources = new int[parent.nodes().size()];
        SummaryStatistics weights = new SummaryStatistics();
        for (int attempt = 0; attempt < attempts; attempt++) {
            GenotypeDraft child = GenotypeDraft.of(parent);
            new ModuleDuplication(TANH).apply(child, poolFor(parent), random);
            Genotype grown = child.finish();
            List<LinkGene> added =
                    grown.links().subList(parent.links().size(), grown.links().size());
            LinkGene preference = added.get(added.size() - 1);
            long policy = outputOf(grown, parent.modules());
            assertThat(added.subList(0, added.size() - 1)).allMatch(link -> link.target() == policy);
            duplicated[moduleOfWeights.get(weightsInto(added, policy))]++;
            sources[child.indexOf(preference.source())]++;
            weights.addValue(preference.weight());
        }
        assertCounts("module", duplicated, attempts, theirs.required("duplicated_module_counts"), attempts);
        assertCounts("source", sources, attempts, theirs.required("preference_source_index_counts"), attempts);
        assertMean("weight", weights, theirs.required("preference_weight"));
    }

    private static long outputOf(Genotype genotype, int module) {
        int output = genotype.layout().policyOutput(module, 0);
        return genotype.nodes().get(genotype.firstOutput() + output).innovation();
    }

    private static Set<Double> weightsInto(List<LinkGene> links, long target) {
        Set<Double> weights = new HashSet<>();
        links.stream()
                .filter(link -> link.active() && link.target() == target)
                .forEach(link -> weights.add(link.weight()));
        return weights;
    }

    @Test
    void moduleGate_opens_asTheOriginals() {
        JsonNode cases = golden.required("module_mutation_gate_mmdRate_0.1");
        assertThat(cases).hasSize(13);
        VariationSettings settings = new VariationSettings(MutationRates.PUBLISHED.withModuleDuplication(0.1));
        for (JsonNode c : cases) {
            int[] usage = new int[c.required("usage").size()];
            for (int i = 0; i < usage.length; i++) {
                usage[i] = c.required("usage").get(i).intValue();
            }
            Genotype parent = new InitialNetworks(INPUTS, ModuleLayout.withPreferenceNeurons(usage.length, 1))
                    .create(0, random)
                    .withModuleUsage(usage);
            Reproduction reproduction = new Reproduction(settings, poolFor(parent));
            int gained = 0;
            for (int trial = 0; trial < TRIALS; trial++) {
                Offspring child = reproduction.fromOne(parent, random);
                gained += child.genotype().modules() > parent.modules() ? 1 : 0;
            }
            assertCount(
                    "usage " + c.required("usage"),
                    gained,
                    TRIALS,
                    c.required("gained_a_module").intValue(),
                    c.required("mutations").intValue());
        }
    }

    @Test
    void operators_areAsFrequent_asTheOriginals() {
        JsonNode theirs = golden.required("operator_frequencies_two_modules");
        Genotype parent = new InitialNetworks(INPUTS, layoutOf("TwoModules")).create(0, random);
        Reproduction reproduction = new Reproduction(new VariationSettings(MutationRates.PUBLISHED), poolFor(parent));
        Map<String, Integer> ours = new HashMap<>();
        for (int trial = 0; trial < TRIALS; trial++) {
            List<String> performed = reproduction.fromOne(parent, random).mutations();
            boolean isSpliced = performed.contains("SpliceNeuronMutation");
            boolean isLinked = performed.contains("NewLinkMutation");
            ours.merge("splice", isSpliced ? 1 : 0, Integer::sum);
            ours.merge("link_attempt", isLinked ? 1 : 0, Integer::sum);
            ours.merge("both", isSpliced && isLinked ? 1 : 0, Integer::sum);
            ours.merge("neither", isSpliced || isLinked ? 0 : 1, Integer::sum);
        }
        ours.forEach((name, count) -> assertCount(
                name,
                count,
                TRIALS,
                theirs.required(name).intValue(),
                theirs.required("mutations").intValue()));
    }

    @Test
    void matchingLinks_areSwappedHalfTheTime_asInTheOriginal() {
        JsonNode theirs = golden.required("crossover");
        InitialNetworks networks = new InitialNetworks(INPUTS, layoutOf("TwoModules"));
        Genotype a = networks.create(0, random);
        Genotype b = networks.create(1, random);
        Map<Long, Integer> swaps = new HashMap<>();
        for (int trial = 0; trial < TRIALS; trial++) {
            GenotypeDraft childA = GenotypeDraft.of(a);
            GenotypeDraft childB = GenotypeDraft.of(b);
            new Crossover(0).cross(childA, childB, poolFor(a).archetype(), random);
            Set<LinkGene> own = new HashSet<>(a.links());
            for (LinkGene link : childA.links()) {
                swaps.merge(link.innovation(), own.contains(link) ? 0 : 1, Integer::sum);
            }
        }
        SummaryStatistics fractions = new SummaryStatistics();
        swaps.values().stream()
                .filter(count -> count > 0)
                .forEach(count -> fractions.addValue(count / (double) TRIALS));
        assertThat(fractions.getN()).isGreaterThanOrEqualTo(60);
        JsonNode fractionOfTheirs = theirs.required("fraction_swapped_per_link");
        double spread = fractionOfTheirs.required("sd").doubleValue();
        double mean = fractionOfTheirs.required("mean").doubleValue();
        double standardError =
                spread * Math.sqrt(1 / fractionOfTheirs.required("n").doubleValue() + 1.0 / fractions.getN());
        assertThat(fractions.getMean()).isBetween(mean - 4 * standardError, mean + 4 * standardError);
        assertThat(fractions.getStandardDeviation()).isBetween(0.5 * spread, 1.5 * spread);
    }

    @Test
    void equalPreferences_areChosenEquallyOften_asInTheOriginal() {
        JsonNode theirs = golden.required("preference_ties_all_zero_inputs_three_modules");
        int steps = theirs.required("steps").intValue();
        InitialNetworks networks = new InitialNetworks(INPUTS, layoutOf("ThreeModules"));
        NetworkState state = Network.compile(networks.create(0, random)).newState();
        for (int step = 0; step < steps; step++) {
            state.activate(new double[INPUTS], random);
        }
        for (int module = 0; module < 3; module++) {
            assertCount(
                    "choices of module " + module,
                    state.moduleUsage()[module],
                    steps,
                    theirs.required("chosen").required(module).intValue(),
                    steps);
        }
    }

    @Test
    void networkOfOneModule_takesOneDrawAStep_asInTheOriginal() {
        assertThat(golden.required("one_module_process_consumes_one_draw").booleanValue())
                .isTrue();
        NetworkState state = Network.compile(new InitialNetworks(INPUTS, layoutOf("OneModule")).create(0, random))
                .newState();
        ResumableRandom expected = random.copy();
        state.activate(new double[INPUTS], random);
        expected.nextInt(1);
        assertThat(random.state()).isEqualTo(expected.state());
    }
}
