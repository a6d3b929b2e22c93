package mmneat.analysis.replay;

import java.io.ByteArrayOutputStream;

/**
 * A quantity over time, stored as differences between consecutive steps. Values are unsigned numbers of {@code width}
 * bytes, one to three; differences are taken modulo 256 to the power of {@code width}. They are stored as one plane per
 * byte, lowest byte first.
 */
final class Column {

    private final String name;
    private final ByteArrayOutputStream[] planes;
    private int before;

    Column(String name, int width) {
        this.name = name;
        planes = new ByteArrayOutputStream[width];
        for (int i = 0; i < width; i++) {
            planes[i] = new ByteArrayOutputStream();
        }
    }

    String name() {
        return name;
    }

    /** Bytes per value. */
    int width() {
        return planes.length;
    }

    void add(int value) {
        if (value < 0 || value >>> (8 * planes.length) != 0) {
            throw new IllegalArgumentException(name + ": " + value + " does not fit " + planes.length + " bytes");
        }
        int difference = value - before;
        before = value;
        for (ByteArrayOutputStream plane : planes) {
            plane.write(difference);
            difference >>= 8;
        }
    }

    void repeat() {
        add(before);
    }

    void writeTo(ByteArrayOutputStream out) {
        for (ByteArrayOutputStream plane : planes) {
            out.writeBytes(plane.toByteArray());
        }
    }
}
