package mmneat.neat.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.random.ResumableRandom;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class NetworkStateTest {

    private static final int GENOTYPES = 400;
    private static final int STEPS = 40;

    private final SplittableRandom random = new SplittableRandom(7);

    @Test
    void everyActivation_equalsThePlainForm_overManySteps() {
        for (int i = 0; i < GENOTYPES; i++) {
            Genotype genotype = randomGenotype(random);
            compareWithPlainForm(genotype, Network.compileWithAllNodes(genotype));
            compareWithPlainForm(genotype, Network.compile(genotype));
        }
    }

    @Test
    void largeWeights_equalThePlainForm() {
        for (int i = 0; i < GENOTYPES; i++) {
            Genotype genotype = withLargeWeights(randomGenotype(random), random);
            compareWithPlainForm(genotype, Network.compile(genotype));
        }
    }

    @Test
    void championSizedNetworks_equalThePlainForm() {
        for (int i = 0; i < 20; i++) {
            Genotype genotype = SampleGenotypes.champion(random);
            compareWithPlainForm(genotype, Network.compile(genotype));
        }
    }

    @Test
    void networksOf100HiddenNeurons_equalThePlainForm() {
        for (int i = 0; i < 5; i++) {
            Genotype genotype = SampleGenotypes.large(random);
            compareWithPlainForm(genotype, Network.compile(genotype));
        }
    }

    @ParameterizedTest
    @MethodSource("functions")
    void everyActivationFunction_equalsThePlainForm(ActivationFunction function) {
        for (int i = 0; i < 30; i++) {
            Genotype genotype = withFunction(randomGenotype(random), function);
            compareWithPlainForm(genotype, Network.compile(genotype));
        }
    }

    static Stream<ActivationFunction> functions() {
        return Stream.concat(
                ActivationFunction.builtIn().stream(), Stream.of(ActivationFunction.own("Sine", StrictMath::sin)));
    }

    /** More groups of neurons than a long has bits. */
    @Test
    void networksOf70Modules_equalThePlainForm() {
        for (int i = 0; i < 5; i++) {
            Genotype genotype = SampleGenotypes.grown(random, 5, SampleGenotypes.withPreference(70), 80, 600);
            compareWithPlainForm(genotype, Network.compile(genotype));
        }
    }

    private void compareWithPlainForm(Genotype genotype, Network network) {
        PlainNetwork plain = new PlainNetwork(genotype);
        NetworkState state = network.newState();
        ResumableRandom draws = new ResumableRandom(genotype.links().size());
        ResumableRandom expectedDraws = draws.copy();
        int[] usage = new int[genotype.modules()];
        double[] inputs = new double[genotype.inputs()];
        boolean constantInputs = random.nextInt(4) == 0;
        for (int step = 0; step < STEPS; step++) {
            if (random.nextInt(10) == 0) {
                plain.flush();
                state.flush();
                assertThat(state.policyOutput(0)).isZero();
            }
            for (int i = 0; i < inputs.length && !constantInputs; i++) {
                inputs[i] = random.nextInt(3) == 0 ? 0 : random.nextDouble(-1, 1);
            }
            plain.process(inputs);
            int chosen = step % 2 == 0 ? state.activate(inputs, draws) : activateFrom(state, genotype, inputs, draws);
            usage[chosen]++;
            if (genotype.layout().hasPreferenceNeurons() && genotype.modules() > 1) {
                List<Integer> preferred = plain.preferredModules();
                assertThat(chosen).isEqualTo(preferred.get(expectedDraws.nextInt(preferred.size())));
            } else {
                assertThat(chosen).isZero();
                expectedDraws.nextInt(1);
            }
            assertThat(draws.state()).isEqualTo(expectedDraws.state());
            assertThat(state.lastModule()).isEqualTo(chosen);
            for (int i = 0; i < genotype.layout().policyNeuronsPerModule(); i++) {
                assertThat(state.policyOutput(i))
                        .isEqualTo(plain.output(genotype.layout().policyOutput(chosen, i)));
            }
            for (int i = 0; i < network.nodes(); i++) {
                if (network.hasNode(i)) {
                    assertThat(state.nodeActivation(i)).as("node %d", i).isEqualTo(plain.activation(i));
                }
            }
        }
        assertThat(state.moduleUsage()).isEqualTo(usage);
    }

    private static int activateFrom(NetworkState state, Genotype genotype, double[] inputs, ResumableRandom draws) {
        int offset = 3;
        double[] activations = new double[offset + inputs.length + 1];
        Arrays.fill(activations, Double.NaN);
        for (int i = 0; i < inputs.length; i++) {
            activations[offset + i] = Functions.of(genotype.nodes().get(i).activation(), inputs[i]);
        }
        return state.activateFrom(activations, offset, draws);
    }

    static Genotype randomGenotype(SplittableRandom random) {
        int policyNeurons = 1 + random.nextInt(2);
        int modules = 1 + random.nextInt(4);
        boolean multitask = random.nextInt(4) == 0;
        int outputs = modules * (multitask ? policyNeurons : policyNeurons + 1);
        ModuleLayout layout = new ModuleLayout(outputs, modules, policyNeurons, multitask);
        int hidden = random.nextInt(15);
        return SampleGenotypes.grown(random, 1 + random.nextInt(8), layout, hidden, random.nextInt(120));
    }

    /**
     * Sums beyond the table of the fast tangent, and saturated neurons, whose activations differ in the last bits or
     * not at all.
     */
    static Genotype withLargeWeights(Genotype genotype, SplittableRandom random) {
        return withScaledWeights(genotype, random, 0, 12);
    }

    /** The genotype with weights times powers of two, whose exponents are drawn from a range without its end. */
    static Genotype withScaledWeights(Genotype genotype, SplittableRandom random, int lowest, int end) {
        List<LinkGene> links = genotype.links().stream()
                .map(link -> new LinkGene(
                        link.innovation(),
                        link.source(),
                        link.target(),
                        link.weight() * Math.scalb(1.0, random.nextInt(lowest, end)),
                        link.active(),
                        link.recurrent(),
                        link.frozen()))
                .toList();
        return new Genotype(0, genotype.inputs(), genotype.layout(), genotype.nodes(), links, genotype.moduleUsage());
    }

    private static Genotype withFunction(Genotype genotype, ActivationFunction function) {
        List<NodeGene> nodes = genotype.nodes().stream()
                .map(gene -> new NodeGene(gene.innovation(), gene.type(), function))
                .toList();
        return new Genotype(
                1, genotype.inputs(), genotype.layout(), nodes, genotype.links(), new int[genotype.modules()]);
    }

    /**
     * One input, hidden neurons 0 (useful) and 1 (a dead end that feeds itself), one module without preference neuron.
     */
    private static Genotype withDeadEnd() {
        List<NodeGene> nodes = List.of(
                new NodeGene(-1, NodeType.INPUT, ActivationFunction.TANH),
                new NodeGene(0, NodeType.HIDDEN, ActivationFunction.TANH),
                new NodeGene(1, NodeType.HIDDEN, ActivationFunction.TANH),
                new NodeGene(-2, NodeType.OUTPUT, ActivationFunction.TANH));
        List<LinkGene> links = List.of(
                new LinkGene(2, -1, 0, 0.5, false),
                new LinkGene(3, 0, -2, 0.0, false),
                new LinkGene(4, -1, 1, 1.5, false),
                new LinkGene(5, 1, 1, 1.0, true));
        return new Genotype(1, 1, new ModuleLayout(1, 1, 1, false), nodes, links, new int[1]);
    }

    @Test
    void nodesThatReachNoOutput_areLeftOut_butLinksOfWeightZeroAreNot() {
        Network network = Network.compile(withDeadEnd());
        assertThat(network.hasNode(1)).isTrue();
        assertThat(network.hasNode(2)).isFalse();
        assertThat(network.links()).isEqualTo(2);
        assertThat(network.neurons()).isEqualTo(2);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> network.newState().nodeActivation(2))
                .withMessageContaining("node 2");
        assertThat(Network.compileWithAllNodes(withDeadEnd()).hasNode(2)).isTrue();
    }

    @Test
    void inactiveLinks_doNotExistInTheNetwork() {
        Genotype genotype = withDeadEnd();
        List<LinkGene> links = new ArrayList<>(genotype.links());
        links.set(1, links.get(1).withActive(false));
        Network network = Network.compile(new Genotype(1, 1, genotype.layout(), genotype.nodes(), links, new int[1]));
        assertThat(network.links()).isZero();
        assertThat(network.neurons()).isEqualTo(1);
    }

    @Test
    void states_ofOneNetwork_areIndependent() {
        Genotype genotype = SampleGenotypes.champion(random);
        Network network = Network.compile(genotype);
        NetworkState one = network.newState();
        NetworkState other = network.newState();
        ResumableRandom draws = new ResumableRandom(1);
        double[] inputs = random.doubles(genotype.inputs()).toArray();
        one.activate(inputs, draws);
        double first = one.moduleOutput(0, 0);
        one.activate(inputs, draws);
        other.activate(inputs, draws);
        assertThat(other.moduleOutput(0, 0)).isEqualTo(first);
    }

    @Test
    void flush_keepsUsageAndLastModule_resetClearsThem() {
        Genotype genotype = SampleGenotypes.grown(random, 2, new ModuleLayout(3, 3, 1, true), 0, 0);
        NetworkState state = Network.compile(genotype).newState();
        ResumableRandom draws = new ResumableRandom(1);
        double[] inputs = {1, 0.5};
        assertThat(state.activateWithModule(inputs, 2, draws)).isEqualTo(2);
        state.flush();
        assertThat(state.lastModule()).isEqualTo(2);
        assertThat(state.moduleUsage()).containsExactly(0, 0, 1);
        assertThat(state.activate(inputs, draws)).as("preset module stays").isEqualTo(2);
        state.reset();
        assertThat(state.lastModule()).isZero();
        assertThat(state.moduleUsage()).containsOnly(0);
        assertThat(state.activate(inputs, draws)).isZero();
    }

    @Test
    void presetModule_thatDoesNotExist_isRefused() {
        Genotype genotype = SampleGenotypes.grown(random, 2, new ModuleLayout(2, 2, 1, true), 0, 0);
        NetworkState state = Network.compile(genotype).newState();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> state.presetModule(2))
                .withMessageContaining("is 2");
        assertThatIllegalArgumentException().isThrownBy(() -> state.presetModule(-1));
    }

    @Test
    void wrongNumberOfInputs_isRefused() {
        NetworkState state = Network.compile(withDeadEnd()).newState();
        assertThatIllegalArgumentException()
                .isThrownBy(() -> state.activate(new double[2], new ResumableRandom(1)))
                .withMessageContaining("1 inputs, got 2");
    }

    @Test
    void neuronsThatDoNotExist_areRefused() {
        Network preferring = Network.compile(SampleGenotypes.grown(random, 2, SampleGenotypes.withPreference(2), 0, 0));
        Network multitask = Network.compile(SampleGenotypes.grown(random, 2, ModuleLayout.multitask(2, 1), 0, 0));
        for (NetworkState state : List.of(preferring.newState(), stepped(preferring))) {
            assertRefused(() -> state.policyOutput(1), "policy neuron must be 0 to 0, is 1");
            assertRefused(() -> state.policyOutput(-1), "policy neuron must be 0 to 0, is -1");
            assertRefused(() -> state.moduleOutput(7, 0), "module must be 0 to 1, is 7");
            assertRefused(() -> state.moduleOutput(0, 1), "policy neuron must be 0 to 0, is 1");
            assertRefused(() -> state.preference(2), "module must be 0 to 1, is 2");
            assertRefused(() -> state.outputActivation(4), "output must be one of the network's 4, is 4");
            assertRefused(() -> state.nodeActivation(6), "node must be one of the genotype's 6, is 6");
        }
        for (NetworkState state : List.of(multitask.newState(), stepped(multitask))) {
            assertRefused(() -> state.preference(0), "the network has no preference neurons");
            assertRefused(() -> state.policyOutput(1), "policy neuron must be 0 to 0, is 1");
        }
        assertRefused(() -> preferring.hasNode(-1), "node must be one of the genotype's 6, is -1");
    }

    @Test
    void inputActivations_thatEndTooEarly_areRefused_beforeTheStep() {
        NetworkState state = Network.compile(withDeadEnd()).newState();
        ResumableRandom draws = new ResumableRandom(1);
        state.activateFrom(new double[] {0.5}, 0, draws);
        double before = state.nodeActivation(1);
        String refusal = "the network has 1 inputs, got 3 values to be read from ";
        assertRefused(() -> state.activateFrom(new double[3], 3, draws), refusal + 3);
        assertRefused(() -> state.activateFrom(new double[3], -1, draws), refusal + -1);
        assertRefused(
                () -> state.activateFrom(new double[0], 0, draws),
                "the network has 1 inputs, got 0 values to be read from 0");
        assertThat(state.nodeActivation(1)).isEqualTo(before);
        assertThat(state.moduleUsage()).containsExactly(1);
    }

    private static NetworkState stepped(Network network) {
        NetworkState state = network.newState();
        state.activate(new double[network.inputs()], new ResumableRandom(1));
        return state;
    }

    private static void assertRefused(ThrowingCallable call, String message) {
        assertThatIllegalArgumentException().isThrownBy(call).withMessage(message);
    }

    @Test
    void inputsThatAreNotNumbers_leaveNoModuleToChoose() {
        Genotype genotype = SampleGenotypes.grown(random, 2, SampleGenotypes.withPreference(2), 0, 0);
        NetworkState state = Network.compile(genotype).newState();
        assertThatIllegalStateException()
                .isThrownBy(() -> state.activate(new double[] {Double.NaN, Double.NaN}, new ResumableRandom(1)));
    }

    /** Sums around the bounds of what counts as clear, where tanh saturates, and exact ties. */
    @Test
    void closeAndSaturatedPreferences_areComparedByActivation() {
        double[] sums = {0, 1e-300, 1e-9, 2e-9, 0.5, 4.9999999999, 5, 5.1, 12, 19, 19.5, 25, 40};
        ResumableRandom draws = new ResumableRandom(3);
        ResumableRandom expectedDraws = draws.copy();
        for (double first : sums) {
            for (double second : sums) {
                for (int signs = 0; signs < 4; signs++) {
                    double one = (signs & 1) == 0 ? first : -first;
                    double two = (signs & 2) == 0 ? second : -second;
                    int tied = StrictMath.tanh(one) == StrictMath.tanh(two) ? 2 : 1;
                    int drawn = expectedDraws.nextInt(tied);
                    int expected = tied == 2 ? drawn : one > two ? 0 : 1;
                    assertThat(choiceBetween(one, two, draws))
                            .as("%s, %s", one, two)
                            .isEqualTo(expected);
                    assertThat(draws.state()).isEqualTo(expectedDraws.state());
                }
            }
        }
    }

    private static int choiceBetween(double first, double second, ResumableRandom draws) {
        List<NodeGene> nodes = new ArrayList<>();
        nodes.add(new NodeGene(-1, NodeType.INPUT, ActivationFunction.IDENTITY));
        for (int i = 0; i < 4; i++) {
            nodes.add(new NodeGene(-2 - i, NodeType.OUTPUT, ActivationFunction.TANH));
        }
        List<LinkGene> links = List.of(new LinkGene(0, -1, -3, first, false), new LinkGene(1, -1, -5, second, false));
        Genotype genotype = new Genotype(0, 1, SampleGenotypes.withPreference(2), nodes, links, new int[2]);
        return Network.compile(genotype).newState().activate(new double[] {1}, draws);
    }
}
