package mmneat.experiment.parameters;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import mmneat.experiment.UserError;
import mmneat.mspacman.TaskVersion;

/**
 * The settings of the sixteen published experiments. There is one experiment for each pair of a version of the task and
 * a method. Its settings are the file {@code configs/<task>/<method>.properties} in the program's jar.
 *
 * <p>Only {@link ParameterReader} applies the settings, when {@code task=} and {@code method=} name such a pair. To get
 * them, read these two words with it.
 *
 * <p>Source: docs/specification/evolution.md, section 9.
 */
public final class PublishedConfigurations {

    /** All methods, in the paper's order. A version of the task has the methods for which there is a file. */
    static final List<String> METHODS = List.of("1M", "2M", "3M", "MMD", "MT", "MT2", "MT3");

    private static final Pattern PLAIN_NAME = Pattern.compile("[\\w-]+(/[\\w-]+)*");

    private PublishedConfigurations() {}

    /** Returns the names of the methods with which the paper evaluated this version, in the paper's order. */
    public static List<String> methodsOf(TaskVersion version) {
        return METHODS.stream()
                .filter(method -> PublishedConfigurations.class.getResource(resource(version, method)) != null)
                .toList();
    }

    /**
     * Returns the paper's settings without task and method. The files also contain task and method, so that they can be
     * given as {@code config=}.
     *
     * @throws UserError if the version was not published with this method
     */
    static Map<String, String> settings(TaskVersion version, String method) {
        String resource = resource(version, method);
        try (InputStream stream = PublishedConfigurations.class.getResourceAsStream(resource)) {
            if (stream == null) {
                throw new UserError("method=" + method + " cannot be combined with task=" + version.label()
                        + "; its methods are " + String.join(", ", methodsOf(version)));
            }
            Map<String, String> settings =
                    PropertiesFile.read(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
            settings.keySet().removeAll(Set.of("task", "method"));
            return settings;
        } catch (IOException e) {
            throw new UncheckedIOException("the packed file " + resource + " cannot be read", e);
        }
    }

    private static String resource(TaskVersion version, String method) {
        return "/configs/" + version.label() + "/" + method + ".properties";
    }

    /**
     * Returns the content of a configuration file in the program's jar, of this paper or another one.
     *
     * @param name with or without the folder {@code configs} and the ending, for example {@code
     *     tciaig-2016/blended-split/MMD}
     * @return empty if there is no such file
     */
    static Optional<byte[]> packed(String name) {
        String plain = name.replaceFirst("^configs/", "").replaceFirst("\\.properties$", "");
        if (!PLAIN_NAME.matcher(plain).matches()) {
            return Optional.empty();
        }
        try (InputStream stream =
                PublishedConfigurations.class.getResourceAsStream("/configs/" + plain + ".properties")) {
            return stream == null ? Optional.empty() : Optional.of(stream.readAllBytes());
        } catch (IOException e) {
            throw new UncheckedIOException("the packed file " + plain + " cannot be read", e);
        }
    }

    /** The parameters in which the methods of a version differ, hybrids included. */
    static Collection<String> namesOfMethods() {
        Set<String> names = new LinkedHashSet<>();
        for (TaskVersion version : TaskVersion.values()) {
            names.addAll(differing(methodsOf(version).stream().map(method -> settings(version, method))));
        }
        names.add("moduleGroups");
        return names;
    }

    /** The parameters in which the versions differ, independent of the method. */
    static Collection<String> namesOfTasks() {
        Collection<String> names = differing(Stream.of(TaskVersion.values())
                .flatMap(version -> methodsOf(version).stream().map(method -> settings(version, method))));
        names.removeAll(namesOfMethods());
        return names;
    }

    /** Returns the names that some of the settings lack or give another value. */
    private static Collection<String> differing(Stream<Map<String, String>> settings) {
        List<Map<String, String>> all = settings.toList();
        Set<String> names = all.stream()
                .flatMap(each -> each.keySet().stream())
                .collect(Collectors.toCollection(LinkedHashSet::new));
        names.removeIf(name ->
                all.stream().map(each -> each.getOrDefault(name, "")).distinct().count() == 1);
        return names;
    }

    /**
     * Returns the parameters that define a method, for a user's task without published settings.
     *
     * @throws UserError if the method divides the task, which only the published versions can
     */
    static Map<String, String> methodAlone(String method) {
        Optional<Map<String, String>> settings = Stream.of(TaskVersion.values())
                .filter(version -> methodsOf(version).contains(method))
                .findFirst()
                .map(version -> settings(version, method));
        // Hybrids are not among the published methods, and divide the task, too.
        if (settings.isEmpty() || settings.get().containsKey("multitaskModes")) {
            throw new UserError("method=" + method + " needs a human-specified task division, which only"
                    + " the tasks " + String.join(", ", TaskVersion.labels()) + " have");
        }
        settings.get().keySet().retainAll(namesOfMethods());
        return settings.get();
    }
}
