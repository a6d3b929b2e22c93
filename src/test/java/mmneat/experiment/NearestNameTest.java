package mmneat.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Typing errors are recognised; other names are not taken for typing errors. */
class NearestNameTest {

    private static final List<String> KNOWN = List.of("a", "mu", "maxGens", "startingModes", "trials");

    @ParameterizedTest
    @CsvSource({
        "maxgens, maxGens",
        "maxGen, maxGens",
        "mxaGens, maxGens",
        "startingModules, startingModes",
        "nu, mu",
        "A, a"
    })
    void slips_areRecognised(String typed, String meant) {
        assertThat(NearestName.to(typed, KNOWN)).contains(meant);
        assertThat(NearestName.suggestion(typed, KNOWN)).isEqualTo(" (did you mean '" + meant + "'?)");
    }

    @ParameterizedTest
    @CsvSource({"e", "xy", "population", "games"})
    void otherNames_areNotRecognised(String typed) {
        assertThat(NearestName.to(typed, KNOWN)).isEmpty();
        assertThat(NearestName.suggestion(typed, KNOWN)).isEmpty();
    }
}
