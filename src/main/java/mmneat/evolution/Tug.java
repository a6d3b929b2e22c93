package mmneat.evolution;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import mmneat.evolution.TugSettings.Increase;
import mmneat.evolution.TugSettings.Option;
import mmneat.nsga2.Crowding;
import mmneat.nsga2.NondominatedSorting;
import mmneat.nsga2.SurvivorSelection;
import org.jspecify.annotations.Nullable;

/**
 * Targeting unachieved goals (TUG): a policy that gives selection only the objectives whose goals the population has
 * not reached.
 *
 * <p>Every objective has a goal, a score that the population as a whole is to exceed. Once per generation the policy
 * compares the goal of each objective with a recency-weighted average of the population's performance, and with the
 * present performance. If both exceed the goal, the goal is reached.
 *
 * <ul>
 *   <li>An objective whose goal is reached is not active: selection does not use it until the goal is missed again or
 *       all goals are reached.
 *   <li>When all goals are reached, all goals rise, all objectives are active again, and the averages restart.
 *   <li>When some goals have been missed for too long ({@link TugSettings.Window#advancement}), the reached goals rise
 *       without the others.
 *   <li>While some goals are missed, the goals of the active objectives are multiplied by {@link
 *       TugSettings#remainingRatio} in each generation. The ratio is 1 by default; with a ratio below 1 goals that are
 *       too high drop until they can be reached.
 * </ul>
 *
 * <p>The policy draws no random numbers and keeps no state: {@link #step} maps one {@link TugState} to the next.
 *
 * <p>Source: J. Schrum, R. Miikkulainen: Evolving agent behavior in multiobjective domains using fitness-based shaping
 * (GECCO 2010); docs/specification/original-options.md, section 4.
 */
public final class Tug {

    private final TugSettings settings;

    /** Creates the policy. */
    public Tug(TugSettings settings) {
        this.settings = settings;
    }

    /** Returns the state in which a new run starts. */
    TugState initial() {
        double[] goals = settings.initialGoals();
        return new TugState(
                IntStream.range(0, goals.length)
                        .mapToObj(j -> ObjectiveGoal.initial(goals[j], settings.startingGoal(j)))
                        .toList(),
                0,
                true);
    }

    /**
     * Checks that a state fits these settings.
     *
     * @throws IllegalArgumentException if it has another number of goals
     */
    void requireFitting(@Nullable TugState state) {
        if (state == null || state.goals().size() != settings.objectives()) {
            throw new IllegalArgumentException("TUG has " + settings.objectives() + " objectives, the state has "
                    + (state == null ? "no" : state.goals().size()) + " goals");
        }
    }

    /**
     * Computes the state for one generation. Call it after the parents have been evaluated and before the first child
     * is made.
     *
     * @param generation from 0
     * @param scores {@code scores[parent][objective]}, in population order
     * @throws IllegalArgumentException if a goal would leave the range of numbers
     */
    TugStep step(TugState before, int generation, double[][] scores) {
        int objectives = settings.objectives();
        double[] performance = new double[objectives];
        double[] targets = new double[objectives];
        for (int j = 0; j < objectives; j++) {
            summarise(j, scores, performance, targets);
        }
        List<ObjectiveGoal> goals = new ArrayList<>(before.goals());
        boolean[] reached = new boolean[objectives];
        for (int j = 0; j < objectives; j++) {
            goals.set(j, averaged(goals.get(j), performance[j]));
            reached[j] = goals.get(j).average() > goals.get(j).goal()
                    && performance[j] > goals.get(j).goal();
            goals.set(j, climbed(goals.get(j), reached[j]));
        }
        TugState after = countOf(reached) == objectives
                ? allReached(before, generation, goals, targets)
                : someMissing(before, generation, goals, targets, reached);
        return new TugStep(after, performance, targets);
    }

    private void summarise(int objective, double[][] scores, double[] performance, double[] targets) {
        double[] values =
                Arrays.stream(scores).mapToDouble(score -> score[objective]).toArray();
        ScoreStatistic statistic = settings.statistics().performance();
        performance[objective] = statistic.of(values);
        // The original's quirk: these two sort the array that the target's statistic reads afterwards.
        if (statistic == ScoreStatistic.MEDIAN || statistic == ScoreStatistic.MODE) {
            Arrays.sort(values);
        }
        targets[objective] = settings.statistics().target().of(values);
    }

    private ObjectiveGoal averaged(ObjectiveGoal goal, double performance) {
        return goal.withAverage(goal.average() + settings.statistics().recency() * (performance - goal.average()));
    }

