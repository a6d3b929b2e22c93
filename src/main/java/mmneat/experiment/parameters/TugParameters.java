package mmneat.experiment.parameters;

import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import mmneat.evolution.ScoreStatistic;
import mmneat.evolution.Task;
import mmneat.evolution.Tug;
import mmneat.evolution.TugSettings;
import mmneat.evolution.TugSettings.Increase;
import mmneat.evolution.TugSettings.Option;
import mmneat.experiment.UserError;

/**
 * The parameters of targeting unachieved goals (TUG). Components have the names of the parameters, which the catalogue
 * describes.
 *
 * <p>Source: docs/specification/original-options.md, section 4.1.
 */
record TugParameters(
        String ea,
        double tugAlpha,
        double tugEta,
        double tugMomentum,
        boolean constantTUGGoalIncrements,
        double tugGoalIncrement0,
        double tugGoalIncrement1,
        double tugGoalIncrement2,
        double tugGoalIncrement3,
        double tugGoalIncrement4,
        String tugPerformanceStat,
        String tugGoalTargetStat,
        boolean setInitialTUGGoals,
        double initialTUGGoal0,
        double initialTUGGoal1,
        double initialTUGGoal2,
        double initialTUGGoal3,
        boolean tugResetsToPreviousGoals,
        int tugAdvancementTimeLimit,
        int startTUGGeneration,
        int endTUGGeneration,
        boolean tugGoalsIncreaseWhenThrashing,
        double increasingTUGGoalRatio,
        double remainingTUGGoalRatio,
        boolean stopTUGGoalDropAfterAchievement,
        boolean tugKeepsParetoFront) {

    /** The value of {@code ea} that chooses TUG. */
    private static final String CHOICE = "TUGNSGA2";

    /**
     * Returns the policy, if the parameters choose TUG.
     *
     * @throws UserError if there are too few parameters for the objectives of the task
     */
    Optional<Tug> tug(Task task) {
        return isChosen() ? Optional.of(new Tug(settings(task))) : Optional.empty();
    }

    boolean isChosen() {
        return ea.equals(CHOICE);
    }

    private TugSettings settings(Task task) {
        double[] starting = task.referencePoint();
        int objectives = starting.length;
        double[] initial = setInitialTUGGoals
                ? ofEach(objectives, "setInitialTUGGoals", "initialTUGGoal", initialGoals())
                : starting;
        return new TugSettings(
                starting,
                initial,
                new TugSettings.Statistics(
                        ScoreStatistic.named(tugPerformanceStat), ScoreStatistic.named(tugGoalTargetStat), tugAlpha),
                increase(objectives),
                options(),
                increasingTUGGoalRatio,
                remainingTUGGoalRatio,
                new TugSettings.Window(startTUGGeneration, endTUGGeneration, tugAdvancementTimeLimit));
    }

    private Increase increase(int objectives) {
        return constantTUGGoalIncrements
                ? new Increase.Constant(
                        ofEach(objectives, "constantTUGGoalIncrements", "tugGoalIncrement", increments()))
                : new Increase.TowardsTarget(tugEta, tugMomentum);
    }

    private double[] increments() {
        return new double[] {
            tugGoalIncrement0, tugGoalIncrement1, tugGoalIncrement2, tugGoalIncrement3, tugGoalIncrement4
        };
    }

    private double[] initialGoals() {
        return new double[] {initialTUGGoal0, initialTUGGoal1, initialTUGGoal2, initialTUGGoal3};
    }

    /**
     * Returns the values for the objectives of a task. The original has parameters only for the first few objectives.
     */
    private static double[] ofEach(int objectives, String choice, String name, double[] values) {
        if (objectives > values.length) {
            throw new UserError(choice + "=true: supports at most " + values.length + " objectives (" + name + "0 to "
                    + name + (values.length - 1) + "), but the task has " + objectives);
        }
        return Arrays.copyOf(values, objectives);
    }

    private Set<Option> options() {
        Map<Option, Boolean> choice = new EnumMap<>(Option.class);
        choice.put(Option.RISE_WHEN_THRASHING, tugGoalsIncreaseWhenThrashing);
        choice.put(Option.STOP_DROPPING_AFTER_SUCCESS, stopTUGGoalDropAfterAchievement);
        choice.put(Option.RESTART_AT_PREVIOUS_GOALS, tugResetsToPreviousGoals);
        choice.put(Option.KEEP_PARETO_FRONT, tugKeepsParetoFront);
        choice.values().removeIf(wanted -> !wanted);
        return choice.keySet();
    }

    /** The names of the parameters that have no effect without TUG. */
    static List<String> names() {
        return Arrays.stream(TugParameters.class.getRecordComponents())
                .map(component -> component.getName())
                .filter(name -> !name.equals("ea"))
                .toList();
    }
}
