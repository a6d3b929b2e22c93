package mmneat.neat.variation;

import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.random.ResumableRandom;

/**
 * Adds a module whose policy and preference neurons are linked to all inputs.
 *
 * <p>Quirk: the innovation numbers of the new output neurons come from the counter of the pool. The innovation number
 * of every other output neuron follows from its position. The outputs of such a module can therefore have another order
 * than in the {@link mmneat.neat.Archetype}.
 *
 * <p>Source: docs/specification/networks.md, section 8.7.
 */
record FullModuleMutation(ActivationFunction activation) implements MutationOperator {

    @Override
    public String logName() {
        return "FullMM";
    }

    @Override
    public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        NewModule module = NewModule.begin(offspring, pool, random, activation);
        int newOutputs = offspring.policyNeuronsPerModule() + 1;
        for (int i = 0; i < newOutputs; i++) {
            appendOutput(offspring, pool, random);
        }
        module.finish();
        return true;
    }

    private void appendOutput(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        int inputs = offspring.inputs();
        double[] weights = new double[inputs];
        long[] innovations = new long[inputs];
        for (int input = 0; input < inputs; input++) {
            weights[input] = Draws.smallWeight(random);
            innovations[input] = pool.takeInnovation();
        }
        NodeGene output = new NodeGene(pool.takeInnovation(), NodeType.OUTPUT, activation);
        for (int input = 0; input < inputs; input++) {
            long source = offspring.nodes().get(input).innovation();
            offspring.links().add(new LinkGene(innovations[input], source, output.innovation(), weights[input], false));
        }
        offspring.appendOutput(output, pool);
    }
}
