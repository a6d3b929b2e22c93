package mmneat.nsga2;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Selection by the definitions, on random score sets full of ties. */
class SelectionTest {

    private static final int ROUNDS = 300;

    @Test
    void dominance_needsNoWorseAnywhereAndBetterSomewhere() {
        assertThat(Dominance.dominates(new double[] {1, 2}, new double[] {1, 1}))
                .isTrue();
        assertThat(Dominance.dominates(new double[] {1, 1}, new double[] {1, 1}))
                .isFalse();
        assertThat(Dominance.dominates(new double[] {2, 0}, new double[] {1, 1}))
                .isFalse();
    }

    @Test
    void rank_isTheNumberOfTheRoundInWhichAnIndividualIsNondominated() {
        ResumableRandom random = new ResumableRandom(1);
        for (int round = 0; round < ROUNDS; round++) {
            double[][] scores = randomScores(random);
            int[] rank = ranksByRepeatedRemoval(scores);
            for (Crowding crowding : Crowding.values()) {
                NondominatedSorting sorting = NondominatedSorting.of(scores, crowding);
                assertThat(IntStream.range(0, scores.length).map(sorting::rank).toArray())
                        .isEqualTo(rank);
            }
        }
    }

    @Test
    void fronts_divideThePopulation_inTheOrderTheCrowdingLeft() {
        ResumableRandom random = new ResumableRandom(2);
        for (int round = 0; round < ROUNDS; round++) {
            double[][] scores = randomScores(random);
            NondominatedSorting sorting = NondominatedSorting.of(scores, Crowding.WHOLE_POPULATION);
            List<Integer> order = IntStream.range(0, scores.length)
                    .map(sorting::individualAt)
                    .boxed()
                    .toList();
            Set<Integer> seen = new HashSet<>();
            for (int[] front : sorting.fronts()) {
                List<Integer> places =
                        Arrays.stream(front).map(order::indexOf).boxed().toList();
                assertThat(places).isSorted();
                Arrays.stream(front).forEach(seen::add);
            }
            assertThat(seen).hasSize(scores.length);
        }
    }

    @Test
    void returnedFronts_areCopies() {
        for (Crowding crowding : Crowding.values()) {
            NondominatedSorting sorting = NondominatedSorting.of(new double[][] {{1, 2}, {2, 1}, {0, 0}}, crowding);
            List<int[]> before = sorting.fronts().stream().map(int[]::clone).toList();
            sorting.fronts().get(0)[0] = 99;
            assertThat(sorting.fronts()).containsExactlyElementsOf(before);
        }
    }

    @Test
    void wholePopulation_hasOneMinimumAndOneMaximumPerObjective_atInfinity() {
        double[][] same = {{3, 3}, {3, 3}, {3, 3}, {3, 3}};
        NondominatedSorting sorting = NondominatedSorting.of(same, Crowding.WHOLE_POPULATION);
        assertThat(IntStream.range(0, 4).mapToDouble(sorting::crowding).toArray())
                .containsExactly(Double.POSITIVE_INFINITY, 0, 0, Double.POSITIVE_INFINITY);
    }

    @Test
    void perFront_measuresNeighboursOfTheSameFrontOnly() {
        double[][] scores = {{0, 4}, {1, 3}, {4, 0}, {0.5, 0.5}};
        NondominatedSorting perFront = NondominatedSorting.of(scores, Crowding.PER_FRONT);
        assertThat(perFront.crowding(1)).isEqualTo(2);
        assertThat(perFront.crowding(3)).isInfinite();
        NondominatedSorting whole = NondominatedSorting.of(scores, Crowding.WHOLE_POPULATION);
        assertThat(whole.crowding(1)).isEqualTo((4 - 0.5) / 4 + (4 - 0.5) / 4);
        assertThat(whole.crowding(3)).isEqualTo((1 - 0) / 4.0 + (3 - 0) / 4.0);
    }

