package mmneat.nsga2;

import java.util.Arrays;
import java.util.Comparator;

/** Stable sorting of individuals (indices) by a value. */
final class ScoreOrder {

    private ScoreOrder() {}

    /** A value of each individual, for example one objective's score. */
    interface Value {
        double of(int individual);
    }

    /** 0, 1, ..., size - 1. */
    static int[] identity(int size) {
        int[] order = new int[size];
        Arrays.setAll(order, i -> i);
        return order;
    }

    /**
     * {@code order} sorted ascending by {@code value}; equal values keep their places. Two infinite crowding distances are equal,
     * and so are the two zeros.
     */
    static int[] ascending(int[] order, Value value) {
        Comparator<Integer> byValue = (a, b) -> {
            double first = value.of(a);
            double second = value.of(b);
            return first < second ? -1 : first > second ? 1 : 0;
        };
        return Arrays.stream(order).boxed().sorted(byValue).mapToInt(i -> i).toArray();
    }
}
