package mmneat.experiment.parameters;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import mmneat.experiment.FileErrors;
import mmneat.experiment.TextFiles;
import mmneat.experiment.UserError;
import mmneat.mspacman.TaskVersion;
import org.jspecify.annotations.Nullable;

/**
 * Reads the parameters of an experiment from their layers. Later layers override earlier ones: the defaults, the
 * published settings for the task and method, the parameter file ({@code config=FILE}), the command line.
 */
public final class ParameterReader {

    private static final List<String> WHICH_RUNS = List.of("runs", "run", "runNumber", "randomSeed");

    private final ParameterCatalogue catalogue;

    public ParameterReader(ParameterCatalogue catalogue) {
        this.catalogue = catalogue;
    }

    /**
     * Reads the words of a command line.
     *
     * @param words each {@code name=value} or {@code name:value}
     * @throws UserError if a word or value is invalid
     */
    public Result read(List<String> words) {
        return read(words, false);
    }

    /**
     * Reads parameters with which an evolved network only plays games, without evolution. The file of parameters
     * ({@code config=}) is that of the run in which the network evolved, possibly a run of the original. As {@link
     * #read}, but values for evolution alone are accepted in the file even if this program does not support them.
     *
     * @throws UserError if another word or value is invalid
     */
    public Result readForGames(List<String> words) {
        return read(words, true);
    }

    private Result read(List<String> words, boolean forGames) {
        List<String> remarks = new ArrayList<>();
        Map<String, String> commandLine = commandLine(words, remarks);
        Map<String, String> file =
                commandLine.containsKey("config") ? file(commandLine.get("config"), forGames, remarks) : Map.of();
        commandLine.computeIfPresent(
                "method",
                (unused, method) -> shortMethod(
                        method, asked("task", commandLine, file), asked("pacmanMultitaskScheme", commandLine, file)));
        Map<String, String> asked = new LinkedHashMap<>(file);
        if (WHICH_RUNS.stream().anyMatch(commandLine::containsKey)) {
            // The file may be that of one run (parameters.properties). If the command line selects other runs, all
            // other values still come from the file.
            asked.keySet().removeAll(WHICH_RUNS);
        }
        asked.putAll(commandLine);
        Parameters preset =
                Parameters.defaults(catalogue).with(preset(asked.getOrDefault("task", ""), asked.get("method")));
        Parameters named = Parameters.defaults(catalogue).with(file);
        requireNoContradiction(commandLine, named, preset);
        remarkOnOtherName(commandLine, named, remarks);
        Parameters parameters = preset.with(asked);
        Optional<TaskVersion> version = PublishedTask.version(parameters);
        new NamedCode(parameters, commandLine).requireAllowed(version.isPresent(), forGames);
        if (version.isPresent() && !parameters.ofOwnTask().isEmpty()) {
            throw new UserError("unknown parameter '" + OwnTask.PREFIX
                    + parameters.ofOwnTask().keySet().iterator().next() + "': names with '" + OwnTask.PREFIX
                    + "' are for a task of your own");
        }
        if (version.filter(TaskVersion.ISOLATED::equals).isEmpty()
                && !parameters.text(Tasks.GHOST_LOCATIONS).isEmpty()) {
            remarks.add(Tasks.GHOST_LOCATIONS + " has no effect: only the isolated task has recorded ghost locations");
        }
        if (version.isEmpty()) {
            remarkOnGameParameters(commandLine, parameters, remarks);
        }
        remarkOnIdleClasses(commandLine, parameters, remarks);
        parameters.as(EvolutionParameters.class).requireConsistent();
        if (!parameters.as(TugParameters.class).isChosen()) {
            List<String> idle = TugParameters.names().stream()
                    .filter(commandLine::containsKey)
                    .toList();
            if (!idle.isEmpty()) {
                remarks.add("no effect without ea=TUGNSGA2: " + String.join(", ", idle));
            }
        }
        return new Result(parameters, List.copyOf(remarks));
    }

    private Map<String, String> commandLine(List<String> words, List<String> remarks) {
        Map<String, String> layer = new LinkedHashMap<>();
        for (String text : words) {
            ParameterWord word = ParameterWord.parse(text);
            String value = word.value();
            if (!word.name().startsWith(OwnTask.PREFIX)) {
                Parameter parameter = catalogue.require(word.name());
                value = isNamedHybrid(word) ? word.value() : word.canonicalFor(parameter);
                if (word.isMisleading(parameter)) {
                    remarks.add("'" + text + "' means " + word.name()
                            + "=false: in the form with a colon, as in the original, every value except true is false");
                }
            }
            String before = layer.get(word.name());
            if (before != null && !before.equals(value)) {
                // As in the original.
                remarks.add(word.name() + "=" + before + " is overridden by " + word.name() + "=" + value
                        + ", which comes later");
            }
            layer.put(word.name(), value);
        }
        return layer;
    }

