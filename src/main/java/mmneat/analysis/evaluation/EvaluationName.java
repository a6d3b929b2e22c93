package mmneat.analysis.evaluation;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import mmneat.random.ResumableRandom;

/**
 * The games of an evaluation: which network plays which version of the task by which rules, and the seed. Two
 * evaluations with the same name have the same games. It is the last column of a table of games.
 *
 * @param network id and fingerprint of the network, for example {@code network 7 (2da53060)}
 * @param version label of the version of the task
 * @param rules label of the {@link Rules}
 * @param seed from which the seeds of the games are drawn
 * @param ghostLocations fingerprint of the recorded ghost locations, in hexadecimal digits; empty in the versions that
 *     have none
 */
record EvaluationName(String network, String version, String rules, long seed, String ghostLocations) {

    private static final Pattern TEXT =
            Pattern.compile("(network \\d{1,19} \\([0-9a-f]{1,8}\\)); ([a-z]+) task; (\\w+) rules; seed (-?\\d{1,19})"
                    + "(?:; ghost locations ([0-9a-f]{1,8}))?");

    /**
     * Reads a text that {@link #text} made.
     *
     * @throws IllegalArgumentException if it is another text
     */
    static EvaluationName of(String text) {
        Matcher matcher = TEXT.matcher(text);
        if (!matcher.matches()) {
            throw new IllegalArgumentException("it names no network, task, rules and seed");
        }
        String locations = matcher.group(5);
        return new EvaluationName(
                matcher.group(1),
                matcher.group(2),
                matcher.group(3),
                Long.parseLong(matcher.group(4)),
                locations == null ? "" : locations);
    }

    /** The name as one text without commas. */
    String text() {
        return network + "; " + version + " task; " + rules + " rules; seed " + seed
                + (ghostLocations.isEmpty() ? "" : "; ghost locations " + ghostLocations);
    }

    /** The seeds of the first games: the seed of game n is the n-th draw from a generator with {@link #seed}. */
    long[] seeds(int games) {
        ResumableRandom random = new ResumableRandom(seed);
        long[] seeds = new long[games];
        for (int game = 0; game < games; game++) {
            seeds[game] = random.nextLong();
        }
        return seeds;
    }
}
