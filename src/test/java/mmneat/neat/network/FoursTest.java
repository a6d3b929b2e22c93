package mmneat.neat.network;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class FoursTest {

    private final SplittableRandom random = new SplittableRandom(4);

    @Test
    void orderOfRandomNetworks_hasSourcesFirst_andIndependentFours() {
        for (int i = 0; i < 3_000; i++) {
            check(random.nextInt(1, 60), random.nextInt(1, 12));
        }
    }

    private void check(int nodes, int mostLinks) {
        boolean[] belongs = new boolean[nodes];
        int[][] sources = new int[nodes][];
        for (int target = 0; target < nodes; target++) {
            belongs[target] = random.nextInt(5) > 0;
            sources[target] = random.ints(random.nextInt(mostLinks), 0, nodes)
                    .distinct()
                    .sorted()
                    .toArray();
        }

        Fours fours = fours(belongs, sources);

        int[] order = fours.order();
        assertThat(Arrays.stream(order).sorted())
                .containsExactlyElementsOf(IntStream.range(0, nodes)
                        .filter(i -> belongs[i])
                        .boxed()
                        .toList());
        assertThat(fours.complete()).isBetween(0, order.length);
        assertThat(fours.complete() % Propagation.FOUR).isZero();
        int[] place = new int[nodes];
        for (int i = 0; i < order.length; i++) {
            place[order[i]] = i < fours.complete() ? i - i % Propagation.FOUR : i;
        }
        for (int target : order) {
            for (int source : sources[target]) {
                if (belongs[source] && source < target) {
                    assertThat(place[source]).isLessThan(place[target]);
                }
            }
        }
    }

    @Test
    void twoLongChains_haveNoFours() {
        boolean[] belongs = new boolean[12];
        Arrays.fill(belongs, true);
        int[][] sources = new int[12][];
        Arrays.setAll(sources, i -> i < 2 ? new int[0] : new int[] {i - 2});

        assertThat(fours(belongs, sources).complete()).isZero();
    }

    @Test
    void longestPathFirst_findsFoursThatOrderByLevelMisses() {
        // Seven neurons of the first level, and one behind the last of them.
        boolean[] belongs = new boolean[8];
        Arrays.fill(belongs, true);
        int[][] sources = {{}, {}, {}, {}, {}, {}, {}, {6}};

        Fours fours = fours(belongs, sources);

        assertThat(Arrays.stream(fours.order()).limit(Propagation.FOUR)).contains(6);
        assertThat(fours.complete()).isEqualTo(8);
    }

    @Test
    void independentNeurons_allComeInFours_butTheRest() {
        boolean[] belongs = new boolean[15];
        Arrays.fill(belongs, 1, 15, true);
        int[][] sources = new int[15][];
        // Links from what does not belong, recurrent ones and those of a neuron to itself do not count.
        Arrays.setAll(sources, i -> i == 14 ? new int[] {0, 14} : new int[] {0, i, 14});

        assertThat(fours(belongs, sources).complete()).isEqualTo(12);
    }

    private static Fours fours(boolean[] belongs, int[][] sources) {
        int[] start = new int[sources.length + 1];
        for (int i = 0; i < sources.length; i++) {
            start[i + 1] = start[i] + sources[i].length;
        }
        return new Fours(
                start, Arrays.stream(sources).flatMapToInt(Arrays::stream).toArray(), belongs);
    }
}
