package mmneat.experiment.store;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import mmneat.evolution.Evaluation;
import mmneat.evolution.Generation;
import mmneat.evolution.Individual;
import mmneat.evolution.Task;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;

/**
 * The table {@code generations.csv}, one line per generation: the score by which champions are chosen (best, median and
 * worst of the parents), the best of each objective, and the size of the champion's network. Of a hybrid it also has
 * the modules of each group, and how often the group was used. It contains no times, so that equal runs write equal
 * files.
 */
public final class GenerationTable {

    private static final CsvMapper CSV = new CsvMapper();

    private final Task task;

    /** Number of groups that have columns; 0 in runs without groups. */
    private final int groups;

    private GenerationTable(Task task, int groups) {
        this.task = task;
        this.groups = groups;
    }

    /**
     * The table of a run, which may have rows already. Versions before the first release began the table of a hybrid
     * without columns of groups; such a table goes on without them.
     *
     * @param folder the folder of the run
     * @param layout of the run's initial networks
     * @throws IOException if the table cannot be read
     */
    public static GenerationTable in(Path folder, Task task, ModuleLayout layout) throws IOException {
        Path file = folder.resolve(RunLayout.GENERATIONS);
        int groups = layout.sizesOfGroups().size();
        if (groups > 0 && Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
            try (BufferedReader table = Files.newBufferedReader(file)) {
                String header = table.readLine();
                boolean hasGroups = header == null
                        || header.contains(RunLayout.columnsOfGroup(0).get(0));
                return new GenerationTable(task, hasGroups ? groups : 0);
            }
        }
        return new GenerationTable(task, groups);
    }

    public String header() {
        List<String> names = new ArrayList<>(RunLayout.GENERATIONS_COLUMNS);
        task.objectiveNames().forEach(name -> names.add("best " + name));
        for (int group = 0; group < groups; group++) {
            names.addAll(RunLayout.columnsOfGroup(group));
        }
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
        fields.addAll(ofGroups(champion.genotype()));
        return line(fields);
    }

    /** For each group the number of its modules, and its share of all choices of a module. */
    private List<String> ofGroups(Genotype champion) {
        List<Integer> sizes = champion.layout().sizesOfGroups();
        int[] usage = champion.moduleUsage();
        long[] uses = new long[groups];
        for (int module = 0; module < usage.length && groups > 0; module++) {
            uses[champion.layout().choiceOf(module)] += usage[module];
        }
        long all = Arrays.stream(uses).sum();
        List<String> fields = new ArrayList<>();
        for (int group = 0; group < groups; group++) {
            fields.add(Integer.toString(sizes.get(group)));
            fields.add(DoubleText.of(all == 0 ? 0 : (double) uses[group] / all));
        }
        return fields;
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
