package mmneat.evolution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import mmneat.evolution.TugSettings.Increase;
import mmneat.evolution.TugSettings.Option;
import mmneat.nsga2.Crowding;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

/**
 * The rules of docs/specification/original-options.md, section 4: computed by hand, and compared with a plain
 * implementation.
 */
class TugTest {

    private static final TugSettings.Window ALWAYS = new TugSettings.Window(-1, Integer.MAX_VALUE, Integer.MAX_VALUE);

    private static Tug constant(double alpha, double... amounts) {
        double[] zeros = new double[amounts.length];
        return tug(zeros, alpha, new Increase.Constant(amounts), Set.of(), 1.1, 1, ALWAYS);
    }

    private static Tug tug(
            double[] goals,
            double alpha,
            Increase increase,
            Set<Option> options,
            double thrashing,
            double remaining,
            TugSettings.Window window) {
        return new Tug(new TugSettings(
                new double[goals.length],
                goals,
                new TugSettings.Statistics(ScoreStatistic.AVERAGE, ScoreStatistic.MAX, alpha),
                increase,
                options,
                thrashing,
                remaining,
                window));
    }

    private static double[][] scores(double... ofOneParent) {
        return new double[][] {ofOneParent};
    }

    @Test
    void scoreEqualToTheGoal_doesNotReachIt() {
        Tug tug = constant(1, 5, 20);
        TugState after = tug.step(tug.initial(), 0, scores(0, 7)).after();

        assertThat(after.active()).containsExactly(true, false);
        assertThat(tug.activeScores(after, 0, new double[][] {{1, 2}, {3, 4}}))
                .isDeepEqualTo(new double[][] {{1}, {3}});
    }

    @Test
    void goalsRiseTogether_whenAllAreReached_andAllObjectivesAreActiveAtOnce() {
        Tug tug = constant(1, 5, 20);
        TugState missing = tug.step(tug.initial(), 0, scores(0, 7)).after();
        TugState risen = tug.step(missing, 1, scores(1, 7)).after();

        assertThat(risen.active()).containsExactly(true, true);
        assertThat(risen.goals()).extracting(ObjectiveGoal::goal).containsExactly(5.0, 20.0);
        assertThat(risen.goals()).extracting(ObjectiveGoal::average).containsExactly(0.0, 0.0);
        assertThat(risen.lastIncrease()).isEqualTo(1);
    }

    @Test
    void averageMustReachTheGoal_too() {
        Tug tug = tug(new double[] {10}, 0.5, new Increase.Constant(new double[] {1}), Set.of(), 1.1, 1, ALWAYS);
        TugState once = tug.step(tug.initial(), 0, scores(12)).after();
        TugState twice = tug.step(once, 1, scores(20)).after();

        assertThat(once.goals().get(0).goal()).isEqualTo(10);
        assertThat(twice.goals().get(0).goal()).as("average 6, then 13").isEqualTo(11);
    }

    @Test
    void outsideItsWindow_selectionUsesAllObjectives() {
        TugSettings.Window window = new TugSettings.Window(2, 3, Integer.MAX_VALUE);
        Tug tug = tug(new double[] {0, 0}, 1, new Increase.Constant(new double[] {5, 20}), Set.of(), 1.1, 1, window);
        TugState state = tug.step(tug.initial(), 0, scores(0, 7)).after();
        double[][] all = {{1, 2}};

        assertThat(IntStream.rangeClosed(0, 5)
                        .mapToObj(generation -> tug.activeScores(state, generation, all)[0].length))
                .containsExactly(2, 2, 1, 1, 2, 2);
    }

    @Test
    void frontThatIsKept_comesFirstInInputOrder() {
        Tug tug = tug(
                new double[] {0, 0},
                1,
                new Increase.Constant(new double[] {5, 20}),
                Set.of(Option.KEEP_PARETO_FRONT),
                1.1,
                1,
                ALWAYS);
        TugState state = tug.step(tug.initial(), 0, scores(0, 7)).after();
        double[][] scores = {{1, 1}, {0, 9}, {5, 0}, {4, 0}, {3, 5}};

        int[] survivors = tug.survivors(state, 0, scores, 4, Crowding.WHOLE_POPULATION);

        assertThat(survivors).containsExactly(1, 2, 4, 3);
    }

    /** Compares with a plain implementation that follows the chapter line by line, on random scores and settings. */
    @Test
    void step_equalsThePlainForm_withRandomSettings() {
        ResumableRandom random = new ResumableRandom(11);
        for (int run = 0; run < 400; run++) {
            int objectives = 1 + random.nextInt(3);
            PlainTug plain = new PlainTug(objectives, random);
            Tug tug = plain.settings();
            TugState state = tug.initial();
            for (int g = 0; g < 25; g++) {
                double[][] scores = new double[1 + random.nextInt(5)][objectives];
                for (double[] score : scores) {
                    for (int j = 0; j < objectives; j++) {
                        score[j] = random.nextInt(4 + g);
                    }
                }
                TugStep step = tug.step(state, g, scores);
                plain.step(g, step.performance(), step.targets());
                state = step.after();
                plain.requireSame(state);
            }
        }
    }

