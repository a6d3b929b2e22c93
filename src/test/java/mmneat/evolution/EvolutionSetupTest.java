package mmneat.evolution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.variation.MutationOperator;
import mmneat.neat.variation.MutationRates;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

class EvolutionSetupTest {

    /** Rewards large weights and reports that all modules are chosen equally often. */
    private static final Task WEIGHTS = Task.of(List.of("Weights"), List.of("Bias"), 1, (genotype, random) -> {
        int[] usage = new int[genotype.modules()];
        java.util.Arrays.fill(usage, 1);
        return Evaluation.of(
                usage, genotype.links().stream().mapToDouble(LinkGene::weight).sum());
    });

    @Test
    void run_equalsTheLoopWrittenByHand() {
        Generation last =
                Evolution.of(WEIGHTS).populationSize(6).generations(4).seed(3).run();

        EvolutionSettings published = EvolutionSettings.published(WEIGHTS);
        EvolutionSettings settings = new EvolutionSettings(
                3,
                published.initialPopulationSeed(),
                6,
                4,
                published.cleanFrequency(),
                published.initialNetworks(),
                published.parentSelection(),
                published.variation());
        Generation byHand = new Evolution(
                        settings,
                        EvolutionState.initial(settings),
                        new SequentialEvaluator(WEIGHTS),
                        new EvolutionObserver() {})
                .run();
        assertThat(last.number()).isEqualTo(4);
        assertThat(last.parents().stream().map(Individual::genotype))
                .isEqualTo(byHand.parents().stream().map(Individual::genotype).toList());
        assertThat(Evolution.of(WEIGHTS).settings(settings).run().parents().stream()
                        .map(Individual::genotype))
                .isEqualTo(byHand.parents().stream().map(Individual::genotype).toList());
    }

    @Test
    void moduleUsage_isFedBack_soThatModulesAreAdded() {
        Generation last = Evolution.of(WEIGHTS)
                .populationSize(6)
                .generations(10)
                .modules(1)
                .rates(MutationRates.PUBLISHED.withModuleDuplication(0.5))
                .run();
        assertThat(last.champion(WEIGHTS).genotype().modules()).isGreaterThan(1);
    }

    @Test
    void observers_seeEveryGeneration() {
        List<Integer> generations = new ArrayList<>();
        int[] evaluated = {0};
        Evolution.of(WEIGHTS)
                .populationSize(3)
                .generations(2)
                .onGeneration(generation -> generations.add(generation.number()))
                .observer(new EvolutionObserver() {
                    @Override
                    public void evaluated(int generation, int done, int total, Individual individual) {
                        evaluated[0]++;
                    }
                })
                .run();
        assertThat(generations).containsExactly(0, 1, 2);
        assertThat(evaluated[0]).isEqualTo(2 * 6 + 3);
    }

    /** Sets the first link's weight to 1000. */
    private static final class HeavyLink implements MutationOperator {

        @Override
        public String logName() {
            return "HEAVY";
        }

        @Override
        public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
            List<LinkGene> links = new ArrayList<>(offspring.links());
            LinkGene link = links.get(0);
            links.set(0, new LinkGene(link.innovation(), link.source(), link.target(), 1000, link.recurrent()));
            offspring.replaceGenes(offspring.nodes(), links);
            return true;
        }
    }

    @Test
    void ownMutation_isTriedAndLogged() {
        List<String> mutations = new ArrayList<>();
        Generation last = Evolution.of(WEIGHTS)
                .populationSize(4)
                .generations(2)
                .mutation(0.5, new HeavyLink())
                .onGeneration(
                        generation -> generation.offspring().forEach(child -> mutations.addAll(child.mutations())))
                .run();
        assertThat(mutations).contains("HEAVY");
        assertThat(last.champion(WEIGHTS).evaluation().objectives()[0]).isGreaterThan(500);
    }

    @Test
    void impossibleSettings_areRefused_byTheLibrarysNames() {
        EvolutionSetup setup = Evolution.of(WEIGHTS);
        assertThatThrownBy(() -> setup.generations(-1)).hasMessage("generations must be at least 0, is -1");
        assertThatThrownBy(() -> setup.mutation(2, new HeavyLink()))
                .hasMessage("rate of the mutation 'HEAVY' must be in [0, 1], is 2.0");
        assertThatThrownBy(() -> setup.rates(new MutationRates(
                        1.5,
                        0,
                        0,
                        0,
                        MutationRates.ModuleRates.NONE,
                        MutationRates.DeletionRates.NONE,
                        MutationRates.FreezingRates.NONE)))
                .hasMessage("newLink must be in [0, 1], is 1.5");
        assertThatThrownBy(() -> Task.of(List.of(), List.of("Bias"), 1, (genotype, random) -> null))
                .hasMessageContaining("at least one objective");
    }
}