    private static boolean isNamedHybrid(ParameterWord word) {
        return word.name().equals("method") && !word.originalForm() && HybridMethod.isLongForm(word.value());
    }

    private static String asked(String name, Map<String, String> commandLine, Map<String, String> file) {
        return commandLine.getOrDefault(name, file.getOrDefault(name, ""));
    }

    private static String shortMethod(String method, String task, String division) {
        return HybridMethod.isLongForm(method)
                ? HybridMethod.shortName(method, TaskVersion.labelled(task), division)
                : method;
    }

    /**
     * Adds a remark for each parameter of the game that is given for another task. On the command line every value
     * counts. The file of a run contains all defaults, so in a file only other values count.
     */
    private static void remarkOnGameParameters(
            Map<String, String> commandLine, Parameters parameters, List<String> remarks) {
        List<String> idle = GameParameters.ofTheGameAlone().stream()
                .filter(name -> commandLine.containsKey(name)
                        || !parameters
                                .text(name)
                                .equals(parameters.catalogue().require(name).defaultValue()))
                .toList();
        if (!idle.isEmpty()) {
            remarks.add("no effect on task=" + parameters.text("task") + ": " + String.join(", ", idle)
                    + " (for Ms. Pac-Man alone; parameters of a task of your own are called " + OwnTask.PREFIX
                    + "NAME)");
        }
    }

    /** Adds a remark for each class of the user's own on the command line that is never called. */
    private static void remarkOnIdleClasses(
            Map<String, String> commandLine, Parameters parameters, List<String> remarks) {
        boolean isDivisionIdle = PublishedTask.version(parameters).isPresent()
                && parameters.integer("multitaskModes") < 2
                && isOwnClass("pacmanMultitaskScheme", commandLine, parameters);
        if (isDivisionIdle) {
            remarks.add("pacmanMultitaskScheme has no effect: with method=" + parameters.text("method")
                    + " no division chooses modules; method=MT2, MT3 or a hybrid such as H21 uses it");
        }
        if (!parameters.flag("mating") && isOwnClass("crossover", commandLine, parameters)) {
            remarks.add("crossover has no effect without mating=true");
        }
    }

    private static boolean isOwnClass(String name, Map<String, String> commandLine, Parameters parameters) {
        return commandLine.containsKey(name)
                && !parameters.catalogue().require(name).choices().contains(parameters.text(name));
    }

    /** Reads a parameter file: Java properties, or a file that the original saved. */
    private Map<String, String> file(String name, boolean forGames, List<String> remarks) {
        if (name.isEmpty()) {
            throw new UserError("config=: must be the name of a file");
        }
        Map<String, String> layer;
        try {
            String text = text(bytes(name));
            List<String> lines = text.lines().toList();
            if (OriginalParameterFile.isOne(lines)) {
                OriginalParameterFile file = OriginalParameterFile.of(lines, catalogue);
                layer = new LinkedHashMap<>(file.values());
                file.remark(name).ifPresent(remarks::add);
            } else {
                layer = PropertiesFile.read(text);
            }
            if (forGames) {
                layer.entrySet().removeIf(this::concernsUnsupportedEvolution);
            }
            Parameters.defaults(catalogue).with(layer);
        } catch (IOException e) {
            throw FileErrors.unreadable("config=" + name, e);
        } catch (UserError e) {
            throw new UserError(name + ": " + e.getMessage(), e);
        }
        layer.computeIfPresent(Tasks.GHOST_LOCATIONS, (unused, value) -> besideFile(name, value));
        if (layer.containsKey("config")) {
            throw new UserError(name + ": config= is for the command line only");
        }
        return layer;
    }

    private boolean concernsUnsupportedEvolution(Map.Entry<String, String> entry) {
        Optional<Parameter> parameter = catalogue.find(entry.getKey()).filter(known -> !known.decidesGames());
        return parameter.isPresent() && !parameter.get().accepts(entry.getValue());
    }

    /** Returns the content of a file, or of the file with this name in the program's jar. */
    private static byte[] bytes(String name) throws IOException {
        Path file = Path.of(name);
        if (Files.notExists(file)) {
            Optional<byte[]> packed = PublishedConfigurations.packed(name);
            if (packed.isPresent()) {
                return packed.get();
            }
        }
        return TextFiles.bytes(file, TextFiles.SETTINGS_MIB);
    }

