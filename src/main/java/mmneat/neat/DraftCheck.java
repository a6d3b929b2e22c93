package mmneat.neat;

import java.util.List;
import java.util.function.Supplier;

/**
 * The check of what an operator of the user's own leaves behind: a draft that is a network of the pool, and that a
 * checkpoint can hold.
 *
 * @param operator the operator, for messages
 * @param activation the only activation function of the user's own that neurons may have, if it is one
 */
public record DraftCheck(OwnPart operator, ActivationFunction activation) {

    /**
     * Calls the operator and checks the drafts.
     *
     * @param method the call of the operator, which changes the drafts
     * @param pool the pool that the genes of the drafts must come from
     * @return what the call returns
     * @throws BadPartException if the operator throws, or a draft is invalid afterwards
     */
    public <T> T call(Supplier<T> method, GenePool pool, GenotypeDraft... drafts) {
        int[] choices = new int[drafts.length];
        for (int i = 0; i < drafts.length; i++) {
            choices[i] = choicesOfTask(drafts[i].layout());
        }
        T result = operator.call(method);
        for (int i = 0; i < drafts.length; i++) {
            try {
                requireGenes(drafts[i]);
                require(drafts[i].checked(), choices[i], pool);
            } catch (IllegalArgumentException e) {
                throw operator.bad("made an invalid network: " + e.getMessage());
            }
        }
        return result;
    }

    private static int choicesOfTask(ModuleLayout layout) {
        return layout.isDivided() ? layout.choicesOfTask() : 0;
    }

    private static void requireGenes(GenotypeDraft draft) {
        if (draft.nodes().contains(null)) {
            throw new IllegalArgumentException("contains a null node");
        }
        if (draft.links().contains(null)) {
            throw new IllegalArgumentException("contains a null link");
        }
        if (draft.moduleUsage() == null) {
            throw new IllegalArgumentException("moduleUsage is null");
        }
    }

    private void require(Genotype network, int choices, GenePool pool) {
        if (choicesOfTask(network.layout()) != choices) {
            throw new IllegalArgumentException("the task chooses among " + choices + " modules or groups, it has "
                    + choicesOfTask(network.layout()));
        }
        if (network.moduleUsage().length > network.modules()) {
            throw new IllegalArgumentException("moduleUsage: has " + network.moduleUsage().length
                    + " numbers, more than the " + network.modules() + " modules");
        }
        network.ownFunctionOtherThan(activation).ifPresent(other -> {
            throw new IllegalArgumentException("a neuron has the activation function " + other
                    + "; it must be built in or that of the evolution, " + activation);
        });
        pool.state().requireOwn(List.of(network));
    }
}
