package mmneat.neat.network;

import java.util.Arrays;
import java.util.Objects;
import mmneat.neat.ModuleLayout;

/**
 * The rules by which a network chooses a module and forms its answer from the outputs of its modules. The published
 * experiments use only {@link #PREFERENCE}.
 *
 * <p>Modules can serve tasks. This is how hybrids work ({@link ModuleLayout#groups}): each group of modules is a task,
 * and a state of a network with groups takes {@code taskOfModule} from its layout. {@link NetworkState#presetModule}
 * then names a group, and only modules of that group are compared. {@code taskOfModule} is given here for networks that
 * have no groups in their layout, such as those of the original's hierarchical multitask.
 *
 * <p>Source: docs/specification/networks.md, sections 6.1 and 6.3.
 *
 * @param softmaxTemperature if positive, a module is drawn with a probability proportional to exp(preference /
 *     temperature); 0: the highest preference wins
 * @param disabledModule module with the constant preference -2, below all activations of tanh, in networks that have
 *     it; -1 for none. It is chosen if it is the only module of its task, seldom by softmax, or if fatigue lowers all
 *     others further
 * @param fatigueUnit amount by which the fatigue of the chosen module grows; fatigue is subtracted from a module's
 *     preference
 * @param fatigueDecay factor by which the fatigue of the other modules is multiplied
 * @param answer the combination of the modules' policy activations that the network returns
 * @param taskOfModule the number of the task that each module serves; empty if modules serve no particular task, or if
 *     the groups of the layout are the tasks
 */
public record ModuleArbitration(
        double softmaxTemperature,
        int disabledModule,
        double fatigueUnit,
        double fatigueDecay,
        Answer answer,
        int[] taskOfModule) {

    /** The combination of the modules' policy activations that the network returns. */
    public enum Answer {
        /** The activations of the chosen module alone. */
        CHOSEN_MODULE,
        /** The sum over all modules of preference times activation, divided by the number of modules. */
        WEIGHTED_AVERAGE,
        /** The average over all modules, each with the preference 1. The modules must not have preference neurons. */
        ENSEMBLE
    }

    /** The module with the highest preference answers; exact ties are broken at random. */
    public static final ModuleArbitration PREFERENCE =
            new ModuleArbitration(0, -1, 0, 1, Answer.CHOSEN_MODULE, new int[0]);

    /** Preference of a disabled module, as in the original: below every activation of tanh. */
    static final double DISABLED = -2;

    /**
     * A checked arbitration.
     *
     * @throws IllegalArgumentException if the temperature is negative, the module less than -1, or a number of fatigue
     *     not finite
     * @throws NullPointerException if a part is missing; the message names it
     */
    public ModuleArbitration {
        if (!(softmaxTemperature >= 0)) {
            throw new IllegalArgumentException(
                    "softmaxTemperature must be 0 (no softmax) or positive, is " + softmaxTemperature);
        }
        if (disabledModule < -1) {
            throw new IllegalArgumentException("disabledMode must be a module or -1 for none, is " + disabledModule);
        }
        if (!Double.isFinite(fatigueUnit) || !Double.isFinite(fatigueDecay)) {
            throw new IllegalArgumentException(
                    "preferenceNeuronFatigueUnit and preferenceNeuronDecay must be finite, are " + fatigueUnit + " and "
                            + fatigueDecay);
        }
        Objects.requireNonNull(answer, "answer");
        taskOfModule = Objects.requireNonNull(taskOfModule, "taskOfModule").clone();
    }

    /**
     * This arbitration with {@code temperature} for softmax; the original's default is 0.25.
     *
     * @throws IllegalArgumentException if it is negative
     */
    public ModuleArbitration withSoftmax(double temperature) {
        return new ModuleArbitration(temperature, disabledModule, fatigueUnit, fatigueDecay, answer, taskOfModule);
    }

    /**
     * This arbitration with a disabled module, whose preference is always -2.
     *
     * @throws IllegalArgumentException if it is less than -1
     */
    public ModuleArbitration withDisabledModule(int module) {
        return new ModuleArbitration(softmaxTemperature, module, fatigueUnit, fatigueDecay, answer, taskOfModule);
    }

    /**
     * This arbitration with fatigue: modules that were chosen often are preferred less.
     *
     * @param unit amount that is added to the fatigue of the chosen module in a step
     * @param decay factor by which the fatigue of every other module is multiplied in a step
     * @throws IllegalArgumentException if a number is not finite
     */
    public ModuleArbitration withFatigue(double unit, double decay) {
        return new ModuleArbitration(softmaxTemperature, disabledModule, unit, decay, answer, taskOfModule);
    }

    /** This arbitration with another combination of the modules' policy activations. */
    public ModuleArbitration withAnswer(Answer value) {
        return new ModuleArbitration(
                softmaxTemperature, disabledModule, fatigueUnit, fatigueDecay, value, taskOfModule);
    }

    /**
     * This arbitration for a network with several modules per task: one of the modules of the preset task is chosen by
     * preference.
     *
     * @param taskOfEachModule number of the task that each module serves
     */
    public ModuleArbitration withTasks(int... taskOfEachModule) {
        return new ModuleArbitration(
                softmaxTemperature, disabledModule, fatigueUnit, fatigueDecay, answer, taskOfEachModule);
    }

    /** The task of each module (a copy); empty if modules serve no particular task. */
    @Override
    public int[] taskOfModule() {
        return taskOfModule.clone();
    }

    /** The same for networks of a layout: in a hybrid, modules serve their groups. */
    ModuleArbitration of(ModuleLayout layout) {
        boolean isComplete = !layout.isGrouped() || taskOfModule.length > 0;
        return isComplete
                ? this
                : withTasks(layout.groups().stream().mapToInt(group -> group).toArray());
    }

    /** Whether this is plain preference. */
    boolean isPlain() {
        return equals(PREFERENCE);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof ModuleArbitration that
                && softmaxTemperature == that.softmaxTemperature
                && disabledModule == that.disabledModule
                && fatigueUnit == that.fatigueUnit
                && fatigueDecay == that.fatigueDecay
                && answer == that.answer
                && Arrays.equals(taskOfModule, that.taskOfModule);
    }

    @Override
    public int hashCode() {
        return Arrays.hashCode(taskOfModule) * 31
                + Double.hashCode(softmaxTemperature)
                + disabledModule
                + answer.hashCode();
    }
}