    @Test
    void survivors_areWholeFrontsAndTheLeastCrowdedOfTheNext() {
        ResumableRandom random = new ResumableRandom(3);
        for (int round = 0; round < ROUNDS; round++) {
            double[][] scores = randomScores(random);
            int keep = random.nextInt(scores.length + 1);
            for (Crowding crowding : Crowding.values()) {
                NondominatedSorting sorting = NondominatedSorting.of(scores, crowding);
                int[] survivors = SurvivorSelection.survivors(scores, keep, crowding);
                Set<Integer> alive =
                        new HashSet<>(Arrays.stream(survivors).boxed().toList());
                assertThat(alive).hasSize(keep);
                for (int dead = 0; dead < scores.length; dead++) {
                    if (alive.contains(dead)) {
                        continue;
                    }
                    for (int survivor : survivors) {
                        assertThat(sorting.rank(survivor)).isLessThanOrEqualTo(sorting.rank(dead));
                        if (sorting.rank(survivor) == sorting.rank(dead)) {
                            assertThat(sorting.crowding(survivor)).isGreaterThanOrEqualTo(sorting.crowding(dead));
                        }
                    }
                }
            }
        }
    }

    @Test
    void crossover_makesTwoThirdsOfTheChildren_atRateOneHalf() {
        double[][] scores = randomScores(new ResumableRandom(4));
        List<Integer> parents = IntStream.range(0, scores.length).boxed().toList();
        List<String> children = new ParentSelection(true, 0.5, Crowding.WHOLE_POPULATION)
                .children(parents, scores, false, 30_000, new NamingVariation(), new ResumableRandom(5));
        double crossed =
                children.stream().filter(child -> child.startsWith("of two")).count() / 30_000.0;
        assertThat(crossed).isCloseTo(2 / 3.0, within(0.01));
    }

    @Test
    void crossoverWithRoomForOne_makesOneChild() {
        double[][] scores = {{1, 2}, {2, 1}, {0, 0}};
        List<String> children = new ParentSelection(true, 1, Crowding.WHOLE_POPULATION)
                .children(List.of(0, 1, 2), scores, true, 5, new NamingVariation(), new ResumableRandom(6));
        assertThat(children)
                .containsExactly("of two, mate", "of two, parent", "of two, mate", "of two, parent", "of two, alone");
    }

    @Test
    void noCrossover_drawsNothingForIt() {
        double[][] scores = {{1, 2}, {2, 1}};
        ResumableRandom random = new ResumableRandom(7);
        new ParentSelection(false, 0.5, Crowding.PER_FRONT)
                .children(List.of(0, 1), scores, true, 1, new NamingVariation(), random);
        ResumableRandom twoContestants = new ResumableRandom(7);
        twoContestants.nextInt(2);
        twoContestants.nextInt(2);
        assertThat(random.state()).isEqualTo(twoContestants.state());
    }

    @Test
    void hypervolume_agreesWithCountingUnitCubes() {
        ResumableRandom random = new ResumableRandom(7);
        for (int round = 0; round < 100; round++) {
            int axes = 1 + random.nextInt(3);
            double[][] points = new double[1 + random.nextInt(8)][axes];
            for (double[] point : points) {
                Arrays.setAll(point, axis -> random.nextInt(7) - 1);
            }
            assertThat(Hypervolume.of(points, new double[axes])).isEqualTo(unitCubesBelow(points, axes));
        }
    }

    @Test
    void hypervolume_ofNothing_isZero() {
        assertThat(Hypervolume.of(new double[0][], new double[2])).isZero();
        assertThat(Hypervolume.of(new double[][] {{5, 0}}, new double[2])).isZero();
    }

