package mmneat.experiment.run;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import mmneat.experiment.FileErrors;
import mmneat.experiment.NearestName;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.HybridMethod;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.parameters.PublishedConfigurations;
import mmneat.experiment.store.RunStatus;
import mmneat.mspacman.TaskVersion;

/**
 * A set of experiments: every published combination of the listed tasks and methods, and every listed hybrid. Each has
 * folders of its own.
 *
 * <p>It is described by words as on the command line, in which {@code task} and {@code method} may be lists: {@code
 * task=blended,isolated method=1M,2M}. {@code method=all} means all published methods of each task.
 *
 * @param parts the experiments, not empty: all methods of the first task, then all methods of the second, and so on;
 *     tasks and methods in the order in which the words list them
 * @param remarks messages to the user, one line each: combinations that were not published and are left out
 */
public record Study(List<Part> parts, List<String> remarks) {

    private static final String ALL = "all";

    /** Ending that stands for all files of an experiment beside its runs' folders. */
    private static final String FILES = ".*";

    public Study {
        parts = List.copyOf(parts);
        remarks = List.copyOf(remarks);
    }

    /**
     * Returns the experiments that the words describe.
     *
     * @throws UserError if a word is invalid, no combination was published, or two experiments would share a folder
     */
    public static Study of(List<String> words, ParameterCatalogue catalogue) {
        List<String> tasks = list(words, "task", "");
        List<String> methods = list(words, "method", catalogue.require("method").defaultValue());
        List<Part> parts = new ArrayList<>();
        List<String> remarks = new ArrayList<>();
        if (tasks.size() <= 1 && methods.size() <= 1 && !methods.contains(ALL)) {
            parts.add(part(words, catalogue, remarks));
            return new Study(parts, remarks);
        }
        List<String> common = words.stream()
                .filter(word -> !isNamed(word, "task") && !isNamed(word, "method"))
                .toList();
        // An unknown method is an error, not an unpublished combination.
        List<String> known = methods.stream()
                .filter(method -> !method.equals(ALL))
                .map(catalogue.require("method")::check)
                .toList();
        requireOnce("method", known);
        for (String task : tasks) {
            List<String> published = publishedMethods(task);
            Set<String> chosen = new LinkedHashSet<>(methods.contains(ALL) ? published : List.of());
            chosen.addAll(known);
            for (String method : chosen) {
                if (published.contains(method) || HybridMethod.of(method).isPresent()) {
                    List<String> own = new ArrayList<>(List.of("task=" + task, "method=" + method));
                    own.addAll(common);
                    parts.add(part(own, catalogue, remarks));
                } else {
                    remarks.add("task=" + task + " has no method " + method + " (it has " + String.join(", ", published)
                            + "): left out");
                }
            }
        }
        if (parts.isEmpty()) {
            throw new UserError(remarks.isEmpty() ? "task is missing; give it as task=blended" : remarks.get(0));
        }
        requireOwnFolders(parts);
        return new Study(parts, remarks);
    }

    private static Part part(List<String> words, ParameterCatalogue catalogue, List<String> remarks) {
        ParameterReader.Result read = new ParameterReader(catalogue).read(words);
        remarks.addAll(read.remarks());
        ExperimentPlan plan = ExperimentPlan.of(read.parameters());
        ExperimentRunner.requirePossible(plan);
        return new Part(plan, words);
    }

    /** Checks that no two experiments share the folder of a run or, in one base folder, the name of their files. */
    private static void requireOwnFolders(List<Part> parts) {
        Map<Path, Part> owners = new HashMap<>();
        for (Part part : parts) {
            ExperimentPlan plan = part.plan();
            Stream<Path> places = Stream.concat(
                    plan.runs().stream().map(RunPlan::directory),
                    Stream.of(plan.base().resolve(plan.name() + FILES)));
            places.map(place -> place.toAbsolutePath().normalize()).forEach(place -> {
                Part other = owners.putIfAbsent(place, part);
                if (other != null && other != part) {
                    throw new UserError(shared(other, part, place));
                }
            });
        }
    }

    private static String shared(Part first, Part second, Path place) {
        String given = Stream.of("saveTo", "log", "base")
                .flatMap(name -> second.words().stream().filter(word -> isNamed(word, name)))
                .collect(Collectors.joining(" "));
        return first.label() + " and " + second.label() + " would share "
                + (place.endsWith(second.plan().name() + FILES) ? "files, " : "the folder ") + place
                + (given.isEmpty()
                        ? ": submit them one at a time, one of them with saveTo=NAME"
                        : ": leave out " + given + ", or submit them one at a time under different names");
    }

    private static List<String> publishedMethods(String task) {
        return TaskVersion.labelled(task)
                .map(PublishedConfigurations::methodsOf)
                .orElseThrow(
                        () -> new UserError("task=" + task + ": a list takes " + String.join(", ", TaskVersion.labels())
                                + NearestName.suggestion(task, TaskVersion.labels())));
    }

    /**
     * Returns the values of a word that may be a list. If the word is missing, the result is {@code otherwise}, or
     * empty if that is empty.
     */
    private static List<String> list(List<String> words, String name, String otherwise) {
        List<String> values = new ArrayList<>();
        words.stream()
                .filter(word -> isNamed(word, name))
                .map(word -> word.substring(name.length() + 1))
                .flatMap(value -> HybridMethod.isLongForm(value) ? Stream.of(value) : Arrays.stream(value.split(",")))
                .map(String::strip)
                .filter(value -> !value.isEmpty())
                .map(value -> value.equalsIgnoreCase(ALL) ? ALL : value)
                .forEach(values::add);
        requireOnce(name, values);
        if (values.isEmpty() && !otherwise.isEmpty()) {
            values.add(otherwise);
        }
        return values;
    }

    private static void requireOnce(String name, List<String> values) {
        Set<String> seen = new HashSet<>();
        for (String value : values) {
            if (!seen.add(value)) {
                throw new UserError(name + "=" + String.join(",", values) + ": " + value + " is named twice");
            }
        }
    }

    private static boolean isNamed(String word, String name) {
        return word.startsWith(name + "=") || word.startsWith(name + ":");
    }

    /**
     * One experiment of the study.
     *
     * @param plan its runs
     * @param words the words that describe it on a command line
     */
    public record Part(ExperimentPlan plan, List<String> words) {

        public Part {
            words = List.copyOf(words);
        }

        /** The task and method, for messages. */
        private String label() {
            return "task=" + plan.parameters().text("task") + " method="
                    + plan.parameters().text("method");
        }

        /**
         * Returns the numbers of the runs that are not complete, according to their folders.
         *
         * @throws UserError if a folder cannot be read
         */
        public List<Integer> unfinishedRuns() {
            return plan.runs().stream()
                    .filter(run -> !isFinished(run))
                    .map(RunPlan::number)
                    .toList();
        }

        private static boolean isFinished(RunPlan run) {
            try {
                return RunStatus.read(run.directory()).filter(run::isFinished).isPresent();
            } catch (IOException e) {
                throw FileErrors.unreadable(run.directory(), e);
            }
        }
    }
}
