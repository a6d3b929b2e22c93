package mmneat.neat.io;

import java.io.StringWriter;
import java.util.Locale;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import mmneat.neat.Genotype;

/** Writes a network as GraphML, for example for Gephi, yEd or NetworkX. */
public final class NetworkGraphml {

    private NetworkGraphml() {}

    /**
     * The GraphML text of a network: nodes with label, role, module and innovation, edges with weight and whether they
     * are recurrent.
     *
     * @param labels names of its inputs and modules
     * @throws IllegalArgumentException if the number of labels is not that of the network's inputs or modules
     */
    public static String of(Genotype genotype, NetworkLabels labels) {
        NetworkGraph graph = NetworkGraph.of(genotype, labels);
        StringWriter text = new StringWriter();
        try {
            XMLStreamWriter xml = XMLOutputFactory.newDefaultFactory().createXMLStreamWriter(text);
            write(xml, graph);
            xml.close();
        } catch (XMLStreamException e) {
            throw new IllegalStateException("network " + genotype.id() + " cannot be written as GraphML", e);
        }
        return text.append('\n').toString();
    }

    private static void write(XMLStreamWriter xml, NetworkGraph graph) throws XMLStreamException {
        xml.writeStartDocument("UTF-8", "1.0");
        start(xml, "graphml");
        xml.writeDefaultNamespace("http://graphml.graphdrawing.org/xmlns");
        declare(xml, "label", "node", "string");
        declare(xml, "role", "node", "string");
        declare(xml, "module", "node", "int");
        declare(xml, "innovation", "node", "long");
        declare(xml, "weight", "edge", "double");
        declare(xml, "recurrent", "edge", "boolean");
        start(xml, "graph");
        xml.writeAttribute("id", "network");
        xml.writeAttribute("edgedefault", "directed");
        for (int i = 0; i < graph.neurons().size(); i++) {
            NetworkGraph.Neuron neuron = graph.neurons().get(i);
            start(xml, "node");
            xml.writeAttribute("id", "n" + i);
            data(xml, "label", neuron.label());
            data(xml, "role", neuron.role().name().toLowerCase(Locale.ROOT));
            if (neuron.module() >= 0) {
                data(xml, "module", Integer.toString(neuron.module() + 1));
            }
            data(xml, "innovation", Long.toString(neuron.innovation()));
            xml.writeEndElement();
        }
        for (NetworkGraph.Link link : graph.links()) {
            start(xml, "edge");
            xml.writeAttribute("source", "n" + link.source());
            xml.writeAttribute("target", "n" + link.target());
            data(xml, "weight", Double.toString(link.weight()));
            data(xml, "recurrent", Boolean.toString(link.isRecurrent()));
            xml.writeEndElement();
        }
        xml.writeEndElement();
        xml.writeEndElement();
        xml.writeEndDocument();
    }

    private static void declare(XMLStreamWriter xml, String name, String domain, String type)
            throws XMLStreamException {
        start(xml, "key");
        xml.writeAttribute("id", name);
        xml.writeAttribute("for", domain);
        xml.writeAttribute("attr.name", name);
        xml.writeAttribute("attr.type", type);
        xml.writeEndElement();
    }

    private static void data(XMLStreamWriter xml, String key, String value) throws XMLStreamException {
        xml.writeStartElement("data");
        xml.writeAttribute("key", key);
        xml.writeCharacters(value);
        xml.writeEndElement();
    }

    /** Starts an element on a new line. */
    private static void start(XMLStreamWriter xml, String name) throws XMLStreamException {
        xml.writeCharacters("\n");
        xml.writeStartElement(name);
    }
}
