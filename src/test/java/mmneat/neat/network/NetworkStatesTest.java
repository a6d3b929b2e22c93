package mmneat.neat.network;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.util.Arrays;
import java.util.SplittableRandom;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

class NetworkStatesTest {

    private static final int GENOTYPES = 200;
    private static final int STEPS = 60;
    private static final int STATES = 5;

    private final SplittableRandom random = new SplittableRandom(11);

    @Test
    void statesActivatedTogether_equalStatesActivatedOneByOne() {
        for (int i = 0; i < GENOTYPES; i++) {
            Genotype genotype =
                    i % 10 == 0 ? SampleGenotypes.champion(random) : NetworkStateTest.randomGenotype(random);
            compare(genotype, Network.compile(genotype));
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
            if (step % 2 == 0) {
                together.activate(which, inputs, stride, draws);
            } else {
                together.activate(which, rows(which, inputs, stride), draws);
            }
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

    /** One row per state that makes a step, null for the others. */
    private static double[][] rows(int which, double[] inputs, int stride) {
        double[][] rows = new double[STATES][];
        for (int i = 0; i < STATES; i++) {
            rows[i] = (which >>> i & 1) != 0 ? Arrays.copyOfRange(inputs, i * stride, (i + 1) * stride) : null;
        }
        return rows;
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
}
