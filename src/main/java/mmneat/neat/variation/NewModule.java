package mmneat.neat.variation;

import java.util.List;
import mmneat.neat.ActivationFunction;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.random.ResumableRandom;

/**
 * A module that is being added to an offspring. The mutation appends its policy neurons; this class appends its
 * preference neuron.
 *
 * <p>Source: docs/specification/networks.md, section 8.5, steps 1, 4 and 5.
 */
final class NewModule {

    private final GenotypeDraft offspring;
    private final GenePool pool;
    private final ResumableRandom random;
    private final ActivationFunction activation;

    private NewModule(GenotypeDraft offspring, GenePool pool, ResumableRandom random, ActivationFunction activation) {
        this.offspring = offspring;
        this.pool = pool;
        this.random = random;
        this.activation = activation;
    }

    /**
     * Starts a module. A network of one module first gets the preference neuron that it lacks.
     *
     * @throws IllegalStateException if the network is a multitask network, whose task would never use the new module
     */
    static NewModule begin(
            GenotypeDraft offspring, GenePool pool, ResumableRandom random, ActivationFunction activation) {
        ModuleLayout layout = offspring.layout();
        if (layout.standardMultitask()) {
            throw new IllegalStateException("genotype " + offspring.id()
                    + ": module mutations need preference neurons, which multitask networks do not have");
        }
        NewModule module = new NewModule(offspring, pool, random, activation);
        if (!layout.hasPreferenceNeurons()) {
            module.appendPreferenceNeuron();
        }
        return module;
    }

    /**
     * Ends the module with a preference neuron that has one link, from a random input or hidden neuron.
     *
     * @param model the module that it is like: in a hybrid its group is that of the model
     */
    void finishLike(int model) {
        appendPreferenceNeuron();
        offspring.addModuleTo(
                offspring.groups().isEmpty() ? 0 : offspring.groups().get(model));
    }

    /** The same for a module that has no model: in a hybrid its group is that of a random module. */
    void finishAnywhere() {
        appendPreferenceNeuron();
        finish();
    }

    /** Ends a module all of whose outputs have been appended; in a hybrid its group is that of a random module. */
    void finish() {
        List<Integer> groups = offspring.groups();
        offspring.addModuleTo(groups.isEmpty() ? 0 : groups.get(random.nextInt(groups.size())));
    }

    private void appendPreferenceNeuron() {
        long source =
                offspring.nodes().get(random.nextInt(offspring.firstOutput())).innovation();
        long target = offspring.nextOutputInnovation(pool);
        long innovation = pool.takeInnovation();
        offspring.links().add(new LinkGene(innovation, source, target, Draws.smallWeight(random), false));
        offspring.appendOutput(new NodeGene(target, NodeType.OUTPUT, activation), pool);
    }
}
