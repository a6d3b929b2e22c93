package mmneat.cli.options;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Stack;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import mmneat.experiment.NearestName;
import mmneat.experiment.UserError;
import picocli.CommandLine.IParameterPreprocessor;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;

/**
 * A preprocessor of command line arguments for picocli, which supports options such as {@code games=3} but not their
 * other forms.
 *
 * <ul>
 *   <li>{@code games:3}, the original's form, becomes {@code games=3} if the command has an option {@code games}.
 *   <li>An option given twice keeps its last value; a remark says so.
 *   <li>A word that is neither an option nor a positional parameter of the command is an error; its message suggests
 *       the nearest name. Without this, picocli would treat {@code sed=1} as a file name.
 * </ul>
 */
public final class ArgumentSyntax implements IParameterPreprocessor {

    /** Label of positional parameters that accept every {@code name=value}: the parameters of an experiment. */
    public static final String PARAMETER = "NAME=VALUE";

    /** A name of letters, digits, dots, dashes and underscores, then the separator and the value. */
    private static final Pattern NAMED = Pattern.compile("([A-Za-z][A-Za-z0-9._-]*)([=:])(.*)", Pattern.DOTALL);

    @Override
    public boolean preprocess(Stack<String> stack, CommandSpec command, ArgSpec argument, Map<String, Object> info) {
        List<String> words = new ArrayList<>();
        while (!stack.isEmpty()) {
            words.add(stack.pop());
        }
        List<String> prepared;
        try {
            prepared = prepare(words, command);
        } catch (UserError e) {
            throw new ParameterException(command.commandLine(), e.getMessage(), e);
        }
        for (int i = prepared.size() - 1; i >= 0; i--) {
            stack.push(prepared.get(i));
        }
        return false;
    }

    private static List<String> prepare(List<String> words, CommandSpec command) {
        List<String> names = names(command);
        Map<String, String> options = new LinkedHashMap<>();
        List<String> positional = new ArrayList<>();
        for (String word : words) {
            Matcher named = NAMED.matcher(word);
            if (command.optionsMap().containsKey(word) && !names.contains(word)) {
                // Options such as --help.
                options.put(word, word);
            } else if (named.matches() && names.contains(named.group(1))) {
                String name = named.group(1);
                String given = name + "=" + named.group(3);
                String before = options.put(name, given);
                if (before != null) {
                    remark(command, before + " is overridden by " + given + ", which comes later");
                }
            } else {
                requirePositional(word, command, positional.size(), names);
                positional.add(word);
            }
        }
        List<String> prepared = new ArrayList<>(options.values());
        prepared.addAll(positional);
        return prepared;
    }

    /** The names of the options that are written {@code name=value}. */
    public static List<String> names(CommandSpec command) {
        return command.options().stream()
                .map(option -> option.longestName())
                .filter(name -> !name.startsWith("-"))
                .toList();
    }

    private static void requirePositional(String word, CommandSpec command, int before, List<String> names) {
        if (word.startsWith("-") && word.length() > 1) {
            throw new ParameterException(command.commandLine(), "unknown option '" + word + "'");
        }
        if (takesParameters(command)) {
            return;
        }
        if (names.contains(word)) {
            throw new UserError("'" + word + "' has no value; write " + word + "=...");
        }
        Matcher named = NAMED.matcher(word);
        boolean looksLikeOption = named.matches();
        boolean hasRoom = before < capacity(command);
        if (hasRoom && word.isBlank()) {
            throw new UserError("'" + word + "' is not a name: give "
                    + command.positionalParameters().get(0).paramLabel());
        }
        // A file name may contain a colon (a drive letter, a time) but must not look like an assignment.
        if (hasRoom && !(looksLikeOption && named.group(2).equals("="))) {
            return;
        }
        if (looksLikeOption) {
            throw unknown(named.group(1), names);
        }
        throw new UserError("'" + word + "' is not understood; write name=value" + NearestName.suggestion(word, names));
    }

    /** Whether a command accepts parameters of an experiment in addition to its options. */
    public static boolean takesParameters(CommandSpec command) {
        return command.positionalParameters().stream()
                .anyMatch(parameter -> parameter.paramLabel().equals(PARAMETER));
    }

    private static int capacity(CommandSpec command) {
        return command.positionalParameters().stream()
                .mapToInt(parameter -> parameter.arity().max())
                .max()
                .orElse(0);
    }

    private static UserError unknown(String name, List<String> names) {
        String suggestion = NearestName.suggestion(name, names);
        boolean lists = suggestion.isEmpty() && !names.isEmpty();
        return new UserError(
                "unknown name '" + name + "'" + (lists ? "; known: " + String.join(", ", names) : suggestion));
    }

    private static void remark(CommandSpec command, String text) {
        command.commandLine().getErr().println("mmneat: " + text);
        command.commandLine().getErr().flush();
    }
}