    @Test
    void scoresThatCannotBeCompared_areRefused() {
        assertThatThrownBy(
                        () -> SurvivorSelection.survivors(new double[][] {{1, 2}, {1}}, 1, Crowding.WHOLE_POPULATION))
                .hasMessage("individual 1 has 1 objectives, but individual 0 has 2");
        assertThatThrownBy(() -> NondominatedSorting.of(new double[][] {{Double.NaN}}, Crowding.PER_FRONT))
                .hasMessage("individual 0: score of objective 0 must be a finite number, is NaN");
        assertThatThrownBy(() -> SurvivorSelection.survivors(
                        new double[][] {{1, 2}, {1, Double.NEGATIVE_INFINITY}}, 1, Crowding.WHOLE_POPULATION))
                .hasMessage("individual 1: score of objective 1 must be a finite number, is -Infinity");
        assertThatThrownBy(() -> SurvivorSelection.survivors(new double[][] {{1}}, 2, Crowding.PER_FRONT))
                .hasMessage("number of survivors must be from 0 to 1, is 2");
        assertThatThrownBy(() -> new ParentSelection(true, 1.5, Crowding.PER_FRONT))
                .hasMessage("crossoverRate must be in [0, 1], is 1.5");
    }

    @Test
    void vectorsThatCannotBeCompared_areRefused() {
        assertThatThrownBy(() -> Dominance.dominates(new double[] {1, 2}, new double[] {1}))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("score vectors must be equally long, have 2 and 1 objectives");
        assertThatThrownBy(() -> Dominance.dominates(new double[] {1}, new double[] {0, 2}))
                .hasMessage("score vectors must be equally long, have 1 and 2 objectives");
        assertThatThrownBy(() -> Dominance.dominates(new double[] {2, Double.NaN}, new double[] {1, 1}))
                .hasMessage("scores must be numbers, are [2.0, NaN]");
        assertThatThrownBy(() -> Dominance.dominates(new double[] {2, 1}, new double[] {Double.NaN, 1}))
                .hasMessage("scores must be numbers, are [NaN, 1.0]");
    }

    @Test
    void invalidVolumes_areRefused() {
        double[] origin = {0, 0};
        assertThatThrownBy(() -> Hypervolume.of(new double[][] {{1, 2, 3}}, origin))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("scores have 3 objectives, but the reference point has 2");
        assertThatThrownBy(() -> Hypervolume.of(new double[][] {{1, 2}, {1}}, origin))
                .hasMessage("individual 1 has 1 objectives, but individual 0 has 2");
        assertThatThrownBy(() -> Hypervolume.of(new double[][] {{1, Double.NaN}}, origin))
                .hasMessage("individual 0: score of objective 1 must be a finite number, is NaN");
        assertThatThrownBy(() -> Hypervolume.of(new double[][] {{1}}, new double[] {Double.NaN}))
                .hasMessage("reference point must be finite, is [NaN]");
        assertThatThrownBy(() -> Hypervolume.of(new double[1][0], new double[0]))
                .hasMessage("the hypervolume needs at least one objective");
        assertThatThrownBy(() -> Hypervolume.frontSize(new double[][] {{1, 2}, {1}}))
                .hasMessage("individual 1 has 1 objectives, but individual 0 has 2");
    }

    @Test
    void crowding_isFinite_evenIfADifferenceOfScoresOverflows() {
        double far = 1.6e308;
        double[][] scores = {{-far, far}, {0, 0}, {far / 2, -far / 2}, {far, -far}};
        for (Crowding crowding : Crowding.values()) {
            NondominatedSorting sorting = NondominatedSorting.of(scores, crowding);
            assertThat(sorting.crowding(1)).isEqualTo(1.5);
            assertThat(sorting.crowding(2)).isEqualTo(1);
        }
    }

    @Test
    void crowdingThatIsMissing_isRefused() {
        double[][] scores = {{1}};
        assertThatThrownBy(() -> new ParentSelection(true, 0.5, null)).hasMessage("crowding");
        assertThatThrownBy(() -> SurvivorSelection.survivors(scores, 1, null)).hasMessage("crowding");
        assertThatThrownBy(() -> NondominatedSorting.of(scores, null)).hasMessage("crowding");
    }

