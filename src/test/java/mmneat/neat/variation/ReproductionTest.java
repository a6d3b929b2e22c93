package mmneat.neat.variation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

/** Parents of different pools or tasks are refused. */
class ReproductionTest {

    private static final ModuleLayout LAYOUT = ModuleLayout.withPreferenceNeurons(2, 1);
    private static final VariationSettings SHARING_ALL = new VariationSettings(
            MutationRates.PUBLISHED, ModuleGate.PUBLISHED, 1, false, InputSelection.ALL, ActivationFunction.TANH);

    private final ResumableRandom random = new ResumableRandom(3);
    private final GenePool pool = GenePool.foundedOn(network(4, LAYOUT));
    private final Genotype own = network(4, LAYOUT);

    private Genotype network(int inputs, ModuleLayout layout) {
        return new InitialNetworks(inputs, layout).create(7, random);
    }

    private void assertRefused(Genotype other, String message) {
        Reproduction reproduction = new Reproduction(SHARING_ALL, pool);
        GenePool.State before = pool.state();
        for (int i = 0; i < 2; i++) {
            Genotype first = i == 0 ? own : other;
            Genotype second = i == 0 ? other : own;
            assertThatIllegalArgumentException()
                    .isThrownBy(() -> reproduction.fromTwo(first, second, 2, random))
                    .withMessageContaining(message);
        }
        assertThat(pool.state()).as("nothing was taken").isEqualTo(before);
    }

    @Test
    void parentsOfDifferentTasks_areNotCrossed() {
        assertRefused(network(5, LAYOUT), "parents must have equally many inputs, have ");
        assertRefused(
                network(4, ModuleLayout.withPreferenceNeurons(2, 2)),
                "parents must have equally many policy neurons per module, have ");
        assertRefused(
                network(4, ModuleLayout.multitask(4, 1)), "a multitask network cannot be crossed with one that is not");
    }

    @Test
    void parentsOfAnotherPool_areRefused() {
        GenePool other = GenePool.foundedOn(own);
        GenotypeDraft draft = GenotypeDraft.of(own);
        new SpliceNeuronMutation(ActivationFunction.TANH).apply(draft, other, random);
        Genotype foreign = draft.finish();
        String message = "genotype 7 does not belong to this pool: nodes[4] of innovation 0 is not in its archetype";
        assertRefused(foreign, message);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Reproduction(SHARING_ALL, pool).fromOne(foreign, random))
                .withMessage(message);
        assertThat(new Reproduction(SHARING_ALL, other).fromTwo(foreign, own, 2, random))
                .hasSize(2);
    }

    @Test
    void linksThatThePoolHasNotHandedOut_areRefused() {
        GenotypeDraft draft = GenotypeDraft.of(own);
        LinkGene link = draft.links().get(0);
        draft.links().set(0, link.withInnovation(12));
        assertRefused(
                draft.finish(),
                "genotype 7 does not belong to this pool: a link has innovation 12, but the pool's next innovation is 0");
    }

    @Test
    void roomForNoChild_isRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Reproduction(SHARING_ALL, pool).fromTwo(own, own, 0, random))
                .withMessage("room must be at least 1, is 0");
    }

    @Test
    void reproductionWithoutPool_isRefused() {
        assertThatNullPointerException()
                .isThrownBy(() -> new Reproduction(SHARING_ALL, null))
                .withMessage("pool");
    }
}
