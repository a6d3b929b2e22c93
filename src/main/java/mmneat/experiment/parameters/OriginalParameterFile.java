package mmneat.experiment.parameters;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * The parameter file that the original saves with a run: all its parameters, including defaults, as {@code name:value}.
 *
 * <p>Later versions of the original have more parameters, and say "module" where the names of the catalogue say "mode";
 * both words mean a module of the network. The later names are mapped to those of the catalogue. A parameter that the
 * catalogue does not have is left out.
 *
 * @param values by the catalogue's names, flags as true or false
 * @param leftOut names of unknown parameters with a value that may have an effect, in the order of the file
 */
public record OriginalParameterFile(Map<String, String> values, List<String> leftOut) {

    /** A name, a colon and, without any escapes, the value. */
    private static final Pattern LINE = Pattern.compile("\\w+:.*");

    /** Values of unknown parameters that have no effect. */
    private static final Set<String> OFF = Set.of("", "false", "null", "0", "0.0", "-1", "-1.0");

    private static final int MOST_NAMES = 5;

    /** Whether a text has the form of such a file. */
    static boolean isOne(List<String> lines) {
        List<String> filled = lines.stream().filter(line -> !line.isBlank()).toList();
        return !filled.isEmpty()
                && filled.stream().allMatch(line -> LINE.matcher(line).matches());
    }

    /** Reads the lines of such a file; lines without a colon are ignored. */
    public static OriginalParameterFile of(List<String> lines, ParameterCatalogue catalogue) {
        Map<String, String> values = new LinkedHashMap<>();
        List<String> leftOut = new ArrayList<>();
        for (String line : lines) {
            int colon = line.indexOf(':');
            if (colon > 0) {
                String name = line.substring(0, colon);
                String value = line.substring(colon + 1).strip();
                Optional<Parameter> parameter = catalogue.find(name).or(() -> catalogue.find(earlierName(name)));
                if (parameter.isPresent()) {
                    values.put(parameter.get().name(), canonical(parameter.get(), value));
                } else if (!OFF.contains(value.toLowerCase(java.util.Locale.ROOT))) {
                    leftOut.add(name);
                }
            }
        }
        return new OriginalParameterFile(values, List.copyOf(leftOut));
    }

    /** Returns the name that was used before the original renamed modes to modules. */
    private static String earlierName(String name) {
        return name.replace("Module", "Mode").replace("module", "mode");
    }

    /** In the original, every text except "true" is false. */
    private static String canonical(Parameter parameter, String value) {
        return parameter.type() == ParameterType.BOOLEAN ? Boolean.toString(value.equalsIgnoreCase("true")) : value;
    }

    /** Returns the message to the user about parameters that were left out. */
    Optional<String> remark(String file) {
        if (leftOut.isEmpty()) {
            return Optional.empty();
        }
        String more = leftOut.size() > MOST_NAMES ? " and " + (leftOut.size() - MOST_NAMES) + " more" : "";
        return Optional.of(file + ": left out, because they belong to a later version of the original: "
                + String.join(", ", leftOut.subList(0, Math.min(leftOut.size(), MOST_NAMES))) + more);
    }
}
