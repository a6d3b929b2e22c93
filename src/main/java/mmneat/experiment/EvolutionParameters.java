package mmneat.experiment;

import java.util.OptionalInt;
import mmneat.evolution.EvolutionSettings;
import mmneat.evolution.Task;
import mmneat.neat.ActivationFunction;
import mmneat.neat.InitialNetworks;
import mmneat.neat.InputSelection;
import mmneat.neat.ModuleGate;
import mmneat.neat.ModuleLayout;
import mmneat.neat.MutationRates;
import mmneat.neat.VariationSettings;
import mmneat.nsga2.Crowding;
import mmneat.nsga2.Mating;

/** The parameters that decide an evolution besides its task; named as the parameters, see the catalogue. */
record EvolutionParameters(
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
        boolean fs,
        int fsLinksPerOut,
        int startingModes,
        int multitaskModes,
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
        double freezeAlternateRate) {

    EvolutionSettings settings(Task task) {
        InputSelection selection = new InputSelection(fs, fsLinksPerOut);
        ActivationFunction activation = ActivationFunction.ofCode(ftype);
        return new EvolutionSettings(
                randomSeed,
                initialPopulationSeed == -1 ? OptionalInt.empty() : OptionalInt.of(initialPopulationSeed),
                mu,
                maxGens,
                cleanFrequency,
                new InitialNetworks(task.inputs(), layout(task.policyNeuronsPerModule()), selection, activation),
                new Mating(mating, crossoverRate, crowdingOf(crowding)),
                new VariationSettings(
                        rates(),
                        new ModuleGate(maxModes, usageForNewMode),
                        crossExcessRate,
                        deleteLeastUsed,
                        selection,
                        activation));
    }

    private static Crowding crowdingOf(String crowding) {
        return crowding.equals("front") ? Crowding.PER_FRONT : Crowding.WHOLE_POPULATION;
    }

    /** Source: spec/networks.md, section 3.2. */
    private ModuleLayout layout(int policyNeurons) {
        boolean choosesModules = startingModes > 1 || rates().module().canAddModules();
        if (multitaskModes > 1) {
            if (choosesModules) {
                throw new UserError("multitaskModes=" + multitaskModes
                        + " does not go with startingModes above 1 or with module mutation: either the task chooses the"
                        + " module or the network does");
            }
            return ModuleLayout.multitask(multitaskModes, policyNeurons);
        }
        return choosesModules
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
