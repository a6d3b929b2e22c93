package mmneat.neat.io;

import java.util.ArrayList;
import java.util.List;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;

/**
 * The original's XML form of genotypes and archetypes.
 *
 * <p>What is written here reads in the original, and what the original wrote reads here, from either of the packages under
 * which it was published. Safe for files from strangers: no document types, no entities, no deep nests.
 *
 * <p>Source: docs/specification/networks.md, section 12.
 */
public final class GenotypeXml {

    private static final String GENOTYPE = "TWEANNGenotype";
    private static final String NODE = GENOTYPE + "$NodeGene";
    private static final String LINK = GENOTYPE + "$LinkGene";
    private static final String PACKAGE = "edu.utexas.cs.nn.evolution.genotypes.";

    private GenotypeXml() {}

    /**
     * Reads a genotype.
     *
     * @throws GenotypeFormatException if the text is not a genotype in XML; the message names the field
     */
    public static Genotype read(String xml) throws GenotypeFormatException {
        SerialisedObject object = SerialisedObject.parse(xml);
        object.requireClass(GENOTYPE);
        object.requireNoFieldsBut(
                "nodes",
                "links",
                "numIn",
                "numOut",
                "numModes",
                "neuronsPerMode",
                "standardMultitask",
                "hierarchicalMultitask",
                "modeAssociations",
                "modeUsage",
                "id",
                "archetypeIndex");
        if (object.flag("hierarchicalMultitask")) {
            throw new GenotypeFormatException(
                    "hierarchicalMultitask: hierarchical multitask networks are not supported");
        }
        List<LinkGene> links = new ArrayList<>();
        for (SerialisedObject link : object.list("links")) {
            links.add(linkOf(link));
        }
        List<NodeGene> nodes = nodesOf(object.list("nodes"));
        try {
            ModuleLayout layout = new ModuleLayout(
                    object.integer("numOut"),
                    object.integer("numModes"),
                    object.integer("neuronsPerMode"),
                    object.flag("standardMultitask"));
            return new Genotype(
                    object.longInteger("id"),
                    object.integer("numIn"),
                    layout,
                    nodes,
                    links,
                    object.integers("modeUsage"));
        } catch (IllegalArgumentException e) {
            throw new GenotypeFormatException(e.getMessage(), e);
        }
    }

    /**
     * Reads the entries of an archetype.
     *
     * @throws GenotypeFormatException if the text is not a list of node genes in XML; the message names the field
     */
    public static List<NodeGene> readArchetype(String xml) throws GenotypeFormatException {
        return nodesOf(SerialisedObject.parse(xml).elements());
    }

    /** The XML text of a genotype: one line, without a line end. */
    public static String write(Genotype genotype) {
        SerialisedText text = new SerialisedText();
        ModuleLayout layout = genotype.layout();
        text.open(PACKAGE + GENOTYPE);
        text.openField("nodes");
        text.list(genotype.nodes(), GenotypeXml::write);
        text.closeField();
        text.openField("links");
        text.list(genotype.links(), GenotypeXml::write);
        text.closeField();
        text.integer("numIn", genotype.inputs());
        text.integer("numOut", layout.outputs());
        text.integer("numModes", layout.modules());
        text.integer("neuronsPerMode", layout.policyNeuronsPerModule());
        text.flag("standardMultitask", layout.standardMultitask());
        text.flag("hierarchicalMultitask", false);
        text.integers("modeAssociations", oneToOne(layout.modules()));
        text.integers("modeUsage", genotype.moduleUsage());
        text.longInteger("id", genotype.id());
        text.integer("archetypeIndex", 0);
        text.close();
        return text.toString();
    }

    /** The XML text of an archetype's entries: one line, without a line end. */
    public static String writeArchetype(List<NodeGene> entries) {
        SerialisedText text = new SerialisedText();
        text.list(entries, GenotypeXml::write);
        return text.toString();
    }

    private static List<NodeGene> nodesOf(List<SerialisedObject> objects) throws GenotypeFormatException {
        List<NodeGene> nodes = new ArrayList<>();
        for (int i = 0; i < objects.size(); i++) {
            SerialisedObject object = objects.get(i);
            object.requireClass(NODE);
            object.requireNoFieldsBut("ntype", "ftype", "fromCombiningCrossover", "innovation", "frozen");
            try {
                nodes.add(new NodeGene(
                        object.longInteger("innovation"),
                        NodeType.ofCode(object.integer("ntype")),
                        ActivationFunction.ofCode(object.integer("ftype")),
                        object.flag("frozen"),
                        object.flag("fromCombiningCrossover")));
            } catch (IllegalArgumentException e) {
                throw new GenotypeFormatException("nodes[" + i + "]: " + e.getMessage(), e);
            }
        }
        return nodes;
    }

    private static LinkGene linkOf(SerialisedObject object) throws GenotypeFormatException {
        object.requireClass(LINK);
        object.requireNoFieldsBut(
                "sourceInnovation", "targetInnovation", "weight", "active", "recurrent", "innovation", "frozen");
        return new LinkGene(
                object.longInteger("innovation"),
                object.longInteger("sourceInnovation"),
                object.longInteger("targetInnovation"),
                object.number("weight"),
                object.flag("active"),
                object.flag("recurrent"),
                object.flag("frozen"));
    }

    private static void write(SerialisedText text, NodeGene node) {
        text.open(PACKAGE + NODE);
        text.integer("ntype", node.type().code());
        text.integer("ftype", node.activation().code());
        text.flag("fromCombiningCrossover", node.fromCombiningCrossover());
        text.longInteger("innovation", node.innovation());
        text.flag("frozen", node.frozen());
        text.close();
    }

    private static void write(SerialisedText text, LinkGene link) {
        text.open(PACKAGE + LINK);
        text.longInteger("sourceInnovation", link.source());
        text.longInteger("targetInnovation", link.target());
        text.number("weight", link.weight());
        text.flag("active", link.active());
        text.flag("recurrent", link.recurrent());
        text.longInteger("innovation", link.innovation());
        text.flag("frozen", link.frozen());
        text.close();
    }

    private static int[] oneToOne(int modules) {
        int[] associations = new int[modules];
        for (int i = 0; i < modules; i++) {
            associations[i] = i;
        }
        return associations;
    }
}
