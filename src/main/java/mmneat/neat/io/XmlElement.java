package mmneat.neat.io;

import java.io.StringReader;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import javax.xml.XMLConstants;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/**
 * An element of a small XML document, with its children.
 *
 * @param name the tag
 * @param attributes attributes by name
 * @param children child elements in order
 * @param text all text directly inside
 */
record XmlElement(String name, Map<String, String> attributes, List<XmlElement> children, StringBuilder text) {

    /** The original nests nine levels deep. */
    private static final int MAX_DEPTH = 32;

    /** Enough for 60,000 links; every element takes about 250 bytes of memory. */
    private static final int MAX_ELEMENTS = 500_000;

    /**
     * Parses a document. Document types, and with them entities of any kind, are refused; so are deep nesting and
     * documents with too many elements.
     *
     * @throws GenotypeFormatException if the text is not such a document
     */
    static XmlElement parse(String xml) throws GenotypeFormatException {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLConstants.ACCESS_EXTERNAL_DTD, "");
        try {
            XMLStreamReader reader = factory.createXMLStreamReader(new StringReader(xml));
            try {
                return parse(reader);
            } finally {
                reader.close();
            }
        } catch (XMLStreamException e) {
            String message = e.getMessage() == null ? "" : e.getMessage().replaceAll("\\s+", " ");
            throw new GenotypeFormatException("not well-formed XML: " + message, e);
        }
    }

    private static XmlElement parse(XMLStreamReader reader) throws XMLStreamException, GenotypeFormatException {
        List<XmlElement> open = new ArrayList<>();
        XmlElement root = null;
        int elements = 0;
        while (reader.hasNext()) {
            switch (reader.next()) {
                case XMLStreamConstants.START_ELEMENT -> {
                    if (++elements > MAX_ELEMENTS) {
                        throw new GenotypeFormatException("more than " + MAX_ELEMENTS + " XML elements" + line(reader));
                    }
                    XmlElement element = elementAt(reader);
                    if (open.isEmpty()) {
                        root = element;
                    } else {
                        open.get(open.size() - 1).children.add(element);
                    }
                    open.add(element);
                    if (open.size() > MAX_DEPTH) {
                        throw new GenotypeFormatException(
                                "XML elements are nested deeper than " + MAX_DEPTH + " levels" + line(reader));
                    }
                }
                case XMLStreamConstants.END_ELEMENT -> open.remove(open.size() - 1);
                case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA -> {
                    if (!open.isEmpty()) {
                        open.get(open.size() - 1).text.append(reader.getText());
                    }
                }
                case XMLStreamConstants.DTD, XMLStreamConstants.ENTITY_REFERENCE ->
                    throw new GenotypeFormatException("XML document types and entities are not allowed" + line(reader));
                default -> {
                    // Comments, white space and the end of the document are ignored.
                }
            }
        }
        return Objects.requireNonNull(root, "a document has an element");
    }

    private static XmlElement elementAt(XMLStreamReader reader) {
        Map<String, String> attributes = new HashMap<>();
        for (int i = 0; i < reader.getAttributeCount(); i++) {
            attributes.put(reader.getAttributeLocalName(i), reader.getAttributeValue(i));
        }
        return new XmlElement(reader.getLocalName(), attributes, new ArrayList<>(), new StringBuilder());
    }

    private static String line(XMLStreamReader reader) {
        return " (line " + reader.getLocation().getLineNumber() + ")";
    }
}