    private ObjectiveGoal climbed(ObjectiveGoal goal, boolean isReached) {
        if (isReached) {
            return goal.withClimbing(false);
        }
        return settings.has(Option.RISE_WHEN_THRASHING) && !goal.climbing()
                ? goal.withGoal(goal.goal() * settings.thrashingRatio()).withClimbing(true)
                : goal;
    }

    private static int countOf(boolean[] reached) {
        return (int) IntStream.range(0, reached.length).filter(j -> reached[j]).count();
    }

    private TugState allReached(TugState before, int generation, List<ObjectiveGoal> goals, double[] targets) {
        for (int j = 0; j < goals.size(); j++) {
            goals.set(j, raised(restarted(goals.get(j), j), j, targets[j]));
        }
        boolean dropPossible = before.dropPossible() && !settings.has(Option.STOP_DROPPING_AFTER_SUCCESS);
        return new TugState(goals, generation, dropPossible);
    }

    private TugState someMissing(
            TugState before, int generation, List<ObjectiveGoal> goals, double[] targets, boolean[] reached) {
        boolean isTimeUp =
                generation - before.lastIncrease() > settings.window().advancement();
        for (int j = 0; j < goals.size(); j++) {
            if (isTimeUp && reached[j]) {
                goals.set(j, raised(restarted(goals.get(j), j), j, targets[j]));
            }
            ObjectiveGoal goal = goals.get(j).withActive(!reached[j]);
            boolean drops = goal.active() && before.dropPossible();
            goals.set(j, drops ? goal.withGoal(goal.goal() * settings.remainingRatio()) : goal);
        }
        return new TugState(goals, isTimeUp ? generation : before.lastIncrease(), before.dropPossible());
    }

    private ObjectiveGoal restarted(ObjectiveGoal goal, int objective) {
        boolean atPrevious = settings.has(Option.RESTART_AT_PREVIOUS_GOALS);
        return goal.withAverage(atPrevious ? goal.goal() : settings.startingGoal(objective))
                .withClimbing(true);
    }

    private ObjectiveGoal raised(ObjectiveGoal goal, int objective, double target) {
        Increase increase = settings.increase();
        if (increase instanceof Increase.TowardsTarget towards) {
            double step = towards.momentum() * goal.lastStep() + towards.rate() * (target - goal.goal());
            return goal.raised(goal.goal() + step, step);
        }
        double amount = ((Increase.Constant) increase).amount(objective);
        return goal.raised(goal.goal() + amount, goal.lastStep());
    }

    /**
     * The scores in the objectives that selection uses, in increasing order of the objectives.
     *
     * @param scores {@code scores[individual][objective]}
     */
    double[][] activeScores(TugState state, int generation, double[][] scores) {
        if (!settings.window().contains(generation)) {
            return scores;
        }
        boolean[] active = state.active();
        int[] used = IntStream.range(0, active.length).filter(j -> active[j]).toArray();
        return Arrays.stream(scores)
                .map(score -> Arrays.stream(used).mapToDouble(j -> score[j]).toArray())
                .toArray(double[][]::new);
    }

    /**
     * The survivors of a generation.
     *
     * @param scores {@code scores[individual][objective]}: parents followed by children
     * @return indices of the survivors, in the order in which they are the next parents
     */
    int[] survivors(TugState state, int generation, double[][] scores, int count, Crowding crowding) {
        double[][] active = activeScores(state, generation, scores);
        if (!settings.has(Option.KEEP_PARETO_FRONT)) {
            return SurvivorSelection.survivors(active, count, crowding);
        }
        int[] front = NondominatedSorting.of(scores, crowding).fronts().get(0);
        Arrays.sort(front);
        if (front.length > count) {
            return survivorsAmong(front, active, count, crowding);
        }
        int[] others = IntStream.range(0, scores.length)
                .filter(i -> Arrays.binarySearch(front, i) < 0)
                .toArray();
        int[] rest = survivorsAmong(others, active, count - front.length, crowding);
        return IntStream.concat(Arrays.stream(front), Arrays.stream(rest)).toArray();
    }

    private static int[] survivorsAmong(int[] candidates, double[][] scores, int count, Crowding crowding) {
        double[][] ofCandidates =
                Arrays.stream(candidates).mapToObj(i -> scores[i]).toArray(double[][]::new);
        return Arrays.stream(SurvivorSelection.survivors(ofCandidates, count, crowding))
                .map(i -> candidates[i])
                .toArray();
    }
}
