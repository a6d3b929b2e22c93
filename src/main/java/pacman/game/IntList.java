package pacman.game;

import java.util.AbstractList;
import java.util.Arrays;
import java.util.List;

/** A growing list of ints. */
final class IntList {

    private int[] values = new int[64];
    private int size;

    void add(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, 2 * size);
        }
        values[size++] = value;
    }

    int get(int index) {
        return values[index];
    }

    void set(int index, int value) {
        values[index] = value;
    }

    int size() {
        return size;
    }

    void clear() {
        size = 0;
    }

    /** The mean as the original accumulates it: avg += (x - avg) / (i + 1); 0 for an empty list. */
    double mean() {
        double mean = 0;
        for (int i = 0; i < size; i++) {
            mean += (values[i] - mean) / (i + 1);
        }
        return mean;
    }

    /** Returns a copy of the list. */
    List<Integer> toList() {
        int[] copy = Arrays.copyOf(values, size);
        return new AbstractList<>() {
            @Override
            public Integer get(int index) {
                return copy[index];
            }

            @Override
            public int size() {
                return copy.length;
            }
        };
    }
}
