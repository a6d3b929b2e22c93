package mmneat.contest.entry;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import mmneat.experiment.UserError;

/**
 * The user's description of a controller: the name of a class and the arguments of its constructor, as in {@code
 * my.Entry(Legacy, 3, 'two words')}.
 *
 * @param name name of the class
 * @param arguments texts of the arguments, in order, without surrounding blanks
 */
record ControllerCall(String name, List<String> arguments) {

    /**
     * Reads a name with or without arguments.
     *
     * @throws UserError if parentheses or quotes are not balanced
     */
    static ControllerCall parse(String text) {
        return read(text)
                .orElseThrow(() ->
                        new UserError("'" + text.strip() + "' is not understood; write Class or Class(argument,...)"));
    }

    /** Reads a name with or without arguments; empty if the text is neither. */
    static Optional<ControllerCall> read(String text) {
        String call = text.strip();
        int open = call.indexOf('(');
        if (open < 0) {
            return Optional.of(new ControllerCall(call, List.of()));
        }
        if (open == 0 || !call.endsWith(")")) {
            return Optional.empty();
        }
        String name = call.substring(0, open).strip();
        return split(call.substring(open + 1, call.length() - 1)).map(list -> new ControllerCall(name, list));
    }

    /** Splits at the commas outside of quotes and inner parentheses; empty if these are not balanced. */
    private static Optional<List<String>> split(String list) {
        List<String> arguments = new ArrayList<>();
        StringBuilder argument = new StringBuilder();
        int depth = 0;
        char quote = 0;
        for (char sign : list.toCharArray()) {
            if (quote != 0) {
                quote = sign == quote ? 0 : quote;
            } else if (sign == '\'' || sign == '"') {
                quote = sign;
            } else if (sign == '(') {
                depth++;
            } else if (sign == ')') {
                depth--;
            }
            if (depth < 0) {
                return Optional.empty();
            }
            if (sign == ',' && depth == 0 && quote == 0) {
                arguments.add(argument.toString().strip());
                argument.setLength(0);
            } else {
                argument.append(sign);
            }
        }
        if (depth != 0 || quote != 0) {
            return Optional.empty();
        }
        if (!arguments.isEmpty() || !argument.toString().isBlank()) {
            arguments.add(argument.toString().strip());
        }
        return Optional.of(arguments);
    }
}
