package mmneat.neat.variation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import mmneat.neat.GenePool;
import mmneat.neat.GenotypeDraft;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.random.ResumableRandom;

/**
 * Removes a module, its outputs and their links from a network of several modules that has preference neurons.
 *
 * <p>This mutation has no counterpart: the original ends with an error message when it should delete a module.
 * Innovations of outputs follow from their positions, so the modules behind the deleted one move forward and take over
 * innovations. The links of moved outputs get new numbers, because links with equal numbers must have equal end points.
 *
 * @param isLeastUsedChosen whether the least used module is removed ({@code deleteLeastUsed}; of several, the first),
 *     else a random one
 */
record DeleteModuleMutation(boolean isLeastUsedChosen) implements MutationOperator {

    @Override
    public String logName() {
        return "DeleteModeMutation";
    }

    @Override
    public boolean apply(GenotypeDraft offspring, GenePool pool, ResumableRandom random) {
        ModuleLayout layout = offspring.layout();
        if (layout.modules() == 1 || layout.standardMultitask()) {
            return false;
        }
        List<Integer> candidates = candidates(layout);
        if (candidates.isEmpty()) {
            return false;
        }
        int module = isLeastUsedChosen
                ? leastUsed(offspring, candidates)
                : candidates.get(random.nextInt(candidates.size()));
        Map<Long, NodeGene> movedOutputs = new HashMap<>();
        List<NodeGene> keptNodes = keptNodes(offspring, layout, module, movedOutputs);
        offspring.replaceGenes(keptNodes, keptLinks(offspring, movedOutputs, pool));
        offspring.setModuleUsage(without(offspring.moduleUsage(), module, layout.modules()));
        List<Integer> groups = new ArrayList<>(layout.groups());
        if (layout.isGrouped()) {
            groups.remove(module);
            offspring.setGroups(groups);
        }
        return true;
    }

    /** The modules that may go: in a hybrid each group keeps one. */
    private static List<Integer> candidates(ModuleLayout layout) {
        List<Integer> groups = layout.groups();
        return IntStream.range(0, layout.modules())
                .filter(module -> groups.isEmpty() || Collections.frequency(groups, groups.get(module)) > 1)
                .boxed()
                .toList();
    }

    private static int leastUsed(GenotypeDraft offspring, List<Integer> candidates) {
        int[] usage = offspring.moduleUsage();
        int least = candidates.get(0);
        for (int module : candidates) {
            if (module < usage.length && usage[module] < usage[least]) {
                least = module;
            }
        }
        return least;
    }

    /**
     * Returns the remaining nodes. Outputs after the removed module move forward; their new innovations are recorded by
     * the old.
     */
    private static List<NodeGene> keptNodes(
            GenotypeDraft offspring, ModuleLayout layout, int module, Map<Long, NodeGene> moved) {
        List<NodeGene> kept = new ArrayList<>(offspring.nodes().subList(0, offspring.firstOutput()));
        int position = 0;
        for (int output = 0; output < offspring.outputs(); output++) {
            NodeGene node = offspring.output(output);
            if (layout.moduleOf(output) != module) {
                long innovation = offspring.output(position++).innovation();
                NodeGene placed = innovation == node.innovation()
                        ? node
                        : new NodeGene(innovation, NodeType.OUTPUT, node.activation(), node.frozen(), false);
                moved.put(node.innovation(), placed);
                kept.add(placed);
            }
        }
        return kept;
    }

    private static List<LinkGene> keptLinks(GenotypeDraft offspring, Map<Long, NodeGene> moved, GenePool pool) {
        Map<Long, Long> newInnovation = new HashMap<>();
        for (NodeGene node : offspring.nodes().subList(0, offspring.firstOutput())) {
            newInnovation.put(node.innovation(), node.innovation());
        }
        moved.forEach((old, node) -> newInnovation.put(old, node.innovation()));
        List<LinkGene> kept = new ArrayList<>();
        for (LinkGene link : offspring.links()) {
            Long source = newInnovation.get(link.source());
            Long target = newInnovation.get(link.target());
            if (source != null && target != null) {
                boolean isMoved = source != link.source() || target != link.target();
                kept.add(isMoved ? link.moved(pool.takeInnovation(), source, target) : link);
            }
        }
        return kept;
    }

    private static int[] without(int[] usage, int module, int modules) {
        if (usage.length != modules) {
            return usage;
        }
        int[] rest = new int[modules - 1];
        System.arraycopy(usage, 0, rest, 0, module);
        System.arraycopy(usage, module + 1, rest, module, modules - 1 - module);
        return rest;
    }
}
