package mmneat.evolution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CancellationException;
import java.util.stream.Stream;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.neat.variation.InitialNetworks;
import mmneat.neat.variation.MutationRates;
import mmneat.neat.variation.VariationSettings;
import mmneat.nsga2.Crowding;
import mmneat.nsga2.ParentSelection;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The loop of evolution, with small tasks that are not games. */
class EvolutionTest {

    @Test
    void exclusiveOr_isLearnt() {
        Task task = XorTask.exact();
        Recording recording = evolve(settings(task, 60, 80, Crowding.WHOLE_POPULATION), task);
        Individual champion = Generation.bestIn(recording.last.parents(), 0);
        assertThat(champion.evaluation().objectives()[0]).isGreaterThan(0.9);
    }

    @ParameterizedTest
    @EnumSource(Crowding.class)
    void twoObjectives_areTradedOff_alongTheWholeFront(Crowding crowding) {
        Task task = new SchafferTask();
        Recording recording = evolve(settings(task, 20, 40, crowding), task);
        double[] answers = recording.last.parents().stream()
                .mapToDouble(parent -> parent.evaluation().otherScores()[0])
                .sorted()
                .toArray();
        assertThat(answers[0]).isBetween(-0.7, -0.4);
        assertThat(answers[answers.length - 1]).isBetween(0.4, 0.7);
    }

    @Test
    void parents_areEvaluatedAgain_inEveryGeneration() {
        Task task = new SchafferTask();
        EvolutionSettings settings = settings(task, 7, 5, Crowding.WHOLE_POPULATION);
        Recording recording = evolve(settings, task);
        assertThat(recording.evaluations).isEqualTo(5 * (7 + 7) + 7);
        Generation first = recording.generations.get(0);
        Generation second = recording.generations.get(1);
        for (Individual parent : second.parents()) {
            Stream.concat(first.parents().stream(), first.children().stream())
                    .filter(before ->
                            before.genotype().id() == parent.genotype().id())
                    .forEach(before -> assertThat(before.evaluation()).isNotEqualTo(parent.evaluation()));
        }
    }

    @Test
    void generations_haveMuParentsAndMuChildren_andTheFinalParentsNone() {
        Task task = new SchafferTask();
        Recording recording = evolve(settings(task, 6, 3, Crowding.WHOLE_POPULATION), task);
        assertThat(recording.generations).extracting(Generation::number).containsExactly(0, 1, 2);
        assertThat(recording.generations).allSatisfy(generation -> {
            assertThat(generation.parents()).hasSize(6);
            assertThat(generation.children()).hasSize(6);
            assertThat(generation.children())
                    .extracting(child -> child.genotype().id())
                    .isEqualTo(generation.offspring().stream()
                            .map(child -> child.genotype().id())
                            .toList());
        });
        assertThat(recording.last.number()).isEqualTo(3);
        assertThat(recording.last.parents()).hasSize(6);
        assertThat(recording.last.children()).isEmpty();
    }

    @Test
    void resumedEvolution_continuesExactly() {
        Task task = new SchafferTask();
        EvolutionSettings settings = settings(task, 8, 7, Crowding.WHOLE_POPULATION);
        Recording whole = evolve(settings, task);
        for (int resumedAt = 0; resumedAt < 7; resumedAt++) {
            Recording rest = new Recording();
            EvolutionState state = whole.states.get(resumedAt);
            new Evolution(settings, state, new SequentialEvaluator(task, () -> 0), rest).run();
            assertThat(rest.generations).isEqualTo(whole.generations.subList(resumedAt + 1, 7));
            assertThat(rest.states).isEqualTo(whole.states.subList(resumedAt + 1, 7));
            assertThat(rest.last).isEqualTo(whole.last);
        }
    }

