package pacman.game;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import mmneat.random.ResumableRandom;

/** Places the pills and power pills of a level. Source: docs/specification/simulator.md, sections 2.2 and 7. */
final class LevelPills {

    private LevelPills() {}

    /** Places all pills of the maze except those that the rules leave out. */
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

    /** Removes the first pills of a shuffled list. */
    private static void removePreEaten(GameState state, int count) {
        List<Integer> numbers = IntStream.range(0, count).boxed().collect(Collectors.toList());
        ResumableRandom source = state.taskRandom();
        for (int i = count; i > 1; i--) {
            Collections.swap(numbers, i - 1, source.nextInt(i));
        }
        for (int i = 0; i < (int) Math.floor(state.rules.pills().preEatenPillPortion() * count); i++) {
            state.removePill(numbers.get(i));
        }
    }

    /** Places all power pills of the maze, or none. */
    static void fillPowerPills(GameState state) {
        int count = state.graph.powerPillCount();
        state.powerPills = state.has(GameSwitch.WITHOUT_POWER_PILLS) || count == 0 ? 0 : -1L >>> (64 - count);
    }

    /** Removes the pills near a power pill, as defined by the maze graph. */
    static void removeNearPowerPills(GameState state) {
        int left = 0;
        for (int word = 0; word < state.pills.length; word++) {
            state.pills[word] &= ~state.graph.pillsNearPowerPills(word);
            left += Long.bitCount(state.pills[word]);
        }
        state.pillsLeft = left;
    }
}