    @Test
    void negativeNumberOfSurvivors_isRefused() {
        assertThatThrownBy(() -> SurvivorSelection.survivors(new double[][] {{1}}, -1, Crowding.PER_FRONT))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("number of survivors must be from 0 to 1, is -1");
    }

    @Test
    void parentsAndScores_areEquallyMany() {
        double[][] two = {{1}, {2}};
        assertThatThrownBy(() -> childrenOf(List.of(0, 1, 2), two, 4))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("there are 3 parents but scores of 2");
        assertThatThrownBy(() -> childrenOf(List.of(0), two, 4)).hasMessage("there are 1 parents but scores of 2");
        assertThatThrownBy(() -> childrenOf(List.of(), new double[0][], 4))
                .hasMessage("4 children cannot be made without parents");
        assertThatThrownBy(() -> childrenOf(List.of(0, 1), two, -1))
                .hasMessage("number of children must not be negative, is -1");
        assertThat(childrenOf(List.of(), new double[0][], 0)).isEmpty();
    }

    private static List<String> childrenOf(List<Integer> parents, double[][] scores, int count) {
        return new ParentSelection(true, 1, Crowding.PER_FRONT)
                .children(parents, scores, false, count, new NamingVariation(), new ResumableRandom(1));
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 4})
    @Timeout(value = 10, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
    void crossover_makesAtLeastOneChild_andNoMoreThanThereIsRoomFor(int children) {
        Variation<Integer, String> variation = new NamingVariation() {
            @Override
            public List<String> fromTwo(Integer parent, Integer mate, int room, ResumableRandom random) {
                return Collections.nCopies(children, "of two");
            }
        };
        ParentSelection selection = new ParentSelection(true, 1, Crowding.PER_FRONT);
        double[][] scores = {{1}};
        assertThatThrownBy(() -> selection.children(List.of(0), scores, false, 3, variation, new ResumableRandom(1)))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("two parents must have 1 to 3 children, the variation gave " + children);
    }

    private static double[][] randomScores(ResumableRandom random) {
        int objectives = 1 + random.nextInt(3);
        int values = 1 + random.nextInt(12);
        double[][] scores = new double[1 + random.nextInt(40)][objectives];
        for (double[] score : scores) {
            Arrays.setAll(score, j -> random.nextInt(values));
        }
        return scores;
    }

    private static int[] ranksByRepeatedRemoval(double[][] scores) {
        int[] rank = new int[scores.length];
        Set<Integer> remaining =
                new HashSet<>(IntStream.range(0, scores.length).boxed().toList());
        for (int front = 0; !remaining.isEmpty(); front++) {
            List<Integer> nondominated = remaining.stream()
                    .filter(i -> remaining.stream().noneMatch(j -> Dominance.dominates(scores[j], scores[i])))
                    .toList();
            for (int i : nondominated) {
                rank[i] = front;
            }
            nondominated.forEach(remaining::remove);
        }
        return rank;
    }

    private static double unitCubesBelow(double[][] points, int axes) {
        int side = 6;
        double count = 0;
        for (int cube = 0; cube < Math.pow(side, axes); cube++) {
            int number = cube;
            int[] corner = new int[axes];
            for (int axis = 0; axis < axes; axis++) {
                corner[axis] = number % side;
                number /= side;
            }
            boolean covered = Arrays.stream(points)
                    .anyMatch(point -> IntStream.range(0, axes).allMatch(axis -> corner[axis] + 1 <= point[axis]));
            count += covered ? 1 : 0;
        }
        return count;
    }

    private static class NamingVariation implements Variation<Integer, String> {
        @Override
        public String fromOne(Integer parent, ResumableRandom random) {
            return "of one";
        }

        @Override
        public List<String> fromTwo(Integer parent, Integer mate, int room, ResumableRandom random) {
            return room > 1 ? List.of("of two, mate", "of two, parent") : List.of("of two, alone");
        }
    }
}
