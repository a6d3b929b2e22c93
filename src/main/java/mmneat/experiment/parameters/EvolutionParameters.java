package mmneat.experiment.parameters;

import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import mmneat.evolution.EvolutionSettings;
import mmneat.evolution.Task;
import mmneat.evolution.Tug;
import mmneat.experiment.UserError;
import mmneat.neat.ActivationFunction;
import mmneat.neat.ModuleLayout;
import mmneat.neat.variation.CrossoverOperator;
import mmneat.neat.variation.InitialNetworks;
import mmneat.neat.variation.InputSelection;
import mmneat.neat.variation.ModuleGate;
import mmneat.neat.variation.MutationOperator;
import mmneat.neat.variation.MutationRates;
import mmneat.neat.variation.VariationSettings;
import mmneat.nsga2.Crowding;
import mmneat.nsga2.ParentSelection;
import mmneat.nsga2.Selection;

/**
 * The parameters that the evolution reads: seeds, population, network structure, mutation, crossover, selection. Each
 * component has the name of a parameter; the catalogue ({@code parameters.csv}, {@link ParameterCatalogue}) describes
 * it.
 *
 * <p>Three components are also read by the task and so are components of {@link GameParameters}, too: {@code
 * multitaskModes} is here the number of modules of the first networks and there the number of modules of the division;
 * {@code disabledMode} is only checked here; {@code jar} is where both load the user's own classes from.
 */
