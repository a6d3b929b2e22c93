package mmneat.analysis.evaluation;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.ModuleUse;

/**
 * The result of one trial of an evaluation. A trial is one game, except in the isolated version: there it is a set of
 * five games that are scored together, one game of eating pills without power pills (the pill game) and four games of
 * eating ghosts, one from the place of each power pill.
 *
 * @param number number of the trial, from 0
 * @param seed of the game's generator: {@code watch seed=...} shows this game
 * @param score points
 * @param ghosts the ghost objective
 * @param pills the pill objective
 * @param levels levels finished
 * @param steps time steps
 * @param end why the game ended; in the isolated version, why the pill game, the first of the five, ended
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

    /** Columns before those of the modules. */
    private static final String GAME_COLUMNS = "game,seed,score,ghosts,pills,levels,steps,end,maze";

    private static final int GAME_COLUMN_COUNT = GAME_COLUMNS.split(",").length;

    /**
     * The header line of a table of games.
     *
     * @param modules of the network that plays
     */
    static String header(int modules) {
        String counts = Arrays.stream(ModuleUse.When.values())
                .flatMap(when -> IntStream.range(0, modules)
                        .mapToObj(module -> when.name().toLowerCase(Locale.ROOT) + "_module_" + (module + 1)))
                .collect(Collectors.joining(","));
        return GAME_COLUMNS + "," + counts + ",evaluation";
    }

    /**
     * The game as a line of CSV.
     *
     * @param evaluation says of which network and settings the game is; without commas
     */
    String line(String evaluation) {
        return number + "," + seed + "," + number(score) + "," + number(ghosts) + "," + number(pills) + "," + levels
                + ","
                + steps + "," + end + "," + "ABCD".charAt(maze) + ","
                + moduleUse.stream()
                        .flatMapToLong(Arrays::stream)
                        .mapToObj(Long::toString)
                        .collect(Collectors.joining(","))
                + "," + evaluation;
    }

    private static String number(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }

    /**
     * Reads a line that {@link #line} made.
     *
     * @throws IllegalArgumentException if it is not one
     */
    static GameResult parse(String line) {
        String[] fields = line.split(",", -1);
        int situations = ModuleUse.When.values().length;
        int counts = fields.length - GAME_COLUMN_COUNT - 1;
        if (counts < situations || counts % situations != 0) {
            throw new IllegalArgumentException("not the line of a game: " + line);
        }
        int modules = counts / situations;
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
                IntStream.range(0, situations)
                        .mapToObj(situation -> Arrays.stream(fields)
                                .skip(GAME_COLUMN_COUNT + (long) situation * modules)
                                .limit(modules)
                                .mapToLong(Long::parseLong)
                                .toArray())
                        .toList());
    }
}
