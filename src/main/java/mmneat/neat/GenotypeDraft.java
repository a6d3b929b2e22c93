package mmneat.neat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A mutable genotype. Reproduction copies a parent ({@link #copyOf}), mutation operators change the copy, and {@link
 * #finish} returns the offspring.
 *
 * <p>Node order, link order and counts are those of {@link Genotype}; during a module mutation the outputs may be
 * incomplete modules.
 */
public final class GenotypeDraft {

    private long id;
    private final int inputs;
    private final ModuleLayout originalLayout;
    private final List<NodeGene> nodes;
    private final List<LinkGene> links;
    private final List<Integer> groups;
    private int[] moduleUsage;
    private int outputs;
    private int modules;

    private GenotypeDraft(Genotype original, long id, List<LinkGene> links) {
        this.id = id;
        this.inputs = original.inputs();
        this.originalLayout = original.layout();
        this.groups = new ArrayList<>(original.layout().groups());
        this.nodes = new ArrayList<>(original.nodes());
        this.links = links;
        this.moduleUsage = original.moduleUsage();
        this.outputs = original.outputs();
        this.modules = original.modules();
    }

    /** Creates a draft with all genes of a genotype. */
    public static GenotypeDraft of(Genotype original) {
        return new GenotypeDraft(original, original.id(), new ArrayList<>(original.links()));
    }

    /**
     * Copies a genotype as the original does, by building a network and reading it back: inactive links disappear, and
     * links are grouped by source in node order. Source: docs/specification/networks.md, section 7.
     */
    public static GenotypeDraft copyOf(Genotype original, long id) {
        return new GenotypeDraft(
                original,
                id,
                activeLinksBySource(original.positions(), original.nodes().size(), original.links()));
    }

    /** The active links, grouped by source in node order, links of one source in their previous order. */
    public static List<LinkGene> activeLinksBySource(List<NodeGene> nodes, List<LinkGene> links) {
        return activeLinksBySource(new NodePositions(nodes), nodes.size(), links);
    }

    private static List<LinkGene> activeLinksBySource(NodePositions positions, int nodes, List<LinkGene> links) {
        int[] sourcePosition = new int[links.size()];
        int[] groupEnd = new int[nodes + 1];
        int active = 0;
        for (int i = 0; i < links.size(); i++) {
            if (links.get(i).active()) {
                sourcePosition[i] = positions.of(links.get(i).source());
                groupEnd[sourcePosition[i] + 1]++;
                active++;
            }
        }
        for (int node = 1; node < groupEnd.length; node++) {
            groupEnd[node] += groupEnd[node - 1];
        }
        LinkGene[] grouped = new LinkGene[active];
        for (int i = 0; i < links.size(); i++) {
            if (links.get(i).active()) {
                grouped[groupEnd[sourcePosition[i]]++] = links.get(i);
            }
        }
        return new ArrayList<>(Arrays.asList(grouped));
    }

    /**
     * The finished genotype. Its genes are checked only if assertions are enabled: the operators that change drafts
     * keep them valid, and the checks would take a third of the time of reproduction.
     */
    public Genotype finish() {
        return Genotype.unchecked(id, inputs, layout(), nodes, links, moduleUsage);
    }

    /**
     * The finished genotype, its genes checked: for operators that may leave the draft invalid.
     *
     * @throws IllegalArgumentException if the genes do not form a network; the message says where
     * @throws NullPointerException if a gene is missing
     */
    Genotype checked() {
        return new Genotype(id, inputs, layout(), nodes, links, moduleUsage);
    }

    public long id() {
        return id;
    }

    public int inputs() {
        return inputs;
    }

    public int outputs() {
        return outputs;
    }

    public int modules() {
        return modules;
    }

    public int policyNeuronsPerModule() {
        return originalLayout.policyNeuronsPerModule();
    }

    /** Current division of the outputs into modules. Not available during a module mutation. */
    public ModuleLayout layout() {
        boolean isUnchanged = outputs == originalLayout.outputs()
                && modules == originalLayout.modules()
                && groups.equals(originalLayout.groups());
        return isUnchanged
                ? originalLayout
                : new ModuleLayout(
                        outputs, modules, policyNeuronsPerModule(), originalLayout.standardMultitask(), groups);
    }

    /** Node genes in activation order; may be changed. */
    public List<NodeGene> nodes() {
        return nodes;
    }

    /** Link genes; may be changed. */
    public List<LinkGene> links() {
        return links;
    }

    /** Counts of how often each module was chosen; the array itself, not a copy. */
    public int[] moduleUsage() {
        return moduleUsage;
    }

    /** Replaces the counts of how often each module was chosen. */
    public void setModuleUsage(int[] usage) {
        moduleUsage = usage;
    }

    public int firstOutput() {
        return nodes.size() - outputs;
    }

    /** Output neuron by its number among the outputs. */
    public NodeGene output(int number) {
        return nodes.get(firstOutput() + number);
    }

    /** Position of a neuron in node order; -1 if there is none. */
    public int indexOf(long innovation) {
        for (int i = 0; i < nodes.size(); i++) {
            if (nodes.get(i).innovation() == innovation) {
                return i;
            }
        }
        return -1;
    }

    /** Whether there is a link, active or not, between two neurons. */
    public boolean hasLink(long source, long target) {
        for (LinkGene link : links) {
            if (link.source() == source && link.target() == target) {
                return true;
            }
        }
        return false;
    }

    /**
     * Returns the innovation for the next output neuron. It follows from the position of the neuron. If another output
     * of this network already has that innovation, a new one is taken from the pool instead. This happens if full
     * module mutation (a module linked to all inputs) was combined with module deletion or with excess crossover
     * (children that get all genes of both parents).
     */
    public long nextOutputInnovation(GenePool pool) {
        long byPosition = outputInnovation(inputs, outputs);
        for (int output = 0; output < outputs; output++) {
            if (output(output).innovation() == byPosition) {
                return pool.takeInnovation();
            }
        }
        return byPosition;
    }

    /** Innovation of an output neuron by its number. */
    public static long outputInnovation(int inputs, int output) {
        return -(inputs + output) - 1L;
    }

    /** Appends an output neuron here and, if the archetype lacks it, there. */
    public void appendOutput(NodeGene output, GenePool pool) {
        nodes.add(output);
        outputs++;
        pool.archetype().addOutput(output);
    }

    /**
     * Increases the number of modules by one, in a network without groups. Call it after the module's outputs have been
     * appended by {@link #appendOutput}.
     */
    public void addModule() {
        modules++;
    }

    /** The group of each module; empty in a network without groups. */
    public List<Integer> groups() {
        return List.copyOf(groups);
    }

    /**
     * Increases the number of modules by one and puts the new module into a group. Call it after the module's outputs
     * have been appended by {@link #appendOutput}. In a network without groups the group has no effect.
     */
    public void addModuleTo(int group) {
        if (!groups.isEmpty()) {
            groups.add(group);
        }
        modules++;
    }

    /** Replaces the groups of the modules, in a network that has groups. */
    public void setGroups(List<Integer> ofEachModule) {
        if (!groups.isEmpty()) {
            List<Integer> adopted = List.copyOf(ofEachModule);
            groups.clear();
            groups.addAll(adopted);
        }
    }

    /** Replaces all genes, and counts outputs and modules again. */
    public void replaceGenes(List<NodeGene> newNodes, List<LinkGene> newLinks) {
        List<NodeGene> nodesToAdopt = List.copyOf(newNodes);
        List<LinkGene> linksToAdopt = List.copyOf(newLinks);
        nodes.clear();
        nodes.addAll(nodesToAdopt);
        links.clear();
        links.addAll(linksToAdopt);
        outputs = 0;
        for (NodeGene node : nodes) {
            outputs += node.type() == NodeType.OUTPUT ? 1 : 0;
        }
        int neuronsPerModule = policyNeuronsPerModule() + (originalLayout.standardMultitask() ? 0 : 1);
        modules = Math.max(1, outputs / neuronsPerModule);
    }
}
