package mmneat.neat.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

class NetworkStatesTest {

    private static final int GENOTYPES = 200;
    private static final int STEPS = 60;

    /** More than the steps whose activations a state keeps. */
    private static final int MANY_STEPS = 300;

    private static final int STATES = 5;

    private final SplittableRandom random = new SplittableRandom(11);

    @Test
    void statesActivatedTogether_equalStatesActivatedOneByOne() {
        for (int i = 0; i < GENOTYPES; i++) {
            Genotype genotype =
                    i % 10 == 0 ? SampleGenotypes.champion(random) : NetworkStateTest.randomGenotype(random);
            Genotype compared = i % 4 == 1 ? NetworkStateTest.withLargeWeights(genotype, random) : genotype;
            compare(compared, Network.compile(compared));
        }
    }

    private void compare(Genotype genotype, Network network) {
        NetworkStates together = network.newStates(STATES);
        NetworkState[] single = new NetworkState[STATES];
        for (int i = 0; i < STATES; i++) {
            single[i] = network.newState();
        }
        ResumableRandom draws = new ResumableRandom(5);
        ResumableRandom expectedDraws = draws.copy();
        int stride = genotype.inputs() + random.nextInt(3);
        double[] inputs = new double[STATES * stride];
        for (int step = 0; step < STEPS; step++) {
            for (int i = 0; i < inputs.length; i++) {
                inputs[i] = random.nextInt(3) == 0 ? 0 : random.nextDouble(-0.7, 0.7);
            }
            int which = random.nextInt(1 << STATES);
            if (genotype.layout().standardMultitask()) {
                int module = random.nextInt(genotype.modules());
                together.presetModule(module);
                for (NetworkState state : single) {
                    state.presetModule(module);
                }
            }
            together.activate(which, inputs, stride, draws);
            for (int i = 0; i < STATES; i++) {
                if ((which >>> i & 1) != 0) {
                    single[i].activateFrom(inputs, i * stride, expectedDraws);
                } else if (random.nextBoolean()) {
                    single[i].flush();
                    together.get(i).flush();
                }
            }
            assertThat(draws.state()).isEqualTo(expectedDraws.state());
            for (int i = 0; i < STATES; i++) {
                assertEqualStates(genotype, together.get(i), single[i]);
            }
        }
    }

    private static void assertEqualStates(Genotype genotype, NetworkState actual, NetworkState expected) {
        assertThat(actual.lastModule()).isEqualTo(expected.lastModule());
        assertThat(actual.policyOutput(0)).isEqualTo(expected.policyOutput(0));
        assertThat(actual.moduleUsage()).isEqualTo(expected.moduleUsage());
        for (int i = 0; i < genotype.nodes().size(); i++) {
            if (actual.network().hasNode(i)) {
                assertThat(actual.nodeActivation(i)).isEqualTo(expected.nodeActivation(i));
            }
        }
    }

    @Test
    void clearlyHighestAnswer_isTheHighestToTheLastBit_andMostlyFound() {
        int steps = 0;
        int clear = 0;
        for (int i = 0; i < GENOTYPES; i++) {
            Genotype genotype = i % 4 == 0
                    ? NetworkStateTest.withLargeWeights(NetworkStateTest.randomGenotype(random), random)
                    : sample(i);
            NetworkStates together = Network.compile(genotype).newStates(STATES);
            ResumableRandom draws = new ResumableRandom(6);
            int stride = genotype.inputs();
            for (int step = 0; step < STEPS; step++) {
                double[] inputs = random.doubles(STATES * stride, -0.7, 0.7).toArray();
                if (step % 7 == 0) {
                    // Two states get equal inputs. Their outputs are equal if their earlier inputs were.
                    System.arraycopy(inputs, 0, inputs, stride, stride);
                }
                int which = 1 + random.nextInt((1 << STATES) - 1);
                together.activate(which, inputs, stride, draws);
                int found = together.clearlyHighest(which, 0);
                steps++;
                if (found >= 0) {
                    clear++;
                    assertThat(which >>> found & 1).isOne();
                    double highest = together.get(found).policyOutput(0);
                    assertThat(highest).isGreaterThan(-1);
                    for (int other = 0; other < STATES; other++) {
                        if ((which >>> other & 1) != 0 && other != found) {
                            assertThat(together.get(other).policyOutput(0)).isLessThan(highest);
                        }
                    }
                }
            }
        }
        assertThat(clear).isGreaterThan(steps / 2);
    }

