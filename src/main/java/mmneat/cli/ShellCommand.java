package mmneat.cli;

import java.io.File;
import java.util.ArrayList;
import java.util.List;
import mmneat.experiment.cluster.ShellWord;

/**
 * Command lines of this program in messages, which the user can copy into a shell. They start like the user's command:
 * with the script or with java. The word CLASSPATH stands for a class path that is too long to be read.
 */
final class ShellCommand {

    /** System property that the script sets to its own name when it calls the jar. */
    private static final String SCRIPT = "mmneat.command";

    /** Longest class path that is printed; those of build tools have thousands of letters. */
    private static final int LONGEST_CLASS_PATH = 200;

    private ShellCommand() {}

    /** Returns a command line of this program. */
    static String command(String... words) {
        return line(System.getProperty(SCRIPT, ""), System.getProperty("java.class.path"), List.of(words));
    }

    /**
     * Returns a command line of this program.
     *
     * @param script name of the script that started this program; empty if there is none
     * @param classPath class path of this process; only the jar if it was started with {@code java -jar}
     */
    static String line(String script, String classPath, List<String> words) {
        List<String> line = new ArrayList<>();
        if (!script.isEmpty()) {
            line.add(script);
        } else if (classPath.endsWith(".jar") && !classPath.contains(File.pathSeparator)) {
            line.addAll(List.of("java", "-jar", classPath));
        } else {
            String shown = classPath.length() > LONGEST_CLASS_PATH ? "CLASSPATH" : classPath;
            line.addAll(List.of("java", "-cp", shown, Main.class.getName()));
        }
        line.addAll(words);
        return ShellWord.line(line);
    }
}