    @Test
    void state_survivesJson() throws Exception {
        Tug tug = constant(0.3, 5, 20);
        TugState state = tug.step(tug.initial(), 0, scores(0.1, 7.3)).after();
        JsonMapper json = JsonMapper.builder().build();

        assertThat(json.readValue(json.writeValueAsBytes(state), TugState.class))
                .isEqualTo(state);
    }

    @Test
    void impossibleSettingsAndStates_areRefused() {
        assertThatThrownBy(() -> tug(new double[2], 1, new Increase.Constant(new double[1]), Set.of(), 1, 1, ALWAYS))
                .hasMessage("there must be an increment for each of the 2 objectives, there are 1");
        assertThatThrownBy(() -> tug(new double[0], 1, new Increase.TowardsTarget(1, 0), Set.of(), 1, 1, ALWAYS))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new ObjectiveGoal(Double.NaN, 0, 0, true, true))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new TugState(List.of(), 0, true)).hasMessage("goals must not be empty");
        assertThatThrownBy(() -> constant(1, 1, 2).requireFitting(constant(1, 1).initial()))
                .hasMessage("TUG has 2 objectives, the state has 1 goals");
        assertThatThrownBy(() -> constant(1, 1, 2).requireFitting(null))
                .hasMessage("TUG has 2 objectives, the state has no goals");
    }

    /** Section 4.3, implemented on arrays line by line. */
    private static final class PlainTug {
        final int n;
        final double[] goal;
        final double[] average;
        final double[] step;
        final boolean[] active;
        final boolean[] climbing;
        final double[] increment;
        final boolean constant;
        final double alpha;
        final double eta;
        final double momentum;
        final double thrashingRatio;
        final double remainingRatio;
        final int limit;
        final EnumSet<Option> options = EnumSet.noneOf(Option.class);
        int last;
        boolean dropPossible = true;

        PlainTug(int n, ResumableRandom random) {
            this.n = n;
            goal = new double[n];
            average = new double[n];
            step = new double[n];
            active = new boolean[n];
            climbing = new boolean[n];
            increment = new double[n];
            for (int j = 0; j < n; j++) {
                goal[j] = random.nextInt(4);
                increment[j] = random.nextInt(3);
                active[j] = true;
                climbing[j] = true;
            }
            constant = random.nextBoolean();
            alpha = random.nextDouble();
            eta = random.nextDouble();
            momentum = random.nextDouble();
            thrashingRatio = 1 + random.nextDouble();
            remainingRatio = random.nextBoolean() ? 1 : 0.9;
            limit = random.nextBoolean() ? Integer.MAX_VALUE : random.nextInt(4);
            for (Option option : Option.values()) {
                if (random.nextBoolean()) {
                    options.add(option);
                }
            }
        }

        Tug settings() {
            Increase increase = constant ? new Increase.Constant(increment) : new Increase.TowardsTarget(eta, momentum);
            TugSettings.Window window = new TugSettings.Window(-1, Integer.MAX_VALUE, limit);
            return tug(goal, alpha, increase, options, thrashingRatio, remainingRatio, window);
        }

        void step(int g, double[] p, double[] t) {
            boolean[] reached = new boolean[n];
            boolean all = true;
            for (int j = 0; j < n; j++) {
                average[j] = average[j] + alpha * (p[j] - average[j]);
                reached[j] = average[j] > goal[j] && p[j] > goal[j];
                if (reached[j]) {
                    climbing[j] = false;
                } else if (options.contains(Option.RISE_WHEN_THRASHING) && !climbing[j]) {
                    goal[j] = goal[j] * thrashingRatio;
                    climbing[j] = true;
                }
                all &= reached[j];
            }
            boolean timeUp = !all && g - last > limit;
            if (all && options.contains(Option.STOP_DROPPING_AFTER_SUCCESS)) {
                dropPossible = false;
            }
            if (all || timeUp) {
                last = g;
                for (int j = 0; j < n; j++) {
                    if (reached[j]) {
                        average[j] = options.contains(Option.RESTART_AT_PREVIOUS_GOALS) ? goal[j] : 0;
                        climbing[j] = true;
                        step[j] = constant ? step[j] : momentum * step[j] + eta * (t[j] - goal[j]);
                        goal[j] = goal[j] + (constant ? increment[j] : step[j]);
                        active[j] = true;
                    }
                }
            }
            for (int j = 0; j < n && !all; j++) {
                active[j] = !reached[j];
                if (active[j] && dropPossible) {
                    goal[j] = goal[j] * remainingRatio;
                }
            }
        }

        void requireSame(TugState state) {
            for (int j = 0; j < n; j++) {
                assertThat(state.goals().get(j))
                        .isEqualTo(new ObjectiveGoal(goal[j], average[j], step[j], active[j], climbing[j]));
            }
            assertThat(state.lastIncrease()).isEqualTo(last);
            assertThat(state.dropPossible()).isEqualTo(dropPossible);
        }
    }
}