    private Genotype sample(int i) {
        return i % 4 == 1 ? SampleGenotypes.champion(random) : SampleGenotypes.young(random);
    }

    @Test
    void roughSums_areWithinTheMargin_ofTheExactOnes() {
        int rough = 0;
        for (int i = 0; i < GENOTYPES; i++) {
            Genotype genotype = i % 2 == 0 ? sample(i / 2) : NetworkStateTest.randomGenotype(random);
            Network network = Network.compile(genotype);
            NetworkStates together = network.newStates(2);
            ResumableRandom draws = new ResumableRandom(7);
            for (int step = 0; step < STEPS; step++) {
                together.activate(
                        3, random.doubles(2L * genotype.inputs(), -0.7, 0.7).toArray(), genotype.inputs(), draws);
                NetworkState state = together.get(step % 2);
                NetworkState other = together.get(1 - step % 2);
                NetworkState partner = other.lastModule() == state.lastModule() ? other : state;
                if (network.functions == null) {
                    double[] sums = new double[4];
                    state.sumAnswersRoughly(partner, 0, sums, 0, 2);
                    state.policyOutput(0);
                    partner.policyOutput(0);
                    state.sumAnswersRoughly(partner, 0, sums, 1, 3);
                    double difference = Math.max(Math.abs(sums[0] - sums[1]), Math.abs(sums[2] - sums[3]));
                    assertThat(difference).isLessThanOrEqualTo(network.margin);
                    rough += difference > 0 ? 1 : 0;
                }
            }
        }
        assertThat(rough).as("sums that were rough").isGreaterThan(1000);
    }

    @Test
    void valuesOfManySteps_areExact_howeverSeldomTheyAreRead() {
        int roughThroughout = 0;
        int exactRecurrent = 0;
        for (int i = 0; i < GENOTYPES; i++) {
            Genotype genotype = i % 2 == 0 ? SampleGenotypes.champion(random) : NetworkStateTest.randomGenotype(random);
            // Recurrent links of small weights let differences fade away.
            Network network = Network.compile(
                    i % 4 < 3 ? NetworkStateTest.withScaledWeights(genotype, random, -6, i % 4 - 1) : genotype);
            roughThroughout += network.isRoughThroughout ? 1 : 0;
            exactRecurrent += network.remembered > 0 && !network.isRoughThroughout ? 1 : 0;
            NetworkStates together = network.newStates(2);
            NetworkState[] single = {network.newState(), network.newState()};
            ResumableRandom draws = new ResumableRandom(9);
            ResumableRandom expectedDraws = draws.copy();
            for (int step = 0; step < MANY_STEPS; step++) {
                double[] inputs =
                        random.doubles(2L * genotype.inputs(), -0.7, 0.7).toArray();
                together.activate(3, inputs, genotype.inputs(), draws);
                together.clearlyHighest(3, 0);
                for (int state = 0; state < 2; state++) {
                    single[state].activateFrom(inputs, state * genotype.inputs(), expectedDraws);
                    assertThat(together.get(state).lastModule()).isEqualTo(single[state].lastModule());
                    assertRoughSumsAreClose(together.get(state), single[state]);
                    if (random.nextInt(200) == 0) {
                        assertEqualStates(genotype, together.get(state), single[state]);
                    } else if (random.nextInt(400) == 0) {
                        together.get(state).flush();
                        single[state].flush();
                    }
                }
            }
        }
        assertThat(roughThroughout).isGreaterThan(GENOTYPES / 5);
        assertThat(exactRecurrent).isGreaterThan(GENOTYPES / 20);
    }

    private static void assertRoughSumsAreClose(NetworkState rough, NetworkState exact) {
        Network network = exact.network();
        if (network.functions == null) {
            double[] sums = new double[2];
            rough.sumAnswersRoughly(rough, 0, sums, 0, 0);
            exact.policyOutput(0);
            exact.sumAnswersRoughly(exact, 0, sums, 1, 1);
            assertThat(Math.abs(sums[0] - sums[1])).isLessThanOrEqualTo(network.margin);
        }
    }

