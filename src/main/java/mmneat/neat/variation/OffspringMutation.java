package mmneat.neat.variation;

import java.util.ArrayList;
import java.util.List;
import mmneat.neat.ActivationFunction;
import mmneat.neat.DraftCheck;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.OwnPart;
import mmneat.random.ResumableRandom;

/**
 * The complete mutation of one offspring: it applies every operator in order, each with its probability.
 *
 * <p>An operator whose rate is 0 still takes one random draw. Source: docs/specification/networks.md, section 8.1.
 */
final class OffspringMutation {

    private record Chance(double rate, MutationOperator operator) {}

    private final ModuleGate gate;
    private final List<Chance> beforeModules;
    private final List<Chance> moduleMutations;
    private final List<Chance> afterModules;

    OffspringMutation(VariationSettings settings) {
        MutationRates rates = settings.rates();
        ActivationFunction activation = settings.activation();
        gate = settings.gate();
        beforeModules = List.of(
                new Chance(rates.freezing().policy(), new FreezeMutation(FreezeMutation.Part.POLICY)),
                new Chance(rates.freezing().preference(), new FreezeMutation(FreezeMutation.Part.PREFERENCE)),
                new Chance(rates.freezing().alternate(), new FreezeMutation(FreezeMutation.Part.ALTERNATE)),
                new Chance(rates.deletion().link(), new DeleteLinkMutation()),
                new Chance(rates.deletion().module(), new DeleteModuleMutation(settings.isLeastUsedModuleDeleted())));
        moduleMutations = moduleMutations(settings);
        List<Chance> others = new ArrayList<>();
        others.add(new Chance(rates.spliceNeuron(), new SpliceNeuronMutation(activation)));
        others.add(new Chance(rates.newLink(), new NewLinkMutation()));
        others.add(
                rates.perLinkWeight() > 0
                        ? new Chance(1, new AllWeightMutation(rates.perLinkWeight()))
                        : new Chance(rates.oneWeight(), new OneWeightMutation()));
        settings.ownMutations().forEach(own -> others.add(new Chance(own.rate(), checked(own.operator(), activation))));
        afterModules = List.copyOf(others);
    }

    private static MutationOperator checked(MutationOperator operator, ActivationFunction activation) {
        return new CheckedMutation(operator, new DraftCheck(OwnPart.of("mutation", operator), activation));
    }

    /** An operator of the user's own. */
    private record CheckedMutation(MutationOperator operator, DraftCheck check) implements MutationOperator {

        @Override
        public String logName() {
            String name = check.operator().call(operator::logName);
            if (name == null) {
                throw check.operator().bad("logName gave null");
            }
            return name;
        }

        @Override
        public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
            return check.call(() -> operator.apply(offspring, pool, random), pool, offspring);
        }
    }

    private static List<Chance> moduleMutations(VariationSettings settings) {
        MutationRates.ModuleRates rates = settings.rates().module();
        ActivationFunction activation = settings.activation();
        List<Chance> mutations = new ArrayList<>();
        mutations.add(new Chance(rates.previous(), new PreviousModuleMutation(activation)));
        mutations.add(new Chance(rates.random(), new RandomModuleMutation(settings.selection(), activation)));
        mutations.add(new Chance(rates.duplication(), new ModuleDuplication(activation)));
        // A feature selective start never adds fully connected modules, and draws no number for them.
        if (!settings.selection().isSelective()) {
            mutations.add(new Chance(rates.full(), new FullModuleMutation(activation)));
        }
        return List.copyOf(mutations);
    }

    /** Mutates an offspring; returns the log names of what was performed, in order. */
    List<String> apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        List<String> performed = new ArrayList<>(4);
        tryEach(beforeModules, offspring, pool, random, performed);
        if (gate.isOpen(offspring.modules(), offspring.moduleUsage())) {
            tryEach(moduleMutations, offspring, pool, random, performed);
        }
        tryEach(afterModules, offspring, pool, random, performed);
        return List.copyOf(performed);
    }

    private static void tryEach(
            List<Chance> chances,
            GenotypeDraft offspring,
            GenePool pool,
            ResumableRandom random,
            List<String> performed) {
        for (Chance chance : chances) {
            if (random.nextDouble() < chance.rate() && chance.operator().apply(offspring, pool, random)) {
                performed.add(chance.operator().logName());
            }
        }
    }
}
