package mmneat.cli;

import java.io.File;
import java.util.ArrayList;
import java.util.List;
import mmneat.experiment.cluster.ShellWord;

/**
 * Command lines of this program for messages, to be copied into a shell. They begin as the user began: with the script, or with
 * java.
 */
final class ShellCommand {

    /** Set by the script that calls the jar, to its own name. */
    private static final String SCRIPT = "mmneat.command";

    private ShellCommand() {}

    /** A command line to be copied into a shell. */
    static String command(String... words) {
        return line(System.getProperty(SCRIPT, ""), System.getProperty("java.class.path"), List.of(words));
    }

    /**
     * A command line to be copied into a shell.
     *
     * @param script that this program was called by; empty if there is none
     * @param classPath of this process; just the jar if it was called with {@code java -jar}
     */
    static String line(String script, String classPath, List<String> words) {
        List<String> line = new ArrayList<>();
        if (!script.isEmpty()) {
            line.add(script);
        } else if (classPath.endsWith(".jar") && !classPath.contains(File.pathSeparator)) {
            line.addAll(List.of("java", "-jar", classPath));
        } else {
            line.addAll(List.of("java", "-cp", classPath, Main.class.getName()));
        }
        line.addAll(words);
        return ShellWord.line(line);
    }
}
