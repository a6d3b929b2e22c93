package mmneat.neat.variation;

import java.util.HashSet;
import java.util.Set;
import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.random.ResumableRandom;

/**
 * MM(R): adds a module whose policy neurons have links from random inputs and hidden neurons, as many as a policy
 * neuron has at the start. A source that is drawn again adds no link but uses up an innovation number.
 *
 * <p>Source: Schrum and Miikkulainen 2012; docs/specification/networks.md, section 8.7.
 */
record RandomModuleMutation(InputSelection selection, ActivationFunction activation) implements MutationOperator {

    @Override
    public String logName() {
        return "MMR";
    }

    @Override
    public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        NewModule module = NewModule.begin(offspring, pool, random, activation);
        for (int i = 0; i < offspring.policyNeuronsPerModule(); i++) {
            appendPolicyNeuron(offspring, pool, random);
        }
        module.finishAnywhere();
        return true;
    }

    private void appendPolicyNeuron(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        long target = offspring.nextOutputInnovation(pool);
        Set<Long> linked = new HashSet<>();
        int count = selection.linksInto(offspring.inputs());
        for (int i = 0; i < count; i++) {
            long source = offspring
                    .nodes()
                    .get(random.nextInt(offspring.firstOutput()))
                    .innovation();
            long innovation = pool.takeInnovation();
            double weight = 2 * Draws.smallWeight(random);
            if (linked.add(source)) {
                offspring.links().add(new LinkGene(innovation, source, target, weight, false));
            }
        }
        offspring.appendOutput(new NodeGene(target, NodeType.OUTPUT, activation), pool);
    }
}
