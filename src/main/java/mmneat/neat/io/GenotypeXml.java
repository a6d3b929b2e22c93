package mmneat.neat.io;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;

/**
 * The original's XML form of genotypes and archetypes.
 *
 * <p>The original, MM-NEAT, can read the files written here, except those with activation functions of the user's own.
 * Files of the original and of its later versions can be read here: from both packages under which it was published,
 * with modules called "mode" (until May 2016) or "module", and with complete or small genes. Small genes are a shorter
 * form of later versions: their fields that have default values are left out (frozen and shadow of a node; active,
 * recurrent and frozen of a link). A feature of a later version that these networks lack is refused by name. Untrusted
 * files are safe to read: document types, entities and deep nesting are refused.
 *
 * <p>Source: docs/specification/networks.md, section 12; docs/genotype-format.md.
 */
public final class GenotypeXml {

    private static final String GENOTYPE = "TWEANNGenotype";
    private static final String NODE = GENOTYPE + "$NodeGene";
    private static final String LINK = GENOTYPE + "$LinkGene";

    /** Later versions use this name for complete genes, and may save small genes under the old names. */
    private static final String FULL_NODE = GENOTYPE + "$FullNodeGene";

    private static final String FULL_LINK = GENOTYPE + "$FullLinkGene";

    private static final String[] OMITTED_BY_SMALL_NODES = {"fromCombiningCrossover", "frozen"};
    private static final String[] OMITTED_BY_SMALL_LINKS = {"active", "recurrent", "frozen"};

    /** The feature that each other genotype class of the original's later versions adds. */
    private static final Map<String, String> FEATURES_OF_GENOTYPES = Map.of(
            "HyperNEATCPPNGenotype", "networks that a CPPN makes (HyperNEAT)",
            "HyperNEATCPPNAndXGenotype", "networks that a CPPN makes (HyperNEAT)",
            "HierarchicalTWEANNGenotype", "hierarchical multitask networks",
            "CombinedGenotype", "pairs of genotypes",
            "MLPGenotype", "multilayer perceptrons",
            "RealValuedGenotype", "vectors of numbers",
            "BoundedRealValuedGenotype", "vectors of numbers",
            "BoundedIntegerValuedGenotype", "vectors of numbers");

    /** The largest code of an activation function in February 2016. */
    private static final int MAX_FUNCTION = ActivationFunction.builtIn().size() - 1;

    private static final String PACKAGE = "edu.utexas.cs.nn.evolution.genotypes.";

    private GenotypeXml() {}

    /**
     * Reads a genotype.
     *
     * @throws GenotypeFormatException if the text is not a genotype in XML; the message names the field
     */
    public static Genotype read(String xml) throws GenotypeFormatException {
        SerialisedObject object = SerialisedObject.parse(xml);
        requireNetwork(object);
        object.requireNoFieldsBut(
                "nodes",
                "links",
                "numIn",
                "numOut",
                "numModes",
                "numModules",
                "neuronsPerMode",
                "neuronsPerModule",
                "standardMultitask",
                "hierarchicalMultitask",
                "modeAssociations",
                "moduleAssociations",
                "modeUsage",
                "moduleUsage",
                "id",
                "parents",
                "smallerGenotypes",
                "archetypeIndex");
        List<NodeGene> nodes = nodesOf(object.list("nodes"));
        List<LinkGene> links = linksOf(object.list("links"), nodes);
        try {
            ModuleLayout layout = new ModuleLayout(
                    object.integer("numOut"),
                    object.integer(object.present("numModes", "numModules")),
                    object.integer(object.present("neuronsPerMode", "neuronsPerModule")),
                    object.flag("standardMultitask"),
                    groupsOf(object));
            int[] usage = object.integers(object.present("modeUsage", "moduleUsage"));
            GenotypeDocument.requireUsageOfModules(usage, layout.modules());
            return new Genotype(object.longInteger("id"), object.integer("numIn"), layout, nodes, links, usage);
        } catch (IllegalArgumentException e) {
            throw new GenotypeFormatException(e.getMessage(), e);
        }
    }

    /** The groups of a hybrid, which the original calls tasks of hierarchical multitask networks. */
    private static List<Integer> groupsOf(SerialisedObject object) throws GenotypeFormatException {
        return object.flag("hierarchicalMultitask")
                ? Arrays.stream(object.integers(object.present("modeAssociations", "moduleAssociations")))
                        .boxed()
                        .toList()
                : List.of();
    }

    /**
     * Reads the entries of an archetype, shadows included, from the original's file {@code archetype0.xml}. An {@link
     * mmneat.neat.Archetype.State} also needs the map of shadows, which the original saves in another file ({@link
     * mmneat.neat.Archetype#shadows}); it is empty if that file is missing.
     *
     * @throws GenotypeFormatException if the text is not a list of node genes in XML; the message names the field
     */
    public static List<NodeGene> readArchetype(String xml) throws GenotypeFormatException {
        return nodesOf(SerialisedObject.parse(xml).elements());
    }

