package mmneat.experiment.cluster;

import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Quotes words for a POSIX shell. */
public final class ShellWord {

    private static final Pattern PLAIN = Pattern.compile("[A-Za-z0-9_@%+=:,./-]+");

    private ShellWord() {}

    /**
     * Returns the word, in single quotes if it has special characters.
     *
     * <p>A backslash is put outside of the quotes. Only there do POSIX shells, fish and Slurm's {@code #SBATCH} lines
     * read it in the same way.
     */
    static String quote(String word) {
        return PLAIN.matcher(word).matches() ? word : "'" + word.replaceAll("[\\\\']", "'\\\\$0'") + "'";
    }

    /** Returns a command line of quoted words. */
    public static String line(List<String> words) {
        return words.stream().map(ShellWord::quote).collect(Collectors.joining(" "));
    }
}