public record EvolutionParameters(
        int randomSeed,
        int initialPopulationSeed,
        int mu,
        int maxGens,
        int cleanFrequency,
        boolean mating,
        double crossoverRate,
        String crowding,
        double crossExcessRate,
        int ftype,
        String activation,
        boolean fs,
        int fsLinksPerOut,
        int startingModes,
        int multitaskModes,
        String moduleGroups,
        int maxModes,
        double usageForNewMode,
        boolean deleteLeastUsed,
        double netLinkRate,
        double netSpliceRate,
        double perLinkMutateRate,
        double netPerturbRate,
        double mmpRate,
        double mmrRate,
        double mmdRate,
        double fullMMRate,
        double deleteLinkRate,
        double deleteModeRate,
        double freezePolicyRate,
        double freezePreferenceRate,
        double freezeAlternateRate,
        int disabledMode,
        String mutations,
        String crossover,
        String selection,
        String jar) {

    /** NEAT's crossover, the only value of {@code crossover} that is not a class of the user's own. */
    private static final String NEAT_CROSSOVER = "TWEANNCrossover";

    private static final Pattern OWN_MUTATION = Pattern.compile("(.+):([^:]+)");

    /**
     * Returns the settings of an evolution that parameters give for a task.
     *
     * @throws UserError if the parameters do not fit the task
     */
    public static EvolutionSettings settings(Parameters parameters, Task task) {
        return parameters
                .as(EvolutionParameters.class)
                .settings(task, parameters.as(TugParameters.class).tug(task));
    }

    private EvolutionSettings settings(Task task, Optional<Tug> tug) {
        if (fs && fsLinksPerOut > task.inputs()) {
            throw new UserError("fsLinksPerOut=" + fsLinksPerOut + ": the networks have " + task.inputs()
                    + " inputs; give at most as many");
        }
        InputSelection inputs = new InputSelection(fs, fsLinksPerOut);
        if (tug.isPresent() && !selection.isBlank()) {
            throw new UserError(
                    "selection=" + selection + " cannot be combined with ea=TUGNSGA2; leave one of them out");
        }
        OwnClasses classes = new OwnClasses(jar);
        ActivationFunction function = function(classes);
        EvolutionSettings settings = new EvolutionSettings(
                randomSeed,
                initialPopulationSeed == -1 ? OptionalInt.empty() : OptionalInt.of(initialPopulationSeed),
                mu,
                maxGens,
                cleanFrequency,
                new InitialNetworks(task.inputs(), layout(task.policyNeuronsPerModule()), inputs, function),
                new ParentSelection(mating, crossoverRate, crowdingOf(crowding)),
                variation(inputs, function, classes),
                tug,
                Optional.empty());
        return selection.isBlank()
                ? settings
                : settings.withSelection(classes.make("selection", selection.strip(), Selection.class));
    }

    private ActivationFunction function(OwnClasses classes) {
        return activation.isBlank()
                ? ActivationFunction.ofCode(ftype)
                : OwnActivation.load(activation.strip(), classes);
    }

    private VariationSettings variation(InputSelection inputs, ActivationFunction function, OwnClasses classes) {
        VariationSettings variation = new VariationSettings(
                rates(), new ModuleGate(maxModes, usageForNewMode), crossExcessRate, deleteLeastUsed, inputs, function);
        for (String mutation : OwnClasses.names("mutations", mutations)) {
            variation = withOwnMutation(variation, mutation, classes);
        }
        return crossover.equals(NEAT_CROSSOVER)
                ? variation
                : variation.withCrossover(classes.make("crossover", crossover, CrossoverOperator.class));
    }

    private static VariationSettings withOwnMutation(VariationSettings variation, String mutation, OwnClasses classes) {
        Matcher parts = OWN_MUTATION.matcher(mutation);
        double rate = -1;
        try {
            rate = parts.matches() ? Double.parseDouble(parts.group(2)) : -1;
        } catch (NumberFormatException e) {
            // The rate stays -1, which is refused below.
        }
        if (!(rate >= 0 && rate <= 1)) {
            throw new UserError("mutations=" + mutation
                    + ": must be the name of a class and its rate from 0 to 1, such as my.Operator:0.1");
        }
        MutationOperator operator = classes.make("mutations", parts.group(1), MutationOperator.class);
        String name = OwnClasses.ask("mutations=" + mutation + ": logName()", operator::logName);
        if (!name.matches("\\S+")) {
            throw new UserError("mutations=" + mutation + ": logName() must be one word, is '" + name + "'");
        }
        return variation.withMutation(rate, operator);
    }

    private static Crowding crowdingOf(String crowding) {
        return crowding.equals("front") ? Crowding.PER_FRONT : Crowding.WHOLE_POPULATION;
    }

    /**
     * Checks that the parameters are consistent.
     *
     * @throws UserError naming those that are not
     */
    void requireConsistent() {
        if (!activation.isBlank() && ftype != ActivationFunction.TANH.code()) {
            throw new UserError(
                    "activation=" + activation + " cannot be combined with ftype=" + ftype + "; leave one of them out");
        }
        if (!moduleGroups.isEmpty()) {
            requireGroups();
        } else if (multitaskModes > 1 && choosesModules()) {
            throw new UserError(chooser() + " cannot be combined with multitaskModes=" + multitaskModes
                    + ": either the task or the network chooses the module; leave one of them out");
        }
        int modules = Math.max(startingModes, moduleGroups.isEmpty() ? multitaskModes : sumOfGroups());
        if (disabledMode >= modules && !rates().module().canAddModules()) {
            throw new UserError("disabledMode=" + disabledMode + ": the networks have "
                    + (modules == 1 ? "one module, number 0" : "modules 0 to " + (modules - 1)) + "; -1 disables none");
        }
    }

    private void requireGroups() {
        int groups = HybridMethod.sizes(moduleGroups).size();
        if (groups != multitaskModes) {
            throw new UserError("moduleGroups=" + moduleGroups + ": names " + groups
                    + " groups, but the division chooses among multitaskModes=" + multitaskModes
                    + "; the two must be equal");
        }
        if (startingModes > 1) {
            throw new UserError("moduleGroups=" + moduleGroups + " cannot be combined with startingModes="
                    + startingModes + ": it sets the number of modules itself; leave out startingModes");
        }
    }

    private int sumOfGroups() {
        return HybridMethod.sizes(moduleGroups).stream().mapToInt(size -> size).sum();
    }

    /** Whether networks choose their modules by preference neurons. */
    private boolean choosesModules() {
        return startingModes > 1 || rates().module().canAddModules();
    }

    /** Returns the parameter that causes this. */
    private String chooser() {
        if (startingModes > 1) {
            return "startingModes=" + startingModes;
        }
        return Stream.of(
                        Map.entry("mmdRate", mmdRate),
                        Map.entry("mmpRate", mmpRate),
                        Map.entry("mmrRate", mmrRate),
                        Map.entry("fullMMRate", fullMMRate))
                .filter(rate -> rate.getValue() > 0)
                .map(rate -> rate.getKey() + "=" + rate.getValue())
                .findFirst()
                .orElseThrow();
    }

    /** Source: docs/specification/networks.md, section 3.2. */
    private ModuleLayout layout(int policyNeurons) {
        if (!moduleGroups.isEmpty() && (sumOfGroups() > multitaskModes || choosesModules())) {
            int[] sizes = HybridMethod.sizes(moduleGroups).stream()
                    .mapToInt(size -> size)
                    .toArray();
            return ModuleLayout.grouped(policyNeurons, sizes);
        }
        // One module in each group needs no preference neurons: a multitask network.
        if (multitaskModes > 1) {
            return ModuleLayout.multitask(multitaskModes, policyNeurons);
        }
        return choosesModules()
                ? ModuleLayout.withPreferenceNeurons(startingModes, policyNeurons)
                : ModuleLayout.single(policyNeurons);
    }

    private MutationRates rates() {
        return new MutationRates(
                netLinkRate,
                netSpliceRate,
                perLinkMutateRate,
                netPerturbRate,
                new MutationRates.ModuleRates(mmpRate, mmrRate, mmdRate, fullMMRate),
                new MutationRates.DeletionRates(deleteLinkRate, deleteModeRate),
                new MutationRates.FreezingRates(freezePolicyRate, freezePreferenceRate, freezeAlternateRate));
    }
}
