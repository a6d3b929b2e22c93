package mmneat.neat.io;

import java.util.List;
import java.util.function.BiConsumer;

/**
 * Writes objects in the notation of the original's serialiser, character for character.
 *
 * <p>Names and values are numbers, constants and class names, so that nothing needs escaping. Source:
 * docs/specification/networks.md, section 12.
 */
final class SerialisedText {

    private final StringBuilder text = new StringBuilder();
    /** Objects and arrays are numbered in document order. */
    private int nextId;

    void open(String className) {
        text.append("<object type=\"")
                .append(className)
                .append("\" id=\"")
                .append(nextId++)
                .append("\">");
    }

    void close() {
        text.append("</object>");
    }

    void openField(String name) {
        text.append("<field name=\"").append(name).append("\">");
    }

    void closeField() {
        text.append("</field>");
    }

    void integer(String name, int value) {
        primitive(name, "int", Integer.toString(value));
    }

    void longInteger(String name, long value) {
        primitive(name, "long", Long.toString(value));
    }

    void number(String name, double value) {
        primitive(name, "double", Double.toString(value));
    }

    void flag(String name, boolean value) {
        primitive(name, "boolean", Boolean.toString(value));
    }

    void word(String name, String value) {
        primitive(name, "string", value);
    }

    private void primitive(String name, String type, String value) {
        text.append("<field name=\"").append(name);
        text.append("\" type=\"").append(type);
        text.append("\" value=\"").append(value).append("\" />");
    }

    void integers(String name, int[] values) {
        openField(name);
        openArray("int", values.length);
        for (int i = 0; i < values.length; i++) {
            text.append(i == 0 ? "" : " ").append(values[i]);
        }
        text.append("</array>");
        closeField();
    }

    /**
     * Writes a list as the original writes the internal array of a {@code java.util.ArrayList}: unused elements are
     * null.
     */
    <T> void list(List<T> elements, BiConsumer<SerialisedText, T> writer) {
        int capacity = capacityFor(elements.size());
        open("java.util.ArrayList");
        openField("elementData");
        openArray("java.lang.Object", capacity);
        elements.forEach(element -> writer.accept(this, element));
        text.append("<object />".repeat(capacity - elements.size()));
        text.append("</array>");
        closeField();
        integer("size", elements.size());
        integer("modCount", elements.size());
        close();
    }

    private void openArray(String type, int length) {
        text.append("<array type=\"").append(type);
        text.append("\" length=\"").append(length);
        text.append("\" id=\"").append(nextId++).append("\">");
    }

    /** Capacity of a list to which elements were added one by one: 10, then half more each time. */
    private static int capacityFor(int size) {
        int capacity = 10;
        while (capacity < size) {
            capacity += capacity >> 1;
        }
        return capacity;
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
