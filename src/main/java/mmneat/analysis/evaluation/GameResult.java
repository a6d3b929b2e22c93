package mmneat.analysis.evaluation;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.ModuleUse;

/**
 * One game of an evaluation (in the isolated version one trial of five games).
 *
 * @param number from 0
 * @param seed of the game's generator: {@code watch seed=...} shows this game
 * @param score points
 * @param ghosts the ghost objective
 * @param pills the pill objective
 * @param levels levels finished
 * @param steps time steps
 * @param end why it ended; in the isolated version, why the pill game did
 * @param maze index of the maze in which it ended
 * @param moduleUse how often each module decided, for each observation of {@link ModuleUse.When}
 */
public record GameResult(
        int number,
        long seed,
        double score,
        double ghosts,
        double pills,
        int levels,
        long steps,
        GameEnd end,
        int maze,
        List<long[]> moduleUse) {

    static final String HEADER = "game,seed,score,ghosts,pills,levels,steps,end,maze,"
            + Arrays.stream(ModuleUse.When.values())
                    .map(when -> "modules "
                            + when.name().toLowerCase(java.util.Locale.ROOT).replace('_', ' '))
                    .collect(Collectors.joining(","));

    /** The game as a line of CSV; counts of modules are separated by blanks. */
    String line() {
        return number + "," + seed + "," + number(score) + "," + number(ghosts) + "," + number(pills) + "," + levels
                + ","
                + steps + "," + end + "," + "ABCD".charAt(maze) + ","
                + moduleUse.stream().map(GameResult::counts).collect(Collectors.joining(","));
    }

    private static String number(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }

    private static String counts(long[] counts) {
        return Arrays.stream(counts).mapToObj(Long::toString).collect(Collectors.joining(" "));
    }

    /**
     * Reads a line that {@link #line} wrote.
     *
     * @throws IllegalArgumentException if it is not one
     */
    static GameResult parse(String line) {
        String[] fields = line.split(",", -1);
        int first = fields.length - ModuleUse.When.values().length;
        if (first != 9) {
            throw new IllegalArgumentException("not the line of a game: " + line);
        }
        return new GameResult(
                Integer.parseInt(fields[0]),
                Long.parseLong(fields[1]),
                Double.parseDouble(fields[2]),
                Double.parseDouble(fields[3]),
                Double.parseDouble(fields[4]),
                Integer.parseInt(fields[5]),
                Long.parseLong(fields[6]),
                GameEnd.valueOf(fields[7]),
                "ABCD".indexOf(fields[8]),
                Arrays.stream(fields, first, fields.length)
                        .map(counts -> Arrays.stream(counts.split(" "))
                                .mapToLong(Long::parseLong)
                                .toArray())
                        .toList());
    }
}
