package mmneat.neat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * The division of a network's output neurons into modules.
 *
 * <p>Outputs are numbered from 0 in node order. Module m owns {@link #neuronsPerModule()} consecutive outputs: its
 * policy neurons and then, if there are preference neurons, its preference neuron.
 *
 * <p>Policy neurons form the output of the network, one value each. The activation of a preference neuron says how much
 * its module should be chosen; the module with the highest one answers. {@link mmneat.neat} names the methods of the
 * paper (1M, 2M, MMD, MT and others).
 *
 * <p>Source: docs/specification/networks.md, sections 3.1 and 3.2.
 *
 * @param outputs number of output neurons, preference neurons included
 * @param modules number of output modules
 * @param policyNeuronsPerModule number of neurons of a module that form the network's output
 * @param standardMultitask whether the task selects the module, so that there are no preference neurons
 * @param groups the group of each module in a hybrid network; empty for all other networks. In each step the task names
 *     a group by its number ({@code NetworkState.presetModule}), and preference neurons choose among its modules. Each
 *     group from 0 to the highest has a module
 */
public record ModuleLayout(
        int outputs, int modules, int policyNeuronsPerModule, boolean standardMultitask, List<Integer> groups) {

    /**
     * A checked layout.
     *
     * @throws IllegalArgumentException if a number is not positive, or the number of outputs does not fit the modules
     */
    public ModuleLayout {
        if (policyNeuronsPerModule < 1) {
            throw new IllegalArgumentException(
                    "policyNeuronsPerModule must be at least 1, is " + policyNeuronsPerModule);
        }
        if (modules < 1) {
            throw new IllegalArgumentException("modules must be at least 1, is " + modules);
        }
        long policyNeurons = (long) modules * policyNeuronsPerModule;
        boolean withoutPreference = outputs == policyNeurons && (standardMultitask || modules == 1);
        boolean withPreference = outputs == policyNeurons + modules && !standardMultitask;
        if (!withoutPreference && !withPreference) {
            throw new IllegalArgumentException("outputs: " + outputs + " cannot be " + modules + " modules of "
                    + policyNeuronsPerModule + " policy neurons "
                    + (standardMultitask ? "in a multitask network" : "and a preference neuron each"));
        }
        groups = List.copyOf(groups);
        if (!groups.isEmpty()) {
            requireGroups(groups, modules, withPreference);
        }
    }

    /** A layout without groups. */
    public ModuleLayout(int outputs, int modules, int policyNeuronsPerModule, boolean standardMultitask) {
        this(outputs, modules, policyNeuronsPerModule, standardMultitask, List.of());
    }

    private static void requireGroups(List<Integer> groups, int modules, boolean withPreference) {
        if (groups.size() != modules || !withPreference) {
            throw new IllegalArgumentException("groups: must name a group for each of " + modules
                    + " modules with preference neurons, name " + groups.size());
        }
        int highest = groups.stream().mapToInt(group -> group).max().orElseThrow();
        for (int group : groups) {
            if (group < 0) {
                throw new IllegalArgumentException("groups: must not be negative, are " + groups);
            }
        }
        if (groups.stream().distinct().count() != highest + 1L) {
            throw new IllegalArgumentException(
                    "groups: each from 0 to " + highest + " must have a module, are " + groups);
        }
    }

    /**
     * One module without preference neuron, which always answers: method 1M of the paper.
     *
     * @throws IllegalArgumentException if there is no policy neuron
     */
    public static ModuleLayout single(int policyNeurons) {
        return new ModuleLayout(policyNeurons, 1, policyNeurons, false);
    }

    /**
     * Modules chosen by preference neurons: methods 2M (two modules), 3M (three) and, with one module at the start,
     * MMD.
     *
     * @throws IllegalArgumentException if there is no module or no policy neuron
     */
    public static ModuleLayout withPreferenceNeurons(int modules, int policyNeuronsPerModule) {
        return new ModuleLayout(modules * (policyNeuronsPerModule + 1), modules, policyNeuronsPerModule, false);
    }

    /**
     * Modules chosen by the task: methods MT, MT2 and MT3.
     *
     * @throws IllegalArgumentException if there is no module or no policy neuron
     */
    public static ModuleLayout multitask(int modules, int policyNeuronsPerModule) {
        return new ModuleLayout(modules * policyNeuronsPerModule, modules, policyNeuronsPerModule, true);
    }

    /**
     * Groups of modules: the task chooses the group, and preference neurons choose a module of the group. Methods of
     * this kind are called hybrids.
     *
     * @param sizes number of modules of each group
     * @throws IllegalArgumentException if there is no group, an empty one, or no policy neuron
     */
    public static ModuleLayout grouped(int policyNeuronsPerModule, int... sizes) {
        List<Integer> groups = new ArrayList<>();
        for (int group = 0; group < sizes.length; group++) {
            for (int i = 0; i < sizes[group]; i++) {
                groups.add(group);
            }
        }
        int modules = groups.size();
        return new ModuleLayout(modules * (policyNeuronsPerModule + 1), modules, policyNeuronsPerModule, false, groups);
    }

    /** Whether the task names a group of modules. */
    public boolean isGrouped() {
        return !groups.isEmpty();
    }

    /** Number of modules of each group; empty if there are no groups. */
    public List<Integer> sizesOfGroups() {
        return groups.stream()
                .distinct()
                .sorted()
                .map(group -> Collections.frequency(groups, group))
                .toList();
    }

    /** Number of modules or groups among which the task chooses; 1 if it does not choose. */
    public int choicesOfTask() {
        if (isGrouped()) {
            return groups.stream().mapToInt(group -> group).max().orElseThrow() + 1;
        }
        return standardMultitask ? modules : 1;
    }

    /**
     * Returns the number that the task must choose so that a module can answer: the number of the module's group in a
     * hybrid, the number of the module in a multitask network.
     *
     * @throws IllegalArgumentException if there is no such module, or the task names none
     */
    public int choiceOf(int module) {
        requireIndex("module", module, modules);
        if (!isGrouped() && !standardMultitask) {
            throw new IllegalArgumentException("the task does not choose this network's modules");
        }
        return isGrouped() ? groups.get(module) : module;
    }

    /** Whether the task names modules or groups of them in each time step. */
    public boolean isDivided() {
        return standardMultitask || isGrouped();
    }

    /** Whether each module has a preference neuron after its policy neurons. */
    public boolean hasPreferenceNeurons() {
        return outputs > modules * policyNeuronsPerModule;
    }

    /** Outputs that belong to one module. */
    public int neuronsPerModule() {
        return policyNeuronsPerModule + (hasPreferenceNeurons() ? 1 : 0);
    }

    /**
     * Output number of a module's policy neuron.
     *
     * @throws IllegalArgumentException if there is no such module, or it has no such policy neuron
     */
    public int policyOutput(int module, int neuron) {
        requireIndex("module", module, modules);
        requireIndex("policy neuron", neuron, policyNeuronsPerModule);
        return module * neuronsPerModule() + neuron;
    }

    /**
     * Output number of a module's preference neuron.
     *
     * @throws IllegalArgumentException if there is no such module, or modules have no preference neurons
     */
    public int preferenceOutput(int module) {
        requireIndex("module", module, modules);
        if (!hasPreferenceNeurons()) {
            throw new IllegalArgumentException("the network has no preference neurons");
        }
        return module * neuronsPerModule() + policyNeuronsPerModule;
    }

    /**
     * Module that an output belongs to.
     *
     * @throws IllegalArgumentException if there is no such output
     */
    public int moduleOf(int output) {
        requireIndex("output", output, outputs);
        return output / neuronsPerModule();
    }

    /**
     * Whether an output is a preference neuron.
     *
     * @throws IllegalArgumentException if there is no such output
     */
    public boolean isPreference(int output) {
        requireIndex("output", output, outputs);
        return hasPreferenceNeurons() && output % neuronsPerModule() == policyNeuronsPerModule;
    }

    private static void requireIndex(String name, int index, int count) {
        if (index < 0 || index >= count) {
            throw new IllegalArgumentException(name + " must be 0 to " + (count - 1) + ", is " + index);
        }
    }
}
