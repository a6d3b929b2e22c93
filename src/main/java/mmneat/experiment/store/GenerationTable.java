package mmneat.experiment.store;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import mmneat.evolution.Evaluation;
import mmneat.evolution.Generation;
import mmneat.evolution.Individual;
import mmneat.evolution.Task;

/**
 * The table {@code generations.csv}, one line per generation: the score by which champions are chosen (best, median and
 * worst of the parents), the best of each objective, and the size of the champion's network. It contains no times, so
 * that equal runs write equal files.
 */
public final class GenerationTable {

    private static final CsvMapper CSV = new CsvMapper();

    private final Task task;

    public GenerationTable(Task task) {
        this.task = task;
    }

    public String header() {
        List<String> names = new ArrayList<>(RunLayout.GENERATIONS_COLUMNS);
        task.objectiveNames().forEach(name -> names.add("best " + name));
        return line(names);
    }

    public String row(Generation generation) {
        double[] scores = scores(task, generation);
        Individual champion = generation.champion(task);
        List<String> fields = new ArrayList<>(List.of(
                Integer.toString(generation.number()),
                DoubleText.of(scores[scores.length - 1]),
                DoubleText.of(median(scores)),
                DoubleText.of(scores[0]),
                Long.toString(champion.genotype().id()),
                Integer.toString(champion.genotype().modules()),
                Integer.toString(champion.genotype().nodes().size()),
                Integer.toString(champion.genotype().links().size()),
                Long.toString(Stream.concat(generation.parents().stream(), generation.children().stream())
                        .mapToLong(
                                individual -> individual.evaluation().outcomes().steps())
                        .sum())));
        for (int objective = 0; objective < task.objectiveNames().size(); objective++) {
            fields.add(DoubleText.of(Generation.bestIn(generation.parents(), objective)
                    .evaluation()
                    .objectives()[objective]));
        }
        return line(fields);
    }

    /**
     * Returns the champion score of each parent, in ascending order: the score by which champions are chosen, for
     * example the mean game score ({@link Task#championScore}).
     */
    public static double[] scores(Task task, Generation generation) {
        return generation.parents().stream()
                .map(Individual::evaluation)
                .mapToDouble((Evaluation evaluation) -> task.championScore(evaluation))
                .sorted()
                .toArray();
    }

    /** Returns the median of scores in ascending order. */
    public static double median(double[] sorted) {
        int middle = sorted.length / 2;
        return sorted.length % 2 == 1 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
    }

    private static String line(List<String> fields) {
        try {
            return CSV.writeValueAsString(fields.toArray(new String[0]));
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("not writable as CSV: " + Arrays.toString(fields.toArray()), e);
        }
    }
}
