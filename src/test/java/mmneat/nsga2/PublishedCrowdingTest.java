package mmneat.nsga2;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Crowding per front, compared with a plain implementation of Deb et al. 2002, section III, on random score sets full
 * of ties. Where the paper leaves the order open, individuals keep the order of the scores, and sorting is stable.
 */
class PublishedCrowdingTest {

    private static final int ROUNDS = 300;

    private final ResumableRandom random = new ResumableRandom(8);

    @Test
    void frontsAndDistances_equalThePapers() {
        for (int round = 0; round < ROUNDS; round++) {
            PlainSorting plain = new PlainSorting(randomScores());
            NondominatedSorting sorting = NondominatedSorting.of(plain.scores, Crowding.PER_FRONT);
            assertThat(sorting.fronts())
                    .containsExactlyElementsOf(plain.fronts.stream()
                            .map(PublishedCrowdingTest::array)
                            .toList());
            for (int i = 0; i < plain.scores.length; i++) {
                assertThat(sorting.individualAt(i)).isEqualTo(i);
                assertThat(sorting.rank(i)).isEqualTo(plain.rank[i]);
                assertThat(sorting.crowding(i)).isEqualTo(plain.distance[i]);
            }
        }
    }

    @Test
    void survivors_equalThePapers_inTheOrderOfTheScores() {
        for (int round = 0; round < ROUNDS; round++) {
            PlainSorting plain = new PlainSorting(randomScores());
            int keep = random.nextInt(plain.scores.length + 1);
            assertThat(SurvivorSelection.survivors(plain.scores, keep, Crowding.PER_FRONT))
                    .isEqualTo(plain.survivors(keep));
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void parents_winByRankThenDistance_inEveryGeneration(boolean isFirstGeneration) {
        for (int round = 0; round < ROUNDS; round++) {
            PlainSorting plain = new PlainSorting(randomScores());
            List<Integer> everybody =
                    IntStream.range(0, plain.scores.length).boxed().toList();
            ResumableRandom expectedDraws = random.copy();
            List<Integer> parents = new ParentSelection(false, 0, Crowding.PER_FRONT)
                    .children(everybody, plain.scores, isFirstGeneration, 20, new Cloning(), random);
            for (int parent : parents) {
                int first = expectedDraws.nextInt(plain.scores.length);
                int second = expectedDraws.nextInt(plain.scores.length);
                assertThat(parent).isEqualTo(plain.isBetter(second, first) ? second : first);
            }
        }
    }

    private double[][] randomScores() {
        int objectives = 1 + random.nextInt(3);
        int values = 1 + random.nextInt(12);
        double[][] scores = new double[1 + random.nextInt(30)][objectives];
        for (double[] score : scores) {
            Arrays.setAll(score, j -> random.nextInt(values));
        }
        return scores;
    }

    private static int[] array(List<Integer> individuals) {
        return individuals.stream().mapToInt(i -> i).toArray();
    }

    /** The paper's definitions, implemented plainly and slowly. */
    private static final class PlainSorting {
        final double[][] scores;
        final List<List<Integer>> fronts = new ArrayList<>();
        final int[] rank;
        final double[] distance;

        PlainSorting(double[][] scores) {
            this.scores = scores;
            rank = new int[scores.length];
            distance = new double[scores.length];
            Arrays.fill(rank, Integer.MAX_VALUE);
            for (int front = 0; Arrays.stream(rank).anyMatch(r -> r == Integer.MAX_VALUE); front++) {
                int round = front;
                IntPredicate isLeft = i -> rank[i] >= round;
                List<Integer> members = IntStream.range(0, scores.length)
                        .filter(isLeft)
                        .filter(i -> IntStream.range(0, scores.length)
                                .filter(isLeft)
                                .noneMatch(j -> dominates(scores[j], scores[i])))
                        .boxed()
                        .toList();
                members.forEach(i -> rank[i] = round);
                addDistances(members);
                fronts.add(members);
            }
        }

        private static boolean dominates(double[] a, double[] b) {
            return IntStream.range(0, a.length).allMatch(j -> a[j] >= b[j]) && !Arrays.equals(a, b);
        }

        private void addDistances(List<Integer> members) {
            Comparator<Integer> order = Comparator.naturalOrder();
            for (int j = 0; j < scores[0].length; j++) {
                int objective = j;
                // One stable sort per objective, as in the paper; ties keep the order of the previous objective.
                order = Comparator.<Integer>comparingDouble(i -> scores[i][objective])
                        .thenComparing(order);
                List<Integer> sorted = members.stream().sorted(order).toList();
                int last = sorted.size() - 1;
                distance[sorted.get(0)] = Double.POSITIVE_INFINITY;
                distance[sorted.get(last)] = Double.POSITIVE_INFINITY;
                double range = scores[sorted.get(last)][j] - scores[sorted.get(0)][j];
                for (int k = 1; k < last && range > 0; k++) {
                    distance[sorted.get(k)] += (scores[sorted.get(k + 1)][j] - scores[sorted.get(k - 1)][j]) / range;
                }
            }
        }

        /** The crowded comparison: lower rank, or equal rank and larger distance. */
        boolean isBetter(int a, int b) {
            return rank[a] < rank[b] || rank[a] == rank[b] && distance[a] > distance[b];
        }

        int[] survivors(int count) {
            List<Integer> survivors = new ArrayList<>();
            for (List<Integer> front : fronts) {
                List<Integer> members = new ArrayList<>(front);
                if (survivors.size() + front.size() > count) {
                    members.sort(Comparator.<Integer>comparingDouble(i -> -distance[i])
                            .thenComparing(Comparator.reverseOrder()));
                }
                survivors.addAll(members.subList(0, Math.min(members.size(), count - survivors.size())));
            }
            return array(survivors);
        }
    }

    private static final class Cloning implements Variation<Integer, Integer> {
        @Override
        public Integer fromOne(Integer parent, ResumableRandom draws) {
            return parent;
        }

        @Override
        public List<Integer> fromTwo(Integer parent, Integer mate, int room, ResumableRandom draws) {
            throw new AssertionError("nothing is crossed");
        }
    }
}
