package mmneat.experiment.cluster;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Lists of run numbers in the short form that schedulers read: {@code 0-3,7,9-29}. */
final class RunRanges {

    private RunRanges() {}

    /** @param ascending run numbers, ascending, without repetition */
    static String of(List<Integer> ascending) {
        List<String> ranges = new ArrayList<>();
        int first = 0;
        for (int i = 1; i <= ascending.size(); i++) {
            boolean ends = i == ascending.size() || ascending.get(i) != ascending.get(i - 1) + 1;
            if (ends) {
                int from = ascending.get(first);
                int to = ascending.get(i - 1);
                ranges.add(from == to ? Integer.toString(from) : from + "-" + to);
                first = i;
            }
        }
        return String.join(",", ranges);
    }

    /**
     * Splits runs for a scheduler whose array indices must be below {@code limit}. It maps an offset, a multiple of
     * {@code limit}, to the indices; a run is offset plus index.
     */
    static Map<Integer, List<Integer>> split(List<Integer> runs, int limit) {
        Map<Integer, List<Integer>> parts = new TreeMap<>();
        for (int run : runs) {
            int offset = run / limit * limit;
            parts.computeIfAbsent(offset, unused -> new ArrayList<>()).add(run - offset);
        }
        return parts;
    }
}
