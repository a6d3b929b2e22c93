package mmneat.analysis.results;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Evaluations in a run's folder that were changed by hand. */
class EvaluationReadingTest {

    private static final String WHOLE = """
            {"network":0,"rules":"training","games":10,"meanScore":100.5,"standardDeviation":3.0,"low":98.0,"high":103.0,\
            "moduleUse":[[5,6],[1,2],[0,0],[5,6],[0,0],[1,2]],"deathsByMaze":[1,2,0,0]}""";

    @TempDir
    Path base;

    private Path file;

    @BeforeEach
    void run() throws IOException {
        file = RunFixture.run(base, "blended", "2M", 0, 1, 2).resolve("evaluation-training.json");
    }

    private ChampionEvaluation read(String json) throws IOException {
        Files.writeString(file, json);
        return ExperimentFinder.find(List.of(base.resolve("blended")))
                .get(0)
                .runs()
                .get(0)
                .evaluation()
                .orElseThrow();
    }

    @Test
    void wholeOne_isRead() throws IOException {
        assertThat(read(WHOLE).high()).isEqualTo(103);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "\"games\":10|\"games\":0",
                "\"games\":10|\"games\":10,\"extra\":1",
                "\"training\"|\"FourMaze\"",
                "\"training\"|\"x\"",
                "\"games\":10|\"games\":-3",
                "\"games\":10|\"games\":2.5",
                "\"games\":10|\"games\":null",
                "\"games\":10|\"games\":\"10\"",
                "\"games\":10|\"games\":10,\"games\":11",
                "\"games\":10|\"games\":2",
                "\"games\":10,|''",
                "\"games\":10|\"games\":10,\"seed\":\"x\"",
                "\"games\":10|\"games\":10,\"seed\":2.5",
                "3.0|-1",
                "100.5|-1e-3",
                "100.5|1e308",
                "3.0|null",
                "3.0|1e999",
                "3.0|\"NaN\"",
                "98.0|104.0",
                "98.0|null",
                "98.0|-1e999",
                "103.0|99.0",
                "100.5|\"100.5\"",
                "100.5|\"much\"",
                "100.5|1e999",
                "100.5|null",
                "100.5|[]",
                "\"training\"|null",
                "[5,6],[1,2],|[5,6],[1,2,3],",
                "[5,6],[1,2],|[5,-6],[1,2],",
                "[5,6],[1,2],|null,[1,2],",
                "[[5,6],[1,2],[0,0],[5,6],[0,0],[1,2]]|[]",
                "[[5,6],[1,2],[0,0],[5,6],[0,0],[1,2]]|null",
                "[1,2,0,0]|[1,2,0]",
                "[1,2,0,0]|[1,-2,0,0]",
                "[1,2,0,0]|[9,2,0,0]",
                "[1,2,0,0]|null"
            })
    void impossibleNumbers_areRefused(String whole, String changed) {
        assertThat(WHOLE).contains(whole);
        assertThatThrownBy(() -> read(WHOLE.replace(whole, changed)))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith(file + ": is damaged (")
                .hasMessageEndingWith("; remove it and run evaluate again")
                .satisfies(e -> assertThat(e.getMessage().lines()).hasSize(1))
                .satisfies(e -> assertThat(e.getMessage()).doesNotContain("`", "mmneat.", "Feature"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"null", "", "[]", "{}", "1"})
    void textsThatAreNoEvaluation_areRefused(String text) {
        assertThatThrownBy(() -> read(text)).isInstanceOf(UserError.class).hasMessageContaining("is damaged (");
    }

    @Test
    void oneGame_hasNoDeviation_evenIfAnEarlierProgramWroteZero() throws IOException {
        String zeros = WHOLE.replace("10,", "1,")
                .replace(":3.0", ":0.0")
                .replace("98.0", "100.5")
                .replace("103.0", "100.5")
                .replace("[1,2,0,0]", "[1,0,0,0]");
        String nulls = WHOLE.replace("10,", "1,")
                .replace(":3.0", ":null")
                .replace("98.0", "null")
                .replace("103.0", "null")
                .replace("[1,2,0,0]", "[1,0,0,0]");
        for (String json : List.of(zeros, nulls)) {
            ChampionEvaluation evaluation = read(json);
            assertThat(evaluation.standardDeviation()).isNull();
            assertThat(evaluation.low()).isNull();
            assertThat(evaluation.high()).isNull();
        }
    }
}
