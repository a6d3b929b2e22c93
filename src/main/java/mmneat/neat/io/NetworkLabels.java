package mmneat.neat.io;

import java.util.List;
import java.util.Objects;

/**
 * The names of a network's inputs and modules in drawings. They come from the task; a genotype does not contain them.
 *
 * @param inputs names of the inputs, one for each; if empty, inputs are numbered
 * @param modules names of the output modules, one for each; if empty, modules are numbered from 1
 */
public record NetworkLabels(List<String> inputs, List<String> modules) {

    /** Labels without names: everything is numbered. */
    public static final NetworkLabels NUMBERS = new NetworkLabels(List.of(), List.of());

    /**
     * Labels with copies of the lists.
     *
     * @throws NullPointerException if a part is missing; the message names it
     */
    public NetworkLabels {
        inputs = List.copyOf(Objects.requireNonNull(inputs, "inputs"));
        modules = List.copyOf(Objects.requireNonNull(modules, "modules"));
    }

    String input(int input) {
        return inputs.isEmpty() ? "input " + input : inputs.get(input);
    }

    String module(int module) {
        return modules.isEmpty() ? "module " + (module + 1) : modules.get(module);
    }

    /** Checks that the names fit a network. */
    void requireFor(int inputCount, int moduleCount) {
        if (!inputs.isEmpty() && inputs.size() != inputCount) {
            throw new IllegalArgumentException(inputs.size() + " labels for " + inputCount + " inputs");
        }
        if (!modules.isEmpty() && modules.size() != moduleCount) {
            throw new IllegalArgumentException(modules.size() + " labels for " + moduleCount + " modules");
        }
    }
}
