package mmneat.neat.variation;

import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.random.ResumableRandom;

/**
 * MM(P): adds a module whose policy neurons each have one link, from the last module's policy neuron at the same
 * position.
 *
 * <p>Source: Schrum and Miikkulainen 2012; docs/specification/networks.md, section 8.7.
 */
record PreviousModuleMutation(ActivationFunction activation) implements MutationOperator {

    @Override
    public String logName() {
        return "MMP";
    }

    @Override
    public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        NewModule module = NewModule.begin(offspring, pool, random, activation);
        ModuleLayout layout = offspring.layout();
        int firstOutput = offspring.firstOutput();
        for (int i = 0; i < layout.policyNeuronsPerModule(); i++) {
            int previous = firstOutput + layout.policyOutput(layout.modules() - 1, i);
            long source = offspring.nodes().get(previous).innovation();
            long target = offspring.nextOutputInnovation(pool);
            long innovation = pool.takeInnovation();
            offspring.links().add(new LinkGene(innovation, source, target, 2 * Draws.smallWeight(random), false));
            offspring.appendOutput(new NodeGene(target, NodeType.OUTPUT, activation), pool);
        }
        module.finishLike(layout.modules() - 1);
        return true;
    }
}
