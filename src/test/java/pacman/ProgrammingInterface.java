package pacman;

import java.io.BufferedReader;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Signatures of classes in the style of javap, read from a text.
 *
 * @param classes in the order of the text
 */
record ProgrammingInterface(List<ClassBlock> classes) {

    private static final Pattern CLASS_LINE = Pattern.compile(
            "public ((?:\\w+ )*)class ([\\w.$]+)(?:<.*?>)?(?: extends ([\\w.$]+).*?)?" + "(?: implements .*)? \\{");
    private static final Pattern METHOD_LINE = Pattern.compile("(.*?)([\\w.$]+)\\((.*)\\);");
    private static final Pattern FIELD_LINE = Pattern.compile("(.*?) (\\w+)(?: = (.*))?;");
    private static final Pattern COMMENT = Pattern.compile("#.*|\\s*//.*");

    /**
     * @param superclass name of the superclass; null if none is listed
     */
    record ClassBlock(List<String> modifiers, String name, String superclass, List<Member> members) {}

    /**
     * @param type return type or type of the field; empty for a constructor
     * @param name of a constructor: the class's
     * @param parameters their types; null for a field
     * @param value of a constant; otherwise null
     */
    record Member(List<String> modifiers, String type, String name, List<String> parameters, String value) {
        boolean isField() {
            return parameters == null;
        }
    }

    static ProgrammingInterface read(BufferedReader text) throws IOException {
        List<ClassBlock> classes = new ArrayList<>();
        ClassBlock current = null;
        for (String line = text.readLine(); line != null; line = text.readLine()) {
            String code = COMMENT.matcher(line).replaceAll("").strip();
            if (code.isEmpty()) {
                continue;
            }
            Matcher header = CLASS_LINE.matcher(code);
            if (header.matches()) {
                current = new ClassBlock(
                        List.of(header.group(1).strip().split(" ")),
                        header.group(2),
                        header.group(3),
                        new ArrayList<>());
                classes.add(current);
            } else if (!code.equals("}")) {
                current.members().add(member(code));
            }
        }
        return new ProgrammingInterface(classes);
    }

    private static Member member(String code) {
        Matcher method = METHOD_LINE.matcher(code);
        if (method.matches()) {
            List<String> words = splitOutsideBrackets(method.group(1), ' ');
            return new Member(words, last(words), method.group(2), splitOutsideBrackets(method.group(3), ','), null);
        }
        Matcher field = FIELD_LINE.matcher(code);
        if (!field.matches()) {
            throw new IllegalArgumentException("not a member: " + code);
        }
        List<String> words = splitOutsideBrackets(field.group(1), ' ');
        return new Member(words, last(words), field.group(2), null, field.group(3));
    }

    /** The type is the last word in front of the name, unless that is a modifier: then it is a constructor. */
    private static String last(List<String> words) {
        String word = words.get(words.size() - 1);
        return word.equals("public") || word.equals("protected") ? "" : word;
    }

    private static List<String> splitOutsideBrackets(String text, char separator) {
        List<String> parts = new ArrayList<>();
        int depth = 0;
        StringBuilder part = new StringBuilder();
        for (char letter : (text + separator).toCharArray()) {
            depth += letter == '<' ? 1 : letter == '>' ? -1 : 0;
            if (letter == separator && depth == 0) {
                if (!part.toString().isBlank()) {
                    parts.add(part.toString().strip());
                }
                part.setLength(0);
            } else {
                part.append(letter);
            }
        }
        return parts;
    }
}
