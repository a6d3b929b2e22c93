package mmneat.neat.variation;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.random.ResumableRandom;

/**
 * MM(D): adds a module that copies the incoming links of a random module's policy neurons. The new module has its own
 * preference neuron. Both modules give the same outputs until one is mutated, with the exception of the following
 * quirk.
 *
 * <p>Quirk: the new neurons come last in node order. A link from an output behind the old policy neuron, such as its
 * own preference neuron, is recurrent for the old neuron but a forward link for the new one. Then the outputs differ
 * from the start.
 *
 * <p>Source: Schrum and Miikkulainen 2016, section 3.2; docs/specification/networks.md, section 8.5.
 */
record ModuleDuplication(ActivationFunction activation) implements MutationOperator {

    @Override
    public String logName() {
        return "MMD";
    }

    @Override
    public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        NewModule module = NewModule.begin(offspring, pool, random, activation);
        ModuleLayout layout = offspring.layout();
        int original = random.nextInt(offspring.modules());
        long[] policyNeurons = new long[layout.policyNeuronsPerModule()];
        for (int i = 0; i < policyNeurons.length; i++) {
            policyNeurons[i] =
                    offspring.output(layout.policyOutput(original, i)).innovation();
        }
        for (long policyNeuron : policyNeurons) {
            duplicate(policyNeuron, offspring, pool);
        }
        module.finishLike(original);
        return true;
    }

    private void duplicate(long original, GenotypeDraft offspring, GenePool pool) {
        Map<Long, LinkGene> incoming = new HashMap<>();
        for (LinkGene link : offspring.links()) {
            if (link.active() && link.target() == original) {
                incoming.put(link.source(), link);
            }
        }
        NodeGene copy = new NodeGene(offspring.nextOutputInnovation(pool), NodeType.OUTPUT, activation);
        List<LinkGene> links = offspring.links();
        for (NodeGene node : offspring.nodes()) {
            LinkGene link = incoming.get(node.innovation());
            if (link != null) {
                long source = link.source() == original ? copy.innovation() : link.source();
                links.add(new LinkGene(pool.takeInnovation(), source, copy.innovation(), link.weight(), false));
            }
        }
        offspring.appendOutput(copy, pool);
    }
}
