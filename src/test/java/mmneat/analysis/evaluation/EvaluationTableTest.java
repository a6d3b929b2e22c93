package mmneat.analysis.evaluation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import mmneat.experiment.UserError;
import mmneat.mspacman.GameEnd;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tables of games that were damaged or changed by hand. */
class EvaluationTableTest {

    private static final Path FILE = Path.of("evaluation-training.csv");
    private static final EvaluationName NAME =
            new EvaluationName("network 7 (2da53060)", "blended", "training", 11, "");
    private static final int GAMES = 6;

    private static List<String> lines() {
        List<String> lines = new ArrayList<>(List.of(GameResult.header(2)));
        for (int game = 0; game < GAMES; game++) {
            lines.add(game(game).line(NAME.text()));
        }
        return lines;
    }

    private static GameResult game(int number) {
        List<long[]> use = List.of(
                new long[] {117, 31},
                new long[] {21, 8},
                new long[] {100, 11},
                new long[] {17, 20},
                new long[] {20, 2},
                new long[] {1, 6});
        long seed = NAME.seeds(GAMES)[number];
        return new GameResult(number, seed, 2000.5, 3, 200, 1, 148, GameEnd.LOST_ALL_LIVES, 1, use);
    }

    private static String text(List<String> lines) {
        return String.join("\n", lines) + "\n";
    }

    private static EvaluationTable read(String text) {
        return EvaluationTable.parse(FILE, text).orElseThrow();
    }

    @Test
    void wholeTable_isRead() {
        EvaluationTable table = read(text(lines()));
        assertThat(table.evaluation()).isEqualTo(NAME);
        assertThat(table.modules()).isEqualTo(2);
        assertThat(table.games()).hasSize(GAMES);
        assertThat(table.games().get(5)).usingRecursiveComparison().isEqualTo(game(5));
    }

    @ParameterizedTest
    @CsvSource({
        "game,7",
        "game,-1",
        "game,x",
        "game,3.0",
        "game,03",
        "game,99999999999",
        "seed,0",
        "seed,1e3",
        "score,NaN",
        "score,Infinity",
        "score,-Infinity",
        "score,1e308",
        "score,1E308",
        "score,-5",
        "score,x",
        "score,''",
        "score,0x1p3",
        "score,5d",
        "score,' 5'",
        "ghosts,NaN",
        "ghosts,1E99",
        "pills,-Infinity",
        "pills,-1E99",
        "levels,-1",
        "levels,2.5",
        "levels,9999999999",
        "steps,-148",
        "steps,147",
        "steps,99999999999999999999",
        "steps,١٤٨",
        "end,lost",
        "end,''",
        "end,lost_all_lives",
        "maze,Z",
        "maze,a",
        "maze,''",
        "maze,AB",
        "maze,0",
        "all_module_1,-1",
        "all_module_1,116",
        "all_module_2,9223372036854775807",
        "at_junction_module_2,9",
        "edible_module_1,NaN",
        "threat_at_junction_module_2,-6",
        "evaluation,network 8 (2da53060); blended task; training rules; seed 11",
        "evaluation,''"
    })
    void impossibleValue_isRefused_withLineColumnAndValue(String column, String value) {
        List<String> lines = lines();
        String[] cells = lines.get(4).split(",", -1);
        cells[Arrays.asList(GameResult.header(2).split(",")).indexOf(column)] = value;
        lines.set(4, String.join(",", cells));
        assertRefused(text(lines), 5, "column ");
        if (!column.equals("steps") && !column.startsWith("edible") && !column.startsWith("threat")) {
            assertRefused(text(lines), 5, "column " + column + ": '" + value + "' must be ");
        }
    }

    private static void assertRefused(String text, int line, String problem) {
        assertThatThrownBy(() -> read(text))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith(FILE + ", line " + line + ": " + problem)
                .hasMessageEndingWith("; delete the file to evaluate again")
                .satisfies(e -> assertThat(e.getMessage().lines()).hasSize(1))
                .satisfies(e -> assertThat(e.getMessage()).doesNotContain("mmneat.", "java"));
    }

    @Test
    void linesThatAreNoGames_areRefused() {
        assertRefused(text(lines()) + "5,x\n", 8, "must have 22 columns, has 2: '5,x'");
        assertRefused(text(lines()) + "\n", 8, "must have 22 columns, has 1");
        assertRefused(text(lines()) + text(lines()), 8, "column game: 'game' must be a whole number");
        assertRefused(text(lines()) + "x".repeat(100) + "\u001b\n", 8, "must have 22 columns, has 1");
        List<String> doubled = lines();
        doubled.add(3, doubled.get(2));
        assertRefused(text(doubled), 4, "column game: '1' must be 2, as games are in order");
        List<String> withoutLine = lines();
        withoutLine.remove(3);
        assertRefused(text(withoutLine), 4, "column game: '3' must be 2, as games are in order");
    }

    @Test
    void textWithoutLineEnds_isRefused_unlessItBeginsAHeader() {
        assertRefused("x", 1, "it is not the header of a table of games");
        assertRefused(text(lines()).replace('\n', '\r'), 1, "it is not the header of a table of games");
        assertThat(EvaluationTable.parse(FILE, "game,se")).isEmpty();
        assertThat(EvaluationTable.parse(FILE, GameResult.header(3))).isEmpty();
        assertThat(read(text(lines()).replace("\n", "\r\n")).games()).hasSize(GAMES);
    }

    @ParameterizedTest
    @ValueSource(strings = {"x\n", "\n", "game,seed\n", "0,1,2\n1,2,3\n"})
    void anotherFirstLine_isNoTable(String text) {
        assertRefused(text, 1, "it is not the header of a table of games");
        assertRefused(text + text(lines()), 1, "it is not the header of a table of games");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "x",
                "network 7 (2da53060); blended task; training rules; seed 99999999999999999999",
                "network 7 (2da53060); blended task; training rules; seed 9999999999999999999",
                "network 7 (2da53060); blended task; training rules; seed"
            })
    void firstGameThatNamesNoEvaluation_isRefused(String name) {
        assertRefused(text(lines()).replace(NAME.text(), name), 2, "column evaluation: '" + name + "'");
    }

    @Test
    void incompleteLastLine_isDropped() {
        String whole = text(lines());
        assertThat(read(whole.substring(0, whole.length() - 1)).games()).hasSize(GAMES - 1);
        assertThat(read(whole + "6,12").games()).hasSize(GAMES);
        assertThat(EvaluationTable.parse(FILE, GameResult.header(2).substring(0, 20)))
                .isEmpty();
        assertThat(EvaluationTable.parse(FILE, "")).isEmpty();
        assertThat(EvaluationTable.parse(FILE, GameResult.header(2) + "\n0,1")).isEmpty();
    }

    @Test
    void nameOfIsolatedGames_includesTheGhostLocations() {
        EvaluationName isolated = new EvaluationName("network 7 (a)", "isolated", "MPMvsG", -3, "ff00");
        assertThat(EvaluationName.of(isolated.text())).isEqualTo(isolated);
    }
}
