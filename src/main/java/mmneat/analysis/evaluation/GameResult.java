package mmneat.analysis.evaluation;

import java.math.BigInteger;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import mmneat.analysis.results.ChampionEvaluation;
import mmneat.experiment.PlainText;
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

    private static final String MAZES = "ABCD";

    /** Upper limit of the steps and levels of a game, far above those of the longest games. */
    private static final int HIGHEST_COUNT = 1_000_000_000;

    private static final Pattern WHOLE = Pattern.compile("0|-?[1-9][0-9]{0,18}");
    private static final Pattern NUMBER = Pattern.compile("-?[0-9]{1,19}(\\.[0-9]{1,19})?(E-?[0-9]{1,3})?");
    private static final int LONGEST_SHOWN = 60;

    /**
     * The header line of a table of games.
     *
     * @param modules of the network that plays
     */
    static String header(int modules) {
        String counts = Arrays.stream(ModuleUse.When.values())
                .flatMap(when -> IntStream.range(0, modules).mapToObj(module -> column(when, module)))
                .collect(Collectors.joining(","));
        return GAME_COLUMNS + "," + counts + ",evaluation";
    }

    /** Whether a text without a line end can be the beginning of a header. */
    static boolean canBeginHeader(String text) {
        return GAME_COLUMNS.startsWith(text) || text.startsWith(GAME_COLUMNS) && text.indexOf('\r') < 0;
    }

    private static String column(ModuleUse.When when, int module) {
        return when.name().toLowerCase(Locale.ROOT) + "_module_" + (module + 1);
    }

    /**
     * The game as a line of CSV.
     *
     * @param evaluation says of which network and settings the game is; without commas
     */
    String line(String evaluation) {
        return number + "," + seed + "," + number(score) + "," + number(ghosts) + "," + number(pills) + "," + levels
                + ","
                + steps + "," + end + "," + MAZES.charAt(maze) + ","
                + moduleUse.stream()
                        .flatMapToLong(Arrays::stream)
                        .mapToObj(Long::toString)
                        .collect(Collectors.joining(","))
                + "," + evaluation;
    }

    private static String number(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : Double.toString(value);
    }

    /** The number of modules of a table with this many columns; 0 if no table has as many. */
    static int modules(int columns) {
        int counts = columns - GAME_COLUMN_COUNT - 1;
        int situations = ModuleUse.When.values().length;
        return counts > 0 && counts % situations == 0 ? counts / situations : 0;
    }

    /**
     * Reads a line that {@link #line} made. The last column is not checked.
     *
     * @param columns the names of the columns of its table, those of the {@link #header}
     * @throws IllegalArgumentException if it is another line or a value is impossible; the message names the column and
     *     the value
     */
    static GameResult parse(String line, String[] columns) {
        String[] cells = line.split(",", -1);
        int modules = modules(columns.length);
        if (cells.length != columns.length) {
            throw new IllegalArgumentException(
                    "must have " + columns.length + " columns, has " + cells.length + ": '" + shown(line) + "'");
        }
        int number = (int) whole("game", cells[0], 0, Integer.MAX_VALUE);
        long seed = whole("seed", cells[1], Long.MIN_VALUE, Long.MAX_VALUE);
        long steps = whole("steps", cells[6], 0, HIGHEST_COUNT);
        List<long[]> use = new ArrayList<>();
        for (int first = GAME_COLUMN_COUNT; first < cells.length - 1; first += modules) {
            long[] counts = new long[modules];
            for (int module = 0; module < modules; module++) {
                counts[module] = whole(columns[first + module], cells[first + module], 0, steps);
            }
            use.add(counts);
        }
        requireSums(use, steps, columns);
        return new GameResult(
                number,
                seed,
                number("score", cells[2], 0),
                number("ghosts", cells[3], -ChampionEvaluation.HIGHEST_SCORE),
                number("pills", cells[4], -ChampionEvaluation.HIGHEST_SCORE),
                (int) whole("levels", cells[5], 0, HIGHEST_COUNT),
                steps,
                end(cells[7]),
                maze(cells[8]),
                use);
    }

    /** Checks that the module counts of the situations add up to those of all steps, and these to the steps at most. */
    private static void requireSums(List<long[]> use, long steps, String[] columns) {
        long[] all = use.get(ModuleUse.When.ALL.ordinal());
        long sum = Arrays.stream(all).sum();
        require(sum <= steps, columns[GAME_COLUMN_COUNT] + " and the following", sum, "be at most the steps, " + steps);
        for (int module = 0; module < all.length; module++) {
            requireSum(use, module, ModuleUse.When.ALL, ModuleUse.When.EDIBLE, ModuleUse.When.THREAT);
            requireSum(
                    use,
                    module,
                    ModuleUse.When.AT_JUNCTION,
                    ModuleUse.When.EDIBLE_AT_JUNCTION,
                    ModuleUse.When.THREAT_AT_JUNCTION);
        }
    }

    private static void requireSum(
            List<long[]> use, int module, ModuleUse.When whole, ModuleUse.When part, ModuleUse.When other) {
        long found = use.get(whole.ordinal())[module];
        long sum = use.get(part.ordinal())[module] + use.get(other.ordinal())[module];
        require(
                found == sum,
                column(whole, module),
                found,
                "be the sum of " + column(part, module) + " and " + column(other, module) + ", " + sum);
    }

    private static long whole(String column, String cell, long lowest, long highest) {
        boolean isWhole = WHOLE.matcher(cell).matches();
        BigInteger value = isWhole ? new BigInteger(cell) : BigInteger.ZERO;
        boolean isInRange = isWhole
                && value.compareTo(BigInteger.valueOf(lowest)) >= 0
                && value.compareTo(BigInteger.valueOf(highest)) <= 0;
        require(isInRange, column, cell, "be a whole number from " + lowest + " to " + highest);
        return value.longValue();
    }

    private static double number(String column, String cell, double lowest) {
        double value = NUMBER.matcher(cell).matches() ? Double.parseDouble(cell) : Double.NaN;
        require(
                value >= lowest && value <= ChampionEvaluation.HIGHEST_SCORE,
                column,
                cell,
                "be a number from " + number(lowest) + " to " + number(ChampionEvaluation.HIGHEST_SCORE));
        return value;
    }

    private static GameEnd end(String cell) {
        List<String> ends = Arrays.stream(GameEnd.values()).map(GameEnd::name).toList();
        require(ends.contains(cell), "end", cell, "be one of " + String.join(", ", ends));
        return GameEnd.valueOf(cell);
    }

    private static int maze(String cell) {
        require(cell.length() == 1 && MAZES.contains(cell), "maze", cell, "be one of A, B, C, D");
        return MAZES.indexOf(cell);
    }

    /**
     * Checks a value of a table.
     *
     * @throws IllegalArgumentException if it is impossible, for example "column steps: '-1' must be a whole number"
     */
    static void require(boolean isPossible, String column, Object value, String must) {
        if (!isPossible) {
            throw new IllegalArgumentException(
                    "column " + column + ": '" + shown(String.valueOf(value)) + "' must " + must);
        }
    }

    /** The beginning of a text on one line. */
    private static String shown(String text) {
        return PlainText.shown(text.length() > LONGEST_SHOWN ? text.substring(0, LONGEST_SHOWN) + "..." : text);
    }
}
