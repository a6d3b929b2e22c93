package mmneat.analysis.results;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import mmneat.experiment.FileErrors;
import mmneat.experiment.FolderPlace;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.experiment.run.ExperimentView;
import mmneat.mspacman.TaskVersion;

/**
 * Finds the experiments that a path denotes. {@code results} denotes every experiment in the folders below it, {@code
 * results/blended} every method in it, {@code results/blended/2M} all runs 2M0, 2M1, ..., and the folder of a run only
 * that run.
 */
public final class ExperimentFinder {

    private ExperimentFinder() {}

    /**
     * Reads all experiments, in the order of the paths and in the paper's order of methods within one.
     *
     * @throws UserError if a path leads to no run
     */
    public static List<Experiment> find(List<Path> paths) {
        Map<Path, List<RunResult>> groups = new LinkedHashMap<>();
        Set<Path> known = new HashSet<>();
        for (Path path : paths) {
            List<Path> folders = runFolders(path);
            if (folders.isEmpty()) {
                throw new UserError(path
                        + reason(path)
                        + "; give the folder of an experiment, for example results/blended or results/blended/2M");
            }
            // The same run may be meant twice: by results/blended/2M and results/blended/2M0, or by a link to its
            // folder.
            group(withoutKnown(folders, known))
                    .forEach((stem, runs) -> groups.merge(stem, runs, ExperimentFinder::union));
        }
        List<Experiment> experiments = new ArrayList<>();
        groups.forEach((stem, runs) -> experiments.add(experiment(stem, runs)));
        return withLabels(experiments, List.copyOf(groups.keySet()));
    }

    /** Returns the folders that are not known, each once and under its own name rather than that of a link to it. */
    private static List<Path> withoutKnown(List<Path> folders, Set<Path> known) {
        return folders.stream()
                .sorted(Comparator.comparing(Files::isSymbolicLink))
                .filter(folder -> known.add(FolderPlace.real(folder)))
                .toList();
    }

    private static String reason(Path path) {
        if (Files.isDirectory(path)) {
            return ": no finished run is found there";
        }
        return Files.exists(path)
                ? ": is a file"
                : ": there is no such folder, and no finished run whose folder's name begins so";
    }

    private static List<RunResult> union(List<RunResult> some, List<RunResult> others) {
        Map<Integer, RunResult> runs = new TreeMap<>();
        Stream.of(some, others).flatMap(List::stream).forEach(run -> runs.put(run.number(), run));
        return List.copyOf(runs.values());
    }

    private static List<Path> runFolders(Path path) {
        if (!Files.isDirectory(path)) {
            return ofStem(path);
        }
        if (isRun(path)) {
            return List.of(path);
        }
        List<Path> found = new ArrayList<>();
        addRunsBelow(path, ExperimentView.DEPTH, found);
        return found;
    }

    /** Adds the runs in a folder, and in the folders below it. Runs hold no runs. */
    private static void addRunsBelow(Path parent, int depth, List<Path> found) {
        for (Path folder : folders(parent)) {
            if (isRun(folder)) {
                found.add(folder);
            } else if (depth > 1) {
                addRunsBelow(folder, depth - 1, found);
            }
        }
    }

    /** Finds the folders that begin with a path: {@code results/blended/2M} is not a folder, but 2M0, 2M1, ... are. */
    private static List<Path> ofStem(Path stem) {
        Path parent = stem.toAbsolutePath().getParent();
        if (parent == null || !Files.isDirectory(parent)) {
            return List.of();
        }
        Path whole = parent.resolve(stem.getFileName());
        return folders(parent).stream()
                .filter(ExperimentFinder::isRun)
                .filter(folder -> stem(folder, RunReader.read(folder)).equals(whole))
                .map(folder -> stem.resolveSibling(folder.getFileName()))
                .toList();
    }

    private static Map<Path, List<RunResult>> group(List<Path> folders) {
        Map<Path, List<RunResult>> groups = new TreeMap<>(Comparator.comparing(ExperimentFinder::parentName)
                .thenComparingInt(ExperimentFinder::paperOrder)
                .thenComparing(Comparator.naturalOrder()));
        for (Path folder : folders) {
            RunResult run = RunReader.read(folder);
            groups.computeIfAbsent(stem(folder, run), key -> new ArrayList<>()).add(run);
        }
        groups.values().forEach(runs -> runs.sort(Comparator.comparingInt(RunResult::number)));
        return groups;
    }