    @Test
    void longerEvolution_startsLikeTheShorterOne() {
        Task task = new SchafferTask();
        Recording shorter = evolve(settings(task, 8, 3, Crowding.WHOLE_POPULATION), task);
        Recording longer = evolve(settings(task, 8, 5, Crowding.WHOLE_POPULATION), task);
        assertThat(longer.generations.subList(0, 3)).isEqualTo(shorter.generations);
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 5})
    void parallelEvaluation_givesTheSame_forAnyNumberOfThreads(int threads) {
        assertThat(evolveInParallel(threads).generations).isEqualTo(evolveInParallel(1).generations);
    }

    @Test
    void evaluationsOfOneGeneration_haveDifferentGenerators_inParallel() {
        Generation first = evolveInParallel(2).generations.get(0);
        Genotype parent = first.parents().get(0).genotype();
        try (ParallelEvaluator evaluator = new ParallelEvaluator(SchafferTask::new, 2, 1)) {
            List<Individual> twins =
                    evaluator.evaluate(List.of(parent, parent), 0, 0, new ResumableRandom(1), individual -> {});
            assertThat(twins.get(0).evaluation()).isNotEqualTo(twins.get(1).evaluation());
        }
    }

    @Test
    void evaluationThatThrows_endsTheEvolution_withItsCause() {
        EvolutionSettings settings = settings(new SchafferTask(), 3, 2, Crowding.WHOLE_POPULATION);
        EvolutionState initial = EvolutionState.initial(settings);
        Task throwing = new ConstantTask(null) {
            @Override
            public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
                throw new ArithmeticException("broken");
            }
        };
        try (ParallelEvaluator evaluator = new ParallelEvaluator(() -> throwing, 2, 1)) {
            Evolution evolution = new Evolution(settings, initial, evaluator, new Recording());
            assertThatThrownBy(evolution::run)
                    .hasMessage("genotype 1 in generation 0: java.lang.ArithmeticException: broken")
                    .hasRootCauseInstanceOf(ArithmeticException.class);
        }
    }

    @Test
    void failingEvaluation_endsTheEvolution_withItsCause() {
        Task broken = new BrokenTask();
        EvolutionSettings settings = settings(broken, 3, 2, Crowding.WHOLE_POPULATION);
        EvolutionState initial = EvolutionState.initial(settings);
        try (ParallelEvaluator evaluator = new ParallelEvaluator(BrokenTask::new, 2, 1)) {
            Evolution evolution = new Evolution(settings, initial, evaluator, new Recording());
            assertThatThrownBy(evolution::run).hasMessage("the task gave 2 objectives but names 1: [OnlyOne]");
        }
        Evolution evolution = new Evolution(settings, initial, new SequentialEvaluator(broken), new Recording());
        assertThatThrownBy(evolution::run).hasMessage("the task gave 2 objectives but names 1: [OnlyOne]");
    }

    @Test
    void interruptedThread_stopsEvolving() {
        Task task = new SchafferTask();
        EvolutionSettings settings = settings(task, 4, 3, Crowding.WHOLE_POPULATION);
        Recording recording = new Recording() {
            @Override
            public void generationCompleted(Generation generation, EvolutionState next) {
                super.generationCompleted(generation, next);
                Thread.currentThread().interrupt();
            }
        };
        Evolution evolution =
                new Evolution(settings, EvolutionState.initial(settings), new SequentialEvaluator(task), recording);
        assertThatThrownBy(evolution::run).isInstanceOf(CancellationException.class);
        assertThat(Thread.interrupted()).isTrue();
        assertThat(recording.generations).hasSize(1);
    }

    @ParameterizedTest
    @CsvSource({
        "NaN, 0, 1, the task gave NaN for the objective 'Near', which must be a finite number",
        "-Infinity, 0, 1, the task gave -Infinity for the objective 'Near', which must be a finite number",
        "0, NaN, 1, the task gave NaN for the other score 'Answer', which must be a finite number",
        "0, 0, 2, has 1 modules",
        "0, 0, 0, but the task gave the usage of 0"
    })
    void invalidEvaluation_isAnError_thatNamesGenotypeGenerationAndScore(
            double objective, double other, int modules, String message) {
        Evaluation evaluation = new Evaluation(
                new double[] {objective}, new double[] {other}, new int[modules], Evaluation.Outcomes.NONE);
        Genotype genotype = new InitialNetworks(1, ModuleLayout.single(1)).create(17, new ResumableRandom(1));
        SequentialEvaluator sequential = new SequentialEvaluator(new ConstantTask(evaluation));
        assertThatThrownBy(() -> sequential.evaluate(List.of(genotype), 5, 0, new ResumableRandom(1), individual -> {}))
                .hasMessageStartingWith("genotype 17 in generation 5")
                .hasMessageContaining(message);
        try (ParallelEvaluator parallel = new ParallelEvaluator(() -> new ConstantTask(evaluation), 2, 1)) {
            assertThatThrownBy(
                            () -> parallel.evaluate(List.of(genotype), 5, 0, new ResumableRandom(1), individual -> {}))
                    .isInstanceOf(BadEvaluationException.class)
                    .hasMessageStartingWith("genotype 17 in generation 5")
                    .hasMessageContaining(message);
        }
    }

    @Test
    void initialPopulationSeed_changesThePopulationAlone() {
        Task task = XorTask.exact();
        EvolutionSettings settings = settings(task, 4, 1, Crowding.WHOLE_POPULATION);
        EvolutionSettings reseeded = new EvolutionSettings(
                settings.seed(),
                OptionalInt.of(99),
                settings.populationSize(),
                settings.generations(),
                settings.cleanFrequency(),
                settings.initialNetworks(),
                settings.parentSelection(),
                settings.variation());
        EvolutionState plain = EvolutionState.initial(settings);
        EvolutionState other = EvolutionState.initial(reseeded);
        assertThat(other.population()).isNotEqualTo(plain.population());
        assertThat(other.random()).isEqualTo(plain.random());
        assertThat(other.pool()).isEqualTo(plain.pool());
    }

    @Test
    void champion_isTheLastOfTheBest_asTheTaskRanksThem() {
        Genotype genotype = EvolutionState.initial(settings(new SchafferTask(), 1, 1, Crowding.PER_FRONT))
                .population()
                .get(0);
        List<Individual> parents = new ArrayList<>();
        for (double score : new double[] {1, 7.2, 7.9, 7.4, 3}) {
            Evaluation evaluation = new Evaluation(
                    new double[] {score, -score}, new double[] {score}, new int[1], Evaluation.Outcomes.NONE);
            parents.add(Individual.of(genotype.withId(parents.size()), evaluation, 0));
        }
        Generation generation = new Generation(0, parents, List.of(), List.of(), 0);
        assertThat(generation.champion(new SchafferTask()).genotype().id()).isEqualTo(2);
        assertThat(generation.champion(new CoarselyRanked()).genotype().id()).isEqualTo(3);
        assertThat(Generation.bestIn(parents, 1).genotype().id()).isZero();
    }

    @Test
    void impossibleSettings_areRefused() {
        EvolutionSettings settings = settings(new SchafferTask(), 4, 1, Crowding.PER_FRONT);
        assertThatThrownBy(() -> new EvolutionSettings(
                        1,
                        OptionalInt.empty(),
                        0,
                        1,
                        10,
                        settings.initialNetworks(),
                        settings.parentSelection(),
                        settings.variation()))
                .hasMessage("populationSize must be at least 1, is 0");
    }

    @Test
    void statesOfOtherSettings_areRefused() {
        Task task = new SchafferTask();
        EvolutionState four = EvolutionState.initial(settings(task, 4, 1, Crowding.PER_FRONT));
        EvolutionSettings six = settings(task, 6, 1, Crowding.PER_FRONT);
        assertThatThrownBy(() -> new Evolution(six, four, new SequentialEvaluator(task), new Recording()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("population size mismatch: 6 in the settings, 4 in the state");
        assertThatThrownBy(() -> new EvolutionState(0, List.of(), four.pool(), four.random(), null))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("population must not be empty");
        assertThatThrownBy(() -> new EvolutionState(0, null, four.pool(), four.random(), null))
                .hasMessage("population");
    }

    @Test
    void invalidGenerations_areRefused() {
        assertThatThrownBy(() -> new Generation(-1, List.of(), List.of(), List.of(), 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("number must not be negative, is -1");
        assertThatThrownBy(() -> new Generation(0, null, List.of(), List.of(), 0))
                .hasMessage("parents");
        assertThatThrownBy(() -> Generation.bestIn(List.of(), 0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("the population is empty, so it has no best individual");
    }

    private static Recording evolve(EvolutionSettings settings, Task task) {
        Recording recording = new Recording();
        new Evolution(settings, EvolutionState.initial(settings), new SequentialEvaluator(task, () -> 0), recording)
                .run();
        return recording;
    }

    private static Recording evolveInParallel(int threads) {
        EvolutionSettings settings = settings(new SchafferTask(), 6, 4, Crowding.WHOLE_POPULATION);
        Recording recording = new Recording();
        try (ParallelEvaluator evaluator = new ParallelEvaluator(SchafferTask::new, threads, settings.seed())) {
            new Evolution(settings, EvolutionState.initial(settings), evaluator, recording).run();
        }
        return recording.withoutTimes();
    }

    private static EvolutionSettings settings(Task task, int mu, int generations, Crowding crowding) {
        return new EvolutionSettings(
                3,
                OptionalInt.empty(),
                mu,
                generations,
                2,
                new InitialNetworks(task.inputs(), new ModuleLayout(2, 1, task.policyNeuronsPerModule(), false)),
                new ParentSelection(true, 0.5, crowding),
                new VariationSettings(MutationRates.PUBLISHED.withModuleDuplication(0.1)));
    }

    /** Records all events. */
    private static class Recording implements EvolutionObserver {
        final List<Generation> generations = new ArrayList<>();
        final List<EvolutionState> states = new ArrayList<>();
        Generation last;
        int evaluations;

        @Override
        public void evaluated(int generation, int done, int total, Individual individual) {
            evaluations++;
        }

        @Override
        public void generationCompleted(Generation generation, EvolutionState next) {
            assertThat(evaluations % (2 * next.population().size())).isZero();
            generations.add(generation);
            states.add(next);
        }

        @Override
        public void completed(Generation finalParents) {
            last = finalParents;
        }

        Recording withoutTimes() {
            generations.replaceAll(generation -> new Generation(
                    generation.number(),
                    withoutTimes(generation.parents()),
                    generation.offspring(),
                    withoutTimes(generation.children()),
                    generation.archetypeSize()));
            return this;
        }

        private static List<Individual> withoutTimes(List<Individual> individuals) {
            return individuals.stream()
                    .map(individual -> new Individual(individual.genotype(), individual.evaluation(), 0))
                    .toList();
        }
    }

    /** Names one objective but returns two scores. */
    private static final class BrokenTask extends SchafferTask {
        @Override
        public List<String> objectiveNames() {
            return List.of("OnlyOne");
        }
    }

    /** Returns the same scores for every genotype. */
    private static class ConstantTask extends SmallTask {
        private final Evaluation evaluation;

        ConstantTask(Evaluation evaluation) {
            this.evaluation = evaluation;
        }

        @Override
        public List<String> objectiveNames() {
            return List.of("Near");
        }

        @Override
        public List<String> otherScoreNames() {
            return List.of("Answer");
        }

        @Override
        public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
            return evaluation;
        }
    }

    /** Compares champions by whole points. */
    private static final class CoarselyRanked extends SchafferTask {
        @Override
        public double championRank(Evaluation evaluation) {
            return (int) championScore(evaluation);
        }
    }
}
