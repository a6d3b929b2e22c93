package mmneat.evolution;

import java.util.Arrays;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.DoubleStream;

/**
 * The settings of targeting unachieved goals ({@link Tug}). The names in brackets are the parameters of the command
 * line.
 *
 * <p>Source: docs/specification/original-options.md, section 4.1.
 *
 * @param startingGoals by objective: the value at which the recency-weighted average of the performance starts in a new
 *     run and restarts when the goal rises. It is the objective's minimum score; the original also uses it as the first
 *     goal
 * @param initialGoals by objective: the goals of a new run ({@code setInitialTUGGoals}, {@code initialTUGGoal0}, ...)
 * @param statistics how the population's scores are summarised
 * @param increase how goals rise
 * @param options the enabled options
 * @param thrashingRatio factor by which a goal rises that was reached and lost, with {@link Option#RISE_WHEN_THRASHING}
 *     ({@code increasingTUGGoalRatio})
 * @param remainingRatio factor by which the goals of active objectives are multiplied in each generation in which not
 *     all goals are reached ({@code remainingTUGGoalRatio}). 1 leaves them as they are; below 1, positive goals drop
 * @param window the generations in which TUG is used
 */
public record TugSettings(
        double[] startingGoals,
        double[] initialGoals,
        Statistics statistics,
        Increase increase,
        Set<Option> options,
        double thrashingRatio,
        double remainingRatio,
        Window window) {

    /** The optional rules of the policy; all are off in the original's experiments with TUG. */
    public enum Option {
        /** A goal that was reached and lost rises ({@code tugGoalsIncreaseWhenThrashing}). */
        RISE_WHEN_THRASHING,
        /** Goals stop dropping once all of them have been reached ({@code stopTUGGoalDropAfterAchievement}). */
        STOP_DROPPING_AFTER_SUCCESS,
        /**
         * When a goal rises, its average restarts at the goal before it rises instead of the starting goal ({@code
         * tugResetsToPreviousGoals}).
         */
        RESTART_AT_PREVIOUS_GOALS,
        /** The first front over all objectives survives ({@code tugKeepsParetoFront}). */
        KEEP_PARETO_FRONT
    }

    /**
     * The statistics that summarise the population's scores.
     *
     * @param performance the statistic that makes the performance of the population, for example the average ({@code
     *     tugPerformanceStat})
     * @param target the statistic that makes the target, the score towards which goals move with {@link
     *     Increase.TowardsTarget}, for example the maximum ({@code tugGoalTargetStat})
     * @param recency the step of the recency-weighted averages ({@code tugAlpha})
     */
    public record Statistics(ScoreStatistic performance, ScoreStatistic target, double recency) {}

    /** The rule by which goals rise. */
    public sealed interface Increase {

        /**
         * By fixed amounts ({@code constantTUGGoalIncrements}).
         *
         * @param amounts by objective ({@code tugGoalIncrement0}, ...)
         */
        record Constant(double[] amounts) implements Increase {
            public Constant {
                amounts = amounts.clone();
            }

            @Override
            public double[] amounts() {
                return amounts.clone();
            }

            double amount(int objective) {
                return amounts[objective];
            }
        }

        /**
         * By a share of the distance to the target. The target of an objective is a statistic of the parents' scores in
         * the present generation, such as their maximum ({@link Statistics#target}). A goal rises by momentum * its
         * previous rise + rate * (target - goal).
         *
         * @param rate share of the distance ({@code tugEta})
         * @param momentum share of the previous rise ({@code tugMomentum})
         */
        record TowardsTarget(double rate, double momentum) implements Increase {}
    }

    /**
     * The generations in which TUG is used.
     *
     * @param first the first in which selection uses TUG ({@code startTUGGeneration})
     * @param last the last ({@code endTUGGeneration})
     * @param advancement number of generations since goals last rose, after which the reached goals rise although other
     *     goals are still missed ({@code tugAdvancementTimeLimit})
     */
    public record Window(int first, int last, int advancement) {
        boolean contains(int generation) {
            return generation >= first && generation <= last;
        }
    }

    /**
     * Checked settings.
     *
     * @throws IllegalArgumentException if there is no objective, the arrays differ in length, or a number is not finite
     * @throws NullPointerException if a part is missing; the message names it
     */
    public TugSettings {
        startingGoals = startingGoals.clone();
        initialGoals = initialGoals.clone();
        Objects.requireNonNull(statistics, "statistics");
        Objects.requireNonNull(increase, "increase");
        Objects.requireNonNull(window, "window");
        EnumSet<Option> chosen = EnumSet.noneOf(Option.class);
        chosen.addAll(options);
        options = Collections.unmodifiableSet(chosen);
        if (startingGoals.length == 0 || startingGoals.length != initialGoals.length) {
            throw new IllegalArgumentException(
                    "there must be as many starting goals as initial goals, at least one; there are "
                            + startingGoals.length + " and " + initialGoals.length);
        }
        if (increase instanceof Increase.Constant constant && constant.amounts.length != startingGoals.length) {
            throw new IllegalArgumentException("there must be an increment for each of the " + startingGoals.length
                    + " objectives, there are " + constant.amounts.length);
        }
        OptionalDouble infinite = DoubleStream.concat(
                        DoubleStream.concat(Arrays.stream(startingGoals), Arrays.stream(initialGoals)),
                        DoubleStream.of(thrashingRatio, remainingRatio, statistics.recency))
                .filter(value -> !Double.isFinite(value))
                .findFirst();
        if (infinite.isPresent()) {
            throw new IllegalArgumentException(
                    "goals, ratios and steps must be finite, one is " + infinite.getAsDouble());
        }
    }

    /** Number of objectives. */
    int objectives() {
        return startingGoals.length;
    }

    boolean has(Option option) {
        return options.contains(option);
    }

    @Override
    public double[] startingGoals() {
        return startingGoals.clone();
    }

    @Override
    public double[] initialGoals() {
        return initialGoals.clone();
    }

    /** The goal from which the averages of an objective start and restart. */
    double startingGoal(int objective) {
        return startingGoals[objective];
    }
}
