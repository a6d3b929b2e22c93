package mmneat.nsga2;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * The volume that a set of score vectors dominates above a reference point. It grows as the front gets closer to the
 * optimum and broader.
 *
 * <p>Source: E. Zitzler, L. Thiele: Multiobjective evolutionary algorithms, IEEE Transactions on Evolutionary
 * Computation 3 (1999); docs/specification/evolution.md, section 7.
 */
public final class Hypervolume {

    private Hypervolume() {}

    /**
     * Measure of the union of the boxes from {@code reference} to each point. A point that is not above the reference
     * in every objective adds nothing to the volume.
     *
     * @param scores {@code scores[individual][objective]}, all maximised
     * @param reference the reference point: one score per objective
     * @throws IllegalArgumentException if the vectors and the reference differ in length or are empty, or a number is
     *     not finite
     */
    public static double of(double[][] scores, double[] reference) {
        NondominatedSorting.requireComparable(scores);
        requireReference(reference, scores);
        List<double[]> boxes = Arrays.stream(scores)
                .map(score -> minus(score, reference))
                .filter(box -> Arrays.stream(box).allMatch(side -> side > 0))
                .toList();
        return unionOfBoxes(boxes, reference.length);
    }

    private static void requireReference(double[] reference, double[][] scores) {
        if (reference.length == 0) {
            throw new IllegalArgumentException("the hypervolume needs at least one objective");
        }
        if (scores.length > 0 && scores[0].length != reference.length) {
            throw new IllegalArgumentException(
                    "scores have " + scores[0].length + " objectives, but the reference point has " + reference.length);
        }
        for (double least : reference) {
            if (!Double.isFinite(least)) {
                throw new IllegalArgumentException("reference point must be finite, is " + Arrays.toString(reference));
            }
        }
    }

    /**
     * Number of vectors that no other vector dominates; each duplicate counts.
     *
     * @throws IllegalArgumentException if the vectors differ in length or a score is not finite
     */
    public static int frontSize(double[][] scores) {
        NondominatedSorting.requireComparable(scores);
        return (int) Arrays.stream(NondominatedRanks.of(scores))
                .filter(rank -> rank == 0)
                .count();
    }

    /*
     * Slicing: the union is cut into slices perpendicular to the last axis, at every box's height. A slice's base is
     * the union, with one axis less, of the boxes that reach as high.
     */
    private static double unionOfBoxes(List<double[]> boxes, int axes) {
        if (axes == 1) {
            return boxes.stream().mapToDouble(box -> box[0]).max().orElse(0);
        }
        int height = axes - 1;
        double[] cuts = Stream.concat(Stream.of(0.0), boxes.stream().map(box -> box[height]))
                .sorted(Comparator.naturalOrder())
                .mapToDouble(cut -> cut)
                .distinct()
                .toArray();
        double volume = 0;
        for (int slice = 1; slice < cuts.length; slice++) {
            double top = cuts[slice];
            List<double[]> reaching =
                    boxes.stream().filter(box -> box[height] >= top).toList();
            volume += (top - cuts[slice - 1]) * unionOfBoxes(reaching, height);
        }
        return volume;
    }

    private static double[] minus(double[] score, double[] reference) {
        double[] difference = new double[reference.length];
        Arrays.setAll(difference, objective -> score[objective] - reference[objective]);
        return difference;
    }
}
