package mmneat.neat.io;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * An object in the notation of the original's serialiser (WOX): a class name and fields by name. Every error names the
 * field.
 *
 * <p>Source: docs/specification/networks.md, section 12.
 */
final class SerialisedObject {

    private final String path;
    private final String className;
    private final Map<String, XmlElement> fields;
    private final Map<String, XmlElement> objectsById;

    private SerialisedObject(
            String path, String className, Map<String, XmlElement> fields, Map<String, XmlElement> objectsById) {
        this.path = path;
        this.className = className;
        this.fields = fields;
        this.objectsById = objectsById;
    }

    /** Parses the object in a document. */
    static SerialisedObject parse(String xml) throws GenotypeFormatException {
        XmlElement root = XmlElement.parse(xml);
        Map<String, XmlElement> objectsById = new HashMap<>();
        collectIds(root, objectsById);
        return of(root, "", objectsById);
    }

    private static void collectIds(XmlElement element, Map<String, XmlElement> objectsById) {
        String id = element.attributes().get("id");
        if (id != null) {
            objectsById.put(id, element);
        }
        element.children().forEach(child -> collectIds(child, objectsById));
    }

    private static SerialisedObject of(XmlElement element, String path, Map<String, XmlElement> objectsById)
            throws GenotypeFormatException {
        XmlElement target = element;
        String reference = element.attributes().get("idref");
        if (reference != null) {
            target = objectsById.get(reference);
            if (target == null) {
                throw new GenotypeFormatException(
                        at(path) + "refers to object " + reference + ", which does not exist");
            }
        }
        String type = target.attributes().get("type");
        if (!target.name().equals("object") || type == null) {
            throw new GenotypeFormatException(at(path) + "must be an <object> with a type, is <" + target.name() + ">");
        }
        Map<String, XmlElement> fields = new LinkedHashMap<>();
        for (XmlElement field : target.children()) {
            String name = field.attributes().get("name");
            if (!field.name().equals("field") || name == null) {
                throw new GenotypeFormatException(
                        at(path) + "must hold <field> elements with names, holds <" + field.name() + ">");
            }
            if (fields.put(name, field) != null) {
                throw new GenotypeFormatException(at(path) + "field " + name + " occurs twice");
            }
        }
        return new SerialisedObject(path, type, fields, objectsById);
    }

    /** Returns the class name without its package: the original was published under two packages. */
    String simpleClassName() {
        return className.substring(className.lastIndexOf('.') + 1);
    }

    /** Refuses an object whose class has none of these simple names. */
    void requireClass(String... simpleNames) throws GenotypeFormatException {
        if (!Set.of(simpleNames).contains(simpleClassName())) {
            throw new GenotypeFormatException(at(path) + "must be a " + simpleNames[0] + ", is a " + className);
        }
    }

    /** Whether the object has one of these fields. */
    boolean hasAnyOf(String... names) {
        return Set.of(names).stream().anyMatch(fields::containsKey);
    }

    /** Returns the first of these names for which a field exists; the first name if none exists. */
    String present(String... names) {
        for (String name : names) {
            if (fields.containsKey(name)) {
                return name;
            }
        }
        return names[0];
    }

    /** Refuses unknown fields, whose values would be lost. */
    void requireNoFieldsBut(String... known) throws GenotypeFormatException {
        Set<String> unknown = new HashSet<>(fields.keySet());
        unknown.removeAll(Set.of(known));
        if (!unknown.isEmpty()) {
            throw new GenotypeFormatException(
                    at(path) + "unknown field " + unknown.iterator().next());
        }
    }

    int integer(String name) throws GenotypeFormatException {
        long value = longInteger(name);
        if (value != (int) value) {
            throw new GenotypeFormatException(at(pathOf(name)) + "must be an int, is " + value);
        }
        return (int) value;
    }

    long longInteger(String name) throws GenotypeFormatException {
        String text = text(name);
        try {
            return Long.parseLong(text);
        } catch (NumberFormatException e) {
            throw new GenotypeFormatException(at(pathOf(name)) + "must be a whole number, is \"" + text + "\"", e);
        }
    }

    double number(String name) throws GenotypeFormatException {
        String text = text(name);
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            throw new GenotypeFormatException(at(pathOf(name)) + "must be a number, is \"" + text + "\"", e);
        }
    }

    boolean flag(String name) throws GenotypeFormatException {
        String text = text(name);
        return switch (text) {
            case "true" -> true;
            case "false" -> false;
            default ->
                throw new GenotypeFormatException(at(pathOf(name)) + "must be true or false, is \"" + text + "\"");
        };
    }

    /** An array of ints. */
    int[] integers(String name) throws GenotypeFormatException {
        XmlElement array = onlyChild(name, "array");
        String[] words = array.text().toString().strip().split("\\s+");
        int[] values = new int[words.length == 1 && words[0].isEmpty() ? 0 : words.length];
        for (int i = 0; i < values.length; i++) {
            try {
                values[i] = Integer.parseInt(words[i]);
            } catch (NumberFormatException e) {
                throw new GenotypeFormatException(
                        at(pathOf(name) + "[" + i + "]") + "must be an int, is \"" + words[i] + "\"", e);
            }
        }
        return values;
    }

    /** A list of objects. */
    List<SerialisedObject> list(String name) throws GenotypeFormatException {
        return of(onlyChild(name, "object"), pathOf(name), objectsById).elements();
    }

    /** The elements of this object, which is a list. */
    List<SerialisedObject> elements() throws GenotypeFormatException {
        requireClass("ArrayList");
        List<XmlElement> slots = onlyChild("elementData", "array").children();
        int size = integer("size");
        if (size < 0 || size > slots.size()) {
            throw new GenotypeFormatException(
                    at(pathOf("size")) + "is " + size + " but there are " + slots.size() + " elements");
        }
        List<SerialisedObject> elements = new ArrayList<>(size);
        for (int i = 0; i < size; i++) {
            elements.add(of(slots.get(i), path + "[" + i + "]", objectsById));
        }
        return elements;
    }

    private XmlElement onlyChild(String name, String kind) throws GenotypeFormatException {
        List<XmlElement> children = field(name).children();
        if (children.size() != 1 || !children.get(0).name().equals(kind)) {
            throw new GenotypeFormatException(at(pathOf(name)) + "must hold one <" + kind + ">");
        }
        return children.get(0);
    }

    String text(String name) throws GenotypeFormatException {
        String value = field(name).attributes().get("value");
        if (value == null) {
            throw new GenotypeFormatException(at(pathOf(name)) + "has no value");
        }
        return value;
    }

    private XmlElement field(String name) throws GenotypeFormatException {
        XmlElement field = fields.get(name);
        if (field == null) {
            throw new GenotypeFormatException(at(pathOf(name)) + "is missing");
        }
        return field;
    }

    private String pathOf(String field) {
        return path.isEmpty() ? field : path + "." + field;
    }

    private static String at(String path) {
        return path.isEmpty() ? "document: " : path + ": ";
    }
}
