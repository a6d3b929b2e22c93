package mmneat.nsga2;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Ranks by divide and conquer, compared with ranks from comparing every pair. */
class NondominatedRanksTest {

    private static final int SETS = 10_000;

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 6})
    void ranks_equalThoseOfAllPairs_withTiesAndDuplicates(int objectives) {
        ResumableRandom random = new ResumableRandom(objectives);
        for (int set = 0; set < SETS / 5; set++) {
            double[][] scores = randomScores(1 + random.nextInt(120), objectives, 1 + random.nextInt(15), random);
            assertThat(NondominatedRanks.of(scores))
                    .as("scores %s", Arrays.deepToString(scores))
                    .isEqualTo(ranksOfAllPairs(scores));
        }
    }

    @Test
    void ranks_equalThoseOfAllPairs_inLargeSets() {
        ResumableRandom random = new ResumableRandom(7);
        for (int objectives = 2; objectives <= 5; objectives++) {
            for (int values : List.of(10, 100, 1_000_000)) {
                double[][] scores = randomScores(700, objectives, values, random);
                assertThat(NondominatedRanks.of(scores)).isEqualTo(ranksOfAllPairs(scores));
            }
        }
    }

    @Test
    void ranks_treatTheTwoZerosAsEqual_andTellCloseScoresApart() {
        assertThat(NondominatedRanks.of(new double[][] {{0.0, 1}, {-0.0, 1}})).containsExactly(0, 0);
        assertThat(NondominatedRanks.of(new double[][] {{1, Math.nextUp(1)}, {1, 1}, {Math.nextDown(1), 1}}))
                .containsExactly(0, 1, 2);
        assertThat(NondominatedRanks.of(new double[][] {{Double.MAX_VALUE}, {-Double.MAX_VALUE}, {0}}))
                .containsExactly(0, 2, 1);
    }

    @Test
    void oneFront_andOneChain() {
        int size = 3000;
        double[][] front = new double[size][];
        double[][] chain = new double[size][];
        Arrays.setAll(front, i -> new double[] {i, -i, 0});
        Arrays.setAll(chain, i -> new double[] {i, i, i});
        assertThat(NondominatedRanks.of(front)).containsOnly(0);
        assertThat(NondominatedRanks.of(chain))
                .containsExactly(IntStream.range(0, size).map(i -> size - 1 - i).toArray());
    }

    @Test
    void emptyPopulation_andNoObjectives() {
        assertThat(NondominatedRanks.of(new double[0][])).isEmpty();
        assertThat(NondominatedRanks.of(new double[3][0])).containsExactly(0, 0, 0);
    }

    private static double[][] randomScores(int size, int objectives, int values, ResumableRandom random) {
        double[][] scores = new double[size][objectives];
        for (int i = 0; i < size; i++) {
            if (i > 0 && random.nextInt(10) == 0) {
                scores[i] = scores[random.nextInt(i)].clone();
            } else {
                Arrays.setAll(scores[i], j -> random.nextInt(values) / 4.0 - 2);
            }
        }
        return scores;
    }

    /** Deb's fast nondominated sorting: the front of an individual follows from the number of its dominators. */
    private static int[] ranksOfAllPairs(double[][] scores) {
        int size = scores.length;
        int[] dominators = new int[size];
        for (double[] score : scores) {
            for (int i = 0; i < size; i++) {
                dominators[i] += Dominance.dominates(score, scores[i]) ? 1 : 0;
            }
        }
        int[] rank = new int[size];
        int[] remaining = IntStream.range(0, size).toArray();
        for (int front = 0; remaining.length > 0; front++) {
            int number = front;
            int[] members =
                    Arrays.stream(remaining).filter(i -> dominators[i] == 0).toArray();
            remaining = Arrays.stream(remaining).filter(i -> dominators[i] > 0).toArray();
            for (int member : members) {
                rank[member] = number;
                for (int other : remaining) {
                    dominators[other] -= Dominance.dominates(scores[member], scores[other]) ? 1 : 0;
                }
            }
        }
        return rank;
    }
}
