package mmneat.experiment.cluster;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Words as a POSIX shell reads them back. */
public final class ShellWord {

    private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9_@%+=:,./-]+");

    private ShellWord() {}

    /**
     * The word itself, or in single quotes if the shell would see anything special in it.
     *
     * <p>A backslash stands outside of the quotes: there, POSIX shells, fish and Slurm's own {@code #SBATCH} lines agree on it.
     */
    static String quote(String word) {
        return PLAIN.matcher(word).matches() ? word : "'" + word.replaceAll("[\\\\']", "'\\\\$0'") + "'";
    }

    /** A command line of quoted words. */
    public static String line(List<String> words) {
        return words.stream().map(ShellWord::quote).collect(Collectors.joining(" "));
    }
}
