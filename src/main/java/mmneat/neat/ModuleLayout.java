package mmneat.neat;

/**
 * How the output neurons of a network are divided into modules.
 *
 * <p>Outputs are numbered from 0 in node order. Module m owns {@link #neuronsPerModule()} consecutive outputs: its policy
 * neurons and then, if there are preference neurons, its preference neuron.
 *
 * <p>Source: spec/networks.md, sections 3.1 and 3.2.
 *
 * @param outputs number of output neurons, preference neurons included
 * @param modules number of output modules
 * @param policyNeuronsPerModule neurons of a module that make up the network's answer
 * @param standardMultitask whether the task names the module to be used, so that there are no preference neurons
 */
public record ModuleLayout(int outputs, int modules, int policyNeuronsPerModule, boolean standardMultitask) {

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
    }

    /** One module without preference neuron: method 1M. */
    public static ModuleLayout single(int policyNeurons) {
        return new ModuleLayout(policyNeurons, 1, policyNeurons, false);
    }

    /** Modules that compete by preference neurons: methods 2M, 3M and, with one module at the start, MMD. */
    public static ModuleLayout withPreferenceNeurons(int modules, int policyNeuronsPerModule) {
        return new ModuleLayout(modules * (policyNeuronsPerModule + 1), modules, policyNeuronsPerModule, false);
    }

    /** Modules that the task chooses from: methods MT, MT2 and MT3. */
    public static ModuleLayout multitask(int modules, int policyNeuronsPerModule) {
        return new ModuleLayout(modules * policyNeuronsPerModule, modules, policyNeuronsPerModule, true);
    }

    /** Whether each module has a preference neuron behind its policy neurons. */
    public boolean hasPreferenceNeurons() {
        return outputs > modules * policyNeuronsPerModule;
    }

    /** Outputs that belong to one module. */
    public int neuronsPerModule() {
        return policyNeuronsPerModule + (hasPreferenceNeurons() ? 1 : 0);
    }

    /** Output number of a module's policy neuron. */
    public int policyOutput(int module, int neuron) {
        return module * neuronsPerModule() + neuron;
    }

    /** Output number of a module's preference neuron; only if there are preference neurons. */
    public int preferenceOutput(int module) {
        return module * neuronsPerModule() + policyNeuronsPerModule;
    }

    /** Module that an output belongs to. */
    public int moduleOf(int output) {
        return output / neuronsPerModule();
    }

    /** Whether an output is a preference neuron. */
    public boolean isPreference(int output) {
        return hasPreferenceNeurons() && output % neuronsPerModule() == policyNeuronsPerModule;
    }
}
