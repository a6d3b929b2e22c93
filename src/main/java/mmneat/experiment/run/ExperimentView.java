package mmneat.experiment.run;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.core.JsonParseException;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;
import mmneat.experiment.store.DurableFiles;
import mmneat.experiment.store.GenerationTable;
import mmneat.experiment.store.RunView;

/**
 * The state of an experiment, read from its files. It includes requested runs that were not started.
 *
 * @param name name of the experiment, for instance {@code blended-2M}
 * @param base its folder
 * @param runs by ascending number
 */
public record ExperimentView(String name, Path base, List<RunView> runs) {

    /** Maximum depth at which {@link #readAll} finds folders of runs below its folder. */
    public static final int DEPTH = 5;

    private static final String ASKED = ".runs.json";

    public ExperimentView {
        runs = List.copyOf(runs);
    }

    /** Number of runs in a state. */
    public long count(RunView.State state) {
        return runs.stream().filter(run -> run.state() == state).count();
    }

    /** Whether every run is finished. */
    public boolean isFinished() {
        return count(RunView.State.FINISHED) == runs.size();
    }

    /** All experiments in a folder or below it, by path and name. */
    public static List<ExperimentView> readAll(Path folder, Instant now) throws IOException {
        Map<String, Map<Integer, RunView>> byExperiment = new TreeMap<>();
        Map<String, Path> bases = new TreeMap<>();
        Map<String, String> names = new TreeMap<>();
        for (Path path : filesBelow(folder)) {
            List<RunView> found = Files.isDirectory(path)
                    ? RunView.isRun(path) ? List.of(RunView.read(path, now)) : List.of()
                    : asked(path);
            for (RunView run : found) {
                Path base = run.directory().toAbsolutePath().normalize().getParent();
                String key = base + "/" + run.experiment();
                bases.put(key, base);
                names.put(key, run.experiment());
                // The folder of a run overrides the list of requested runs.
                byExperiment
                        .computeIfAbsent(key, unused -> new TreeMap<>())
                        .merge(run.number(), run, ExperimentView::betterKnown);
            }
        }
        List<ExperimentView> experiments = new ArrayList<>();
        byExperiment.forEach((key, runs) -> experiments.add(new ExperimentView(
                Objects.requireNonNull(names.get(key)),
                Objects.requireNonNull(bases.get(key)),
                List.copyOf(runs.values()))));
        return experiments;
    }

    /** Returns the folder and everything below it. Symbolic links are followed; unreadable folders are left out. */
    private static List<Path> filesBelow(Path folder) throws IOException {
        List<Path> found = new ArrayList<>();
        Files.walkFileTree(folder, Set.of(FileVisitOption.FOLLOW_LINKS), DEPTH, new SimpleFileVisitor<>() {
            @Override
            public FileVisitResult preVisitDirectory(Path directory, BasicFileAttributes attributes) {
                found.add(directory);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
                found.add(file);
                return FileVisitResult.CONTINUE;
            }

            @Override
            public FileVisitResult visitFileFailed(Path file, IOException failure) {
                return FileVisitResult.CONTINUE;
            }
        });
        Collections.sort(found);
        return found;
    }

    private static RunView betterKnown(RunView first, RunView second) {
        return first.state() == RunView.State.WAITING ? second : first;
    }

    /** Median of the champions' scores; NaN if there is none. */
    public double medianChampion() {
        double[] scores = runs.stream()
                .mapToDouble(RunView::bestScore)
                .filter(score -> !Double.isNaN(score))
                .sorted()
                .toArray();
        return scores.length == 0 ? Double.NaN : GenerationTable.median(scores);
    }

    /** The run with the best champion so far, if there is one. */
    public Optional<RunView> best() {
        return runs.stream()
                .filter(run -> !Double.isNaN(run.bestScore()))
                .max(Comparator.comparingDouble(RunView::bestScore));
    }

    /**
     * Records the requested runs in the experiment's folder, so that runs that were not started are shown as waiting.
     *
     * @throws UserError if the runs of another {@code saveTo} are recorded under the same name
     */
    public static void recordRequested(ExperimentPlan plan) throws IOException {
        Path file = plan.base().resolve(plan.name() + ASKED);
        SortedSet<Integer> numbers = new TreeSet<>();
        for (RunView run : asked(file)) {
            numbers.add(run.number());
            requireSameFolder(run, plan, file);
        }
        plan.runs().forEach(run -> numbers.add(run.number()));
        String saveTo = plan.parameters().text("saveTo");
        DurableFiles.write(file, JsonMapper.builder().build().writeValueAsBytes(new AskedRuns(saveTo, numbers)));
    }

    /** Two experiments whose runs lie in different folders must not share the files of all runs. */
    private static void requireSameFolder(RunView known, ExperimentPlan plan, Path file) {
        Path other = plan.base().resolve(plan.parameters().text("saveTo") + known.number());
        if (!known.directory().normalize().equals(other.normalize())) {
            throw new UserError(file + ": belongs to the runs " + known.directory() + ", and those of saveTo="
                    + plan.parameters().text("saveTo") + " would have files of the same names; give log=NAME");
        }
    }

    /** Whether a file has the name of an experiment's list of requested runs. */
    public static boolean isListOfRuns(Path file) {
        return file.getFileName() != null && file.getFileName().toString().endsWith(ASKED);
    }

    private static List<RunView> asked(Path file) throws IOException {
        String fileName = file.getFileName().toString();
        if (!isListOfRuns(file) || !Files.exists(file)) {
            return List.of();
        }
        String name = fileName.substring(0, fileName.length() - ASKED.length());
        AskedRuns asked;
        try {
            asked = JsonMapper.builder().build().readValue(file.toFile(), AskedRuns.class);
            if (asked == null) {
                throw new JsonParseException(null, "it is null");
            }
        } catch (JacksonException e) {
            throw new UserError(
                    file + ": is damaged; remove it (it only lists the requested runs and is written again)", e);
        }
        List<RunView> waiting = new ArrayList<>();
        for (int run : asked.runs()) {
            waiting.add(RunView.waiting(file.resolveSibling(asked.saveTo() + run), name, run));
        }
        return waiting;
    }

    /**
     * The content of the file of requested runs.
     *
     * @param saveTo name of the runs' folders, without their numbers
     * @param runs numbers of the runs
     */
    private record AskedRuns(String saveTo, SortedSet<Integer> runs) {
        AskedRuns {
            Objects.requireNonNull(saveTo, "saveTo");
            PlainText.require("saveTo", saveTo);
            if (runs == null || runs.stream().anyMatch(run -> run == null || run < 0)) {
                throw new IllegalArgumentException("runs must be numbers of runs, are " + runs);
            }
        }
    }
}