    @Test
    void exactValues_stayExact_afterTheAnswersAreCompared() {
        ModuleLayout[] layouts = {
            ModuleLayout.multitask(3, 1), SampleGenotypes.withPreference(3), SampleGenotypes.withPreference(70)
        };
        for (int i = 0; i < GENOTYPES; i++) {
            Genotype genotype = SampleGenotypes.grown(random, 10, layouts[i % layouts.length], 20, 90);
            NetworkStates together = Network.compile(genotype).newStates(2);
            ResumableRandom draws = new ResumableRandom(8);
            for (int step = 0; step < STEPS; step++) {
                together.activate(3, random.doubles(20, -0.7, 0.7).toArray(), 10, draws);
                NetworkState read = together.get(step % 2);
                double[] before = moduleOutputs(read);
                together.clearlyHighest(3, 0);
                assertThat(moduleOutputs(read)).isEqualTo(before);
            }
        }
    }

    private static double[] moduleOutputs(NetworkState state) {
        return IntStream.range(0, state.network().modules())
                .mapToDouble(module -> state.moduleOutput(module, 0))
                .toArray();
    }

    @Test
    void sums_areClearOnlyIfTheirTangentsDiffer() {
        for (int i = 0; i < 1_000_000; i++) {
            double first = random.nextDouble(-20, 20);
            double second = first + random.nextDouble(-1, 1) * Math.scalb(1.0, -random.nextInt(50));
            int highest = HighestSum.of(new double[] {first, second}, 2, 0);
            if (highest >= 0) {
                double difference = StrictMath.tanh(first) - StrictMath.tanh(second);
                if (!(highest == 0 ? difference > 0 : difference < 0)) {
                    assertThat(highest).as("of %s and %s", first, second).isEqualTo(HighestSum.UNCLEAR);
                }
            }
        }
        assertThat(HighestSum.of(new double[] {1, 0.5}, 2, 0.2)).isZero();
        assertThat(HighestSum.of(new double[] {1, 0.5}, 2, 0.3)).isEqualTo(HighestSum.UNCLEAR);
        assertThat(HighestSum.of(new double[] {1, Double.NaN}, 2, 0)).isEqualTo(HighestSum.UNCLEAR);
        assertThat(HighestSum.of(new double[] {-14, -15}, 2, 0)).isEqualTo(HighestSum.UNCLEAR);
    }

    @Test
    void reset_makesAllStatesAsNew() {
        NetworkStates states = Network.compile(SampleGenotypes.champion(random)).newStates(2);
        double[] inputs = random.doubles(60).toArray();
        ResumableRandom draws = new ResumableRandom(1);
        states.activate(3, inputs, 30, draws);
        double first = states.get(1).policyOutput(0);
        states.activate(3, inputs, 30, draws);
        states.reset();
        assertThat(states.get(0).moduleUsage()).containsOnly(0);
        states.activate(2, inputs, 30, draws);
        assertThat(states.get(1).policyOutput(0)).isEqualTo(first);
        assertThat(states.get(0).policyOutput(0)).isZero();
    }

    @Test
    void statesThatDoNotExist_areRefused() {
        Network network = Network.compile(SampleGenotypes.champion(random));
        NetworkStates states = network.newStates(2);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> states.activate(4, new double[90], 30, new ResumableRandom(1)))
                .withMessageContaining("2 states");
        assertThatIllegalArgumentException().isThrownBy(() -> network.newStates(0));
    }

    @Test
    void rowsThatAreTooShort_areRefused() {
        NetworkStates states = Network.compile(SampleGenotypes.champion(random)).newStates(2);
        ResumableRandom draws = new ResumableRandom(1);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> states.activate(3, new double[59], 30, draws))
                .withMessage("the network has 30 inputs, got 59 values to be read from 30");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> states.activate(3, new double[60], 29, draws))
                .withMessage("stride must be at least the network's 30 inputs, is 29");
        states.activate(3, new double[60], 30, draws);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> states.clearlyHighest(3, 1))
                .withMessage("policy neuron must be 0 to 0, is 1");
    }
}