    /** Decodes UTF-8 text, with or without a byte order mark. */
    private static String text(byte[] bytes) {
        ByteBuffer read = ByteBuffer.wrap(bytes);
        CharBuffer text = CharBuffer.allocate(bytes.length);
        if (StandardCharsets.UTF_8.newDecoder().decode(read, text, true).isError()) {
            long line = 1
                    + IntStream.range(0, read.position())
                            .filter(i -> bytes[i] == '\n')
                            .count();
            throw new UserError("line " + line + " is not UTF-8; save the file in UTF-8");
        }
        return text.flip().toString().replaceFirst("^\uFEFF", "");
    }

    /**
     * Returns the path of a file beside the parameter file, as in a run's folder, if it exists; otherwise the name
     * unchanged.
     */
    private static String besideFile(String parameterFile, String name) {
        Path beside = Path.of(parameterFile).resolveSibling(name);
        return !name.isEmpty() && Files.isRegularFile(beside, LinkOption.NOFOLLOW_LINKS) ? beside.toString() : name;
    }

    private Map<String, String> preset(String task, @Nullable String method) {
        Parameter methods = catalogue.require("method");
        String chosen = methods.check(method == null ? methods.defaultValue() : method);
        return TaskVersion.labelled(task)
                .map(version -> HybridMethod.of(chosen)
                        .map(hybrid -> hybrid.settings(version))
                        .orElseGet(() -> PublishedConfigurations.settings(version, chosen)))
                .orElseGet(() -> method == null ? Map.of() : PublishedConfigurations.methodAlone(chosen));
    }

    /**
     * Checks that the file does not turn the task or method of the command line into another one. The file overrides
     * the published settings, so it could do that under the same name. A file that names the same task and method may
     * set any value.
     */
    private static void requireNoContradiction(Map<String, String> commandLine, Parameters file, Parameters preset) {
        boolean otherMethod = isOther("method", commandLine, file);
        boolean otherTask =
                isOther("task", commandLine, file) && TaskVersion.labels().contains(commandLine.get("task"));
        String config = " in config=" + commandLine.get("config");
        if (otherMethod || otherTask && !file.isGiven("method")) {
            contradiction(PublishedConfigurations.namesOfMethods(), commandLine, file, preset)
                    .ifPresent(name -> {
                        throw new UserError(name + "=" + file.text(name) + config + " contradicts "
                                + (otherMethod
                                        ? "method=" + commandLine.get("method")
                                        : "task=" + commandLine.get("task") + " without a method")
                                + ", which means " + name + "=" + preset.text(name)
                                + (otherMethod
                                        ? ": leave out method= (saveTo=NAME names the runs), or give " + name
                                                + "= on the command line, too"
                                        : ": give the file's method with method=NAME"));
                    });
        }
        if (otherTask) {
            contradiction(PublishedConfigurations.namesOfTasks(), commandLine, file, preset)
                    .ifPresent(name -> {
                        throw new UserError(name + "=" + file.text(name) + config + " contradicts task="
                                + commandLine.get("task") + ", which means " + name + "=" + preset.text(name)
                                + ": give a file of this task");
                    });
        }
    }

    /** Adds a remark if the command line names another task or method than the file. */
    private static void remarkOnOtherName(Map<String, String> commandLine, Parameters file, List<String> remarks) {
        // A file of the original names the task by its class.
        Optional<String> version = PublishedTask.version(file.values()).map(TaskVersion::label);
        for (String name : List.of("task", "method")) {
            boolean isOther = file.isGiven(name) && isOther(name, commandLine, file);
            if (isOther && !(name.equals("task") && version.equals(Optional.ofNullable(commandLine.get(name))))) {
                remarks.add(name + "=" + file.text(name) + " in config=" + commandLine.get("config")
                        + " is overridden by " + name + "=" + commandLine.get(name));
            }
        }
    }

    private static boolean isOther(String name, Map<String, String> commandLine, Parameters file) {
        return commandLine.containsKey(name)
                && !(file.isGiven(name) && file.text(name).equals(commandLine.get(name)));
    }

    private static Optional<String> contradiction(
            Collection<String> names, Map<String, String> commandLine, Parameters file, Parameters preset) {
        return names.stream()
                .filter(name -> file.isGiven(name) && !commandLine.containsKey(name))
                .filter(name -> !file.text(name).equals(preset.text(name)))
                .findFirst();
    }

    /**
     * The parameters that were read.
     *
     * @param parameters all values
     * @param remarks messages to the user about values that were interpreted in an unexpected way
     */
    public record Result(Parameters parameters, List<String> remarks) {}
}