    /** The run's folder without its number. MT20 is run 20 of MT or run 0 of MT2; the parameters decide. */
    private static Path stem(Path folder, RunResult run) {
        String name = folder.getFileName().toString();
        String number = String.valueOf(run.number());
        String stem = name.endsWith(number) ? name.substring(0, name.length() - number.length()) : name;
        return folder.resolveSibling(stem.isEmpty() ? name : stem);
    }

    private static String parentName(Path stem) {
        return String.valueOf(stem.toAbsolutePath().getParent());
    }

    private static int paperOrder(Path stem) {
        List<String> order = List.of("1M", "MT", "MT2", "MT3", "MMD", "3M", "2M");
        int place = order.indexOf(stem.getFileName().toString());
        return place < 0 ? order.size() : place;
    }

    private static Experiment experiment(Path stem, List<RunResult> runs) {
        Map<String, String> parameters = runs.get(0).parameters();
        String name = folderName(stem);
        String version =
                PublishedTask.version(parameters).map(TaskVersion::label).orElse("");
        if (version.isEmpty() && stem.toAbsolutePath().getParent() != null) {
            String parent = String.valueOf(stem.toAbsolutePath().getParent().getFileName());
            version = TaskVersion.labels().contains(parent) ? parent : "";
        }
        String method =
                parameters.isEmpty() ? name : PublishedTask.method(parameters).orElse(name);
        return new Experiment(version, method, name, runs);
    }

    /**
     * The shortest kind of label that is unique among all experiments: the method, the version and the method, the
     * folder's name, or the folder.
     */
    private static List<Experiment> withLabels(List<Experiment> experiments, List<Path> stems) {
        List<Function<Integer, String>> labels = List.of(
                i -> name(experiments.get(i), stems.get(i)),
                i -> (experiments.get(i).version() + " " + name(experiments.get(i), stems.get(i))).strip(),
                i -> folderName(stems.get(i)),
                i -> stems.get(i).toString());
        for (Function<Integer, String> label : labels) {
            List<String> all = Stream.iterate(0, i -> i + 1)
                    .limit(experiments.size())
                    .map(label)
                    .toList();
            if (Set.copyOf(all).size() == all.size()) {
                List<Experiment> named = new ArrayList<>();
                for (int i = 0; i < all.size(); i++) {
                    Experiment e = experiments.get(i);
                    named.add(new Experiment(e.version(), e.method(), all.get(i), e.runs()));
                }
                return named;
            }
        }
        throw new IllegalStateException("two experiments have the folder " + stems);
    }

    /** The paper's name of the method; the folder's name for a variant, which the paper does not have. */
    private static String name(Experiment experiment, Path stem) {
        return experiment.isVariant() ? folderName(stem) : experiment.paperMethod();
    }

    /** The folder's name without the sign that separates it from the number of the run. */
    private static String folderName(Path stem) {
        String name = stem.getFileName().toString();
        String shortened = name.replaceAll("[-_]+$", "");
        return shortened.isEmpty() ? name : shortened;
    }

    /** @throws UserError if the folder cannot be read */
    private static boolean isRun(Path folder) {
        try {
            return RunReader.isRun(folder);
        } catch (UncheckedIOException e) {
            requireVanished(folder, Objects.requireNonNull(e.getCause()));
            return false;
        }
    }

    private static List<Path> folders(Path parent) {
        try (Stream<Path> entries = Files.list(parent)) {
            return entries.filter(Files::isDirectory).sorted().collect(Collectors.toList());
        } catch (IOException e) {
            requireVanished(parent, e);
            return List.of();
        }
    }

    /** A folder may be deleted during the search. One that is there but cannot be read may hide runs. */
    private static void requireVanished(Path folder, IOException e) {
        if (!(e instanceof NoSuchFileException)) {
            throw FileErrors.unreadable(folder, e);
        }
    }
}
