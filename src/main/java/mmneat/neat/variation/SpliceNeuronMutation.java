package mmneat.neat.variation;

import java.util.List;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Archetype;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.random.ResumableRandom;

/**
 * Splices a new hidden neuron into a random link. The link becomes inactive, and the two new links have small random
 * weights. So the network's behaviour changes at once.
 *
 * <p>Source: docs/specification/networks.md, sections 4.3 and 8.4.
 */
record SpliceNeuronMutation(ActivationFunction activation) implements MutationOperator {

    @Override
    public String logName() {
        return "SpliceNeuronMutation";
    }

    @Override
    public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        List<LinkGene> links = offspring.links();
        int chosen = Draws.changeableLink(links, random);
        if (chosen < 0) {
            return false;
        }
        LinkGene link = links.get(chosen);
        NodeGene neuron = new NodeGene(pool.takeInnovation(), NodeType.HIDDEN, activation);
        double weightIn = Draws.smallWeight(random);
        double weightOut = Draws.smallWeight(random);
        long innovationIn = pool.takeInnovation();
        long innovationOut = pool.takeInnovation();

        links.set(chosen, link.withActive(false));
        int position = insert(neuron, link.source(), offspring);
        insertIntoArchetype(neuron, link.source(), offspring, pool);
        boolean isInRecurrent = position <= offspring.indexOf(link.source());
        boolean isOutRecurrent = offspring.indexOf(link.target()) <= position;
        links.add(new LinkGene(innovationIn, link.source(), neuron.innovation(), weightIn, isInRecurrent));
        links.add(new LinkGene(innovationOut, neuron.innovation(), link.target(), weightOut, isOutRecurrent));
        return true;
    }

    /**
     * Inserts the neuron: directly after a hidden source, before all hidden neurons if the source is an input, after
     * them if it is an output.
     */
    private static int insert(NodeGene neuron, long source, GenotypeDraft offspring) {
        int position = Math.min(offspring.firstOutput(), Math.max(offspring.inputs(), offspring.indexOf(source) + 1));
        offspring.nodes().add(position, neuron);
        return position;
    }

    private static void insertIntoArchetype(NodeGene neuron, long source, GenotypeDraft offspring, GenePool pool) {
        Archetype archetype = pool.archetype();
        int position = archetype.insertSpliced(neuron, source, offspring.inputs());
        // The original prepares a crossover that never happens; this uses up an innovation number.
        if (offspring.modules() == 1 && archetype.needsShadow(position)) {
            archetype.insertShadow(position, pool.takeInnovation());
        }
    }
}
