package mmneat.neat.network;

import java.util.Arrays;
import mmneat.neat.ModuleLayout;
import mmneat.random.Argmax;
import mmneat.random.ResumableRandom;

/**
 * Chooses modules and combines their answers in the ways that the published experiments do not use, and keeps the
 * modules' fatigue.
 *
 * <p>Source: docs/specification/networks.md, section 6.3.
 */
final class ModuleArbiter {

    /** Preference of a module that serves another task than the preset one: not to be chosen, whatever the others'. */
    private static final double OTHER_TASK = Double.NEGATIVE_INFINITY;

    private final ModuleLayout layout;
    private final ModuleArbitration arbitration;
    private final int[] taskOfModule;
    /** Preference of each module in the last step, as it was compared. */
    private final double[] preferences;

    private final double[] fatigue;
    private final double[] shares;

    ModuleArbiter(ModuleLayout layout, ModuleArbitration arbitration) {
        this.layout = layout;
        this.arbitration = arbitration;
        taskOfModule = arbitration.taskOfModule();
        int modules = layout.modules();
        preferences = new double[modules];
        fatigue = new double[modules];
        shares = new double[modules];
        if (taskOfModule.length != 0 && taskOfModule.length != modules) {
            throw new IllegalArgumentException(
                    "taskOfModule must name a task for each of " + modules + " modules, names " + taskOfModule.length);
        }
        if (arbitration.answer() == ModuleArbitration.Answer.ENSEMBLE && layout.hasPreferenceNeurons()) {
            throw new IllegalArgumentException("an ensemble's modules must not have preference neurons");
        }
    }

    /** Chooses a module after a step; one {@code nextInt} for the highest, one {@code nextDouble} for softmax. */
    int choose(NetworkState state, int preset, ResumableRandom random) {
        for (int module = 0; module < preferences.length; module++) {
            preferences[module] = preference(state, module, preset) - fatigue[module];
            if (taskOfModule.length > 0 && taskOfModule[module] != preset) {
                preferences[module] = OTHER_TASK;
            } else if (module == arbitration.disabledModule()) {
                preferences[module] = ModuleArbitration.DISABLED;
            }
        }
        int chosen = arbitration.softmaxTemperature() > 0 ? drawByShare(random) : Argmax.of(preferences, random);
        tire(chosen);
        return chosen;
    }

    private double preference(NetworkState state, int module, int preset) {
        if (layout.modules() == 1 || arbitration.answer() == ModuleArbitration.Answer.ENSEMBLE) {
            return 1;
        }
        if (layout.standardMultitask()) {
            return module == preset ? 1 : 0;
        }
        return state.preference(module);
    }

    private int drawByShare(ResumableRandom random) {
        double total = computeShares(0);
        if (!(total > 0 && total < Double.POSITIVE_INFINITY)) {
            // At low temperatures the exponentials leave the range of numbers; their proportions stay the same.
            total = computeShares(highestPreference());
        }
        double left = random.nextDouble() * total;
        int chosen = 0;
        for (int module = 0; module < shares.length; module++) {
            // Rounding may leave a little behind the last share; a module without one is never chosen.
            if (shares[module] > 0) {
                chosen = module;
                if (left < shares[module]) {
                    return chosen;
                }
                left -= shares[module];
            }
        }
        return chosen;
    }

    private double computeShares(double offset) {
        double total = 0;
        for (int module = 0; module < shares.length; module++) {
            shares[module] = StrictMath.exp((preferences[module] - offset) / arbitration.softmaxTemperature());
            total += shares[module];
        }
        return total;
    }

    private double highestPreference() {
        double highest = preferences[0];
        for (double preference : preferences) {
            highest = Math.max(highest, preference);
        }
        return highest;
    }

    private void tire(int chosen) {
        for (int module = 0; module < fatigue.length; module++) {
            if (module == chosen) {
                fatigue[module] += arbitration.fatigueUnit();
            } else {
                fatigue[module] *= arbitration.fatigueDecay();
            }
        }
    }

    void flush() {
        Arrays.fill(fatigue, 0);
    }

    /** Refuses a preset task that no module serves; without tasks, nothing. */
    void requireTask(int task) {
        boolean isServed = taskOfModule.length == 0;
        for (int served : taskOfModule) {
            isServed |= served == task;
        }
        if (!isServed) {
            throw new IllegalArgumentException(
                    "no module serves task " + task + ", only " + Arrays.toString(taskOfModule));
        }
    }

    /** Whether the answer is made of all modules' answers. */
    boolean averages() {
        return arbitration.answer() != ModuleArbitration.Answer.CHOSEN_MODULE;
    }

    /** One value of the combined answer of the last step; modules of other tasks contribute nothing. */
    double average(NetworkState state, int neuron) {
        double sum = 0;
        for (int module = 0; module < preferences.length; module++) {
            if (preferences[module] != OTHER_TASK) {
                sum += preferences[module] * state.moduleOutput(module, neuron);
            }
        }
        return sum / preferences.length;
    }
}