    /** Returns the XML text of a genotype: one line, without a line end. */
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
        text.flag("hierarchicalMultitask", layout.isGrouped());
        text.integers(
                "modeAssociations",
                layout.isGrouped()
                        ? layout.groups().stream().mapToInt(group -> group).toArray()
                        : oneToOne(layout.modules()));
        text.integers("modeUsage", genotype.moduleUsage());
        text.longInteger("id", genotype.id());
        text.integer("archetypeIndex", 0);
        text.close();
        return text.toString();
    }

    /** Returns the XML text of an archetype's entries: one line, without a line end. */
    public static String writeArchetype(List<NodeGene> entries) {
        SerialisedText text = new SerialisedText();
        text.list(entries, GenotypeXml::write);
        return text.toString();
    }

    private static void requireNetwork(SerialisedObject object) throws GenotypeFormatException {
        String feature = FEATURES_OF_GENOTYPES.get(object.simpleClassName());
        if (feature != null) {
            throw new GenotypeFormatException("document: must be a " + GENOTYPE + ", is a " + object.simpleClassName()
                    + ": " + feature + " are not supported");
        }
        object.requireClass(GENOTYPE);
    }

    private static List<NodeGene> nodesOf(List<SerialisedObject> objects) throws GenotypeFormatException {
        List<NodeGene> nodes = new ArrayList<>();
        for (int i = 0; i < objects.size(); i++) {
            try {
                nodes.add(nodeOf(objects.get(i), "nodes[" + i + "]"));
            } catch (IllegalArgumentException e) {
                throw new GenotypeFormatException("nodes[" + i + "]: " + e.getMessage(), e);
            }
        }
        return nodes;
    }

    private static NodeGene nodeOf(SerialisedObject object, String place) throws GenotypeFormatException {
        object.requireClass(NODE, FULL_NODE);
        object.requireNoFieldsBut(
                "ntype", "ftype", "bias", "moduleSource", "fromCombiningCrossover", "innovation", "frozen");
        if (object.hasAnyOf("bias") && object.number("bias") != 0) {
            throw new GenotypeFormatException(place + ".bias: is " + object.number("bias")
                    + "; neurons with a bias, a feature of later versions of the original, are not supported");
        }
        NodeType type = NodeType.ofCode(object.integer("ntype"));
        boolean small = isSmall(object, NODE, OMITTED_BY_SMALL_NODES);
        return new NodeGene(
                object.longInteger("innovation"),
                type,
                functionOf(object, place),
                !small && object.flag("frozen"),
                !small && object.flag("fromCombiningCrossover"));
    }

    private static ActivationFunction functionOf(SerialisedObject node, String place) throws GenotypeFormatException {
        String own = node.text("ftype");
        if (FunctionNames.isOwn(own)) {
            return FunctionNames.read(own);
        }
        int function = node.integer("ftype");
        if (function > MAX_FUNCTION) {
            throw new GenotypeFormatException(place + ".ftype: is " + function
                    + "; activation functions of later versions of the original are not supported");
        }
        return ActivationFunction.ofCode(function);
    }

    /** Whether a gene is small: it has none of the additional fields of a complete gene. */
    private static boolean isSmall(SerialisedObject gene, String className, String... omitted) {
        return gene.simpleClassName().equals(className) && !gene.hasAnyOf(omitted);
    }

    private static List<LinkGene> linksOf(List<SerialisedObject> objects, List<NodeGene> nodes)
            throws GenotypeFormatException {
        Map<Long, Integer> places = new HashMap<>();
        nodes.forEach(node -> places.put(node.innovation(), places.size()));
        List<LinkGene> links = new ArrayList<>();
        for (SerialisedObject object : objects) {
            links.add(linkOf(object, places));
        }
        return links;
    }

    private static LinkGene linkOf(SerialisedObject object, Map<Long, Integer> places) throws GenotypeFormatException {
        object.requireClass(LINK, FULL_LINK);
        object.requireNoFieldsBut(
                "sourceInnovation",
                "targetInnovation",
                "weight",
                "active",
                "recurrent",
                "moduleSource",
                "innovation",
                "frozen");
        boolean small = isSmall(object, LINK, OMITTED_BY_SMALL_LINKS);
        long source = object.longInteger("sourceInnovation");
        long target = object.longInteger("targetInnovation");
        return new LinkGene(
                object.longInteger("innovation"),
                source,
                target,
                object.number("weight"),
                small || object.flag("active"),
                small ? places.getOrDefault(target, 0) <= places.getOrDefault(source, 0) : object.flag("recurrent"),
                !small && object.flag("frozen"));
    }

    private static void write(SerialisedText text, NodeGene node) {
        text.open(PACKAGE + NODE);
        text.integer("ntype", node.type().code());
        if (node.activation().isOwn()) {
            text.word("ftype", FunctionNames.of(node.activation()));
        } else {
            text.integer("ftype", node.activation().code());
        }
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
