package mmneat.nsga2;

import java.util.Arrays;

/** Stable sorting of individuals, given by their indices, by a number. */
final class ScoreOrder {

    private ScoreOrder() {}

    /** A number for each individual, for example its score in one objective. */
    interface Value {
        /** Returns the number of an individual, given by its index. */
        double of(int individual);
    }

    /** 0, 1, ..., size - 1. */
    static int[] identity(int size) {
        int[] order = new int[size];
        Arrays.setAll(order, i -> i);
        return order;
    }

    /**
     * Sorts {@code order} ascending by {@code value}; equal values keep their order. Two infinite crowding distances
     * are equal, and so are the two zeros.
     *
     * @param value a number for each individual, never NaN
     */
    static int[] ascending(int[] order, Value value) {
        double[] values = new double[order.length];
        Arrays.setAll(values, i -> value.of(order[i]) + 0.0);
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        int[] result = new int[order.length];
        int[] taken = new int[order.length];
        for (int i = 0; i < order.length; i++) {
            int first = firstPosition(sorted, values[i]);
            result[first + taken[first]++] = order[i];
        }
        return result;
    }

    /** Returns the first index of {@code value}, which the ascending array must contain. */
    static int firstPosition(double[] sorted, double value) {
        int low = 0;
        int high = sorted.length;
        while (low < high) {
            int middle = (low + high) >>> 1;
            if (sorted[middle] < value) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        return low;
    }

    /**
     * Sorts {@code order} ascending by small integers; equal ones keep their order.
     *
     * @param position of each individual, from 0 to {@code position.length - 1}
     */
    static int[] byPosition(int[] order, int[] position) {
        int[] end = new int[position.length + 1];
        for (int individual : order) {
            end[position[individual] + 1]++;
        }
        for (int i = 1; i < end.length; i++) {
            end[i] += end[i - 1];
        }
        int[] result = new int[order.length];
        for (int individual : order) {
            result[end[position[individual]]++] = individual;
        }
        return result;
    }
}
