package pacman.game;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import mmneat.random.ResumableRandom;

/** Puts the pills and power pills of a level in their places. Source: docs/specification/simulator.md, sections 2.2 and 7. */
final class LevelPills {

    private LevelPills() {}

    /** All pills of the maze, but for those that the rules leave out. */
    static void fill(GameState state) {
        int count = state.graph.pillCount();
        int words = state.graph.pillWords();
        if (state.pills == null || state.pills.length != words) {
            state.pills = new long[words];
        }
        if (state.has(GameSwitch.WITHOUT_PILLS)) {
            Arrays.fill(state.pills, 0);
            state.pillsLeft = 0;
            return;
        }
        Arrays.fill(state.pills, -1L);
        state.pills[words - 1] = (1L << count) - 1;
        state.pillsLeft = count;
        if (state.rules.pills().preEatenPillPortion() > 0) {
            removePreEaten(state, count);
        }
    }

    /** The first pills of a shuffled list are missing. */
    private static void removePreEaten(GameState state, int count) {
        List<Integer> numbers = IntStream.range(0, count).boxed().collect(Collectors.toList());
        ResumableRandom source = state.drawsOfTheRun();
        for (int i = count; i > 1; i--) {
            Collections.swap(numbers, i - 1, source.nextInt(i));
        }
        for (int i = 0; i < (int) Math.floor(state.rules.pills().preEatenPillPortion() * count); i++) {
            state.removePill(numbers.get(i));
        }
    }

    /** All power pills of the maze, or none. */
    static void fillPowerPills(GameState state) {
        int count = state.graph.powerPillCount();
        state.powerPills = state.has(GameSwitch.WITHOUT_POWER_PILLS) || count == 0 ? 0 : -1L >>> (64 - count);
    }

    /** Takes away the pills that the graph counts as near a power pill. */
    static void removeNearPowerPills(GameState state) {
        int left = 0;
        for (int word = 0; word < state.pills.length; word++) {
            state.pills[word] &= ~state.graph.pillsNearPowerPills(word);
            left += Long.bitCount(state.pills[word]);
        }
        state.pillsLeft = left;
    }
}
