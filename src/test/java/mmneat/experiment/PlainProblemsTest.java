package mmneat.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.databind.JsonNode;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.util.List;
import mmneat.neat.io.StrictJson;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Messages about files, which are for users: no Java classes and no settings of libraries. */
class PlainProblemsTest {

    record Sample(int games, List<long[]> uses, String name) {}

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "{\n",
                "{",
                "[",
                "{\"games\"",
                "{\"games\":",
                "{\"games\":1",
                "{\"games\":1,",
                "{\"name\":\"a",
                "{\"name\":\"a\nb\"}",
                "{\"name\":\"\\x\"}",
                "{games:1}",
                "{\"games\":01}",
                "{\"games\":1.}",
                "{\"games\":NaN}",
                "{\"games\":1}}",
                "{\"games\":1,\"games\":2}",
                "{\"games\":1,\"uses\":[[1,x]]}",
                "{\"games\":[1]}",
                "{\"games\":9999999999}",
                "{\"other\":1}",
                "nul",
                "/* remark */ {}",
                "\u0000",
                "\uFEFF{",
                "x"
            })
    void damagedJson_isExplainedInPlainText(String json) {
        for (Class<?> type : List.of(Sample.class, JsonNode.class)) {
            JacksonException problem = catchThrowableOfType(
                    JacksonException.class, () -> StrictJson.mapper().build().readValue(json, type));
            if (problem != null) {
                assertPlain(JsonProblem.of(problem));
            }
        }
    }

    private static void assertPlain(String text) {
        assertThat(text)
                .isNotBlank()
                .hasLineCount(1)
                .doesNotContain("`", "Source", "Feature", "REDACTED", "fasterxml", "java", "Sample", "mmneat");
    }

    @Test
    void deepAndLongJson_isExplainedInPlainText() {
        for (String json : List.of("[".repeat(5000), "{\"games\":" + "1".repeat(5000) + "}")) {
            JacksonException problem = catchThrowableOfType(
                    JacksonException.class, () -> StrictJson.mapper().build().readValue(json, JsonNode.class));
            assertPlain(JsonProblem.of(problem));
        }
    }

    @Test
    void unfinishedAndEmptyJson_areTold() {
        assertThat(problem("{\n")).isEqualTo("the file ends too early");
        assertThat(problem("")).isEqualTo("the file is empty");
    }

    private static String problem(String json) {
        return JsonProblem.of(catchThrowableOfType(
                JacksonException.class, () -> StrictJson.mapper().build().readValue(json, Sample.class)));
    }

    @ParameterizedTest
    @CsvSource({
        "/a/champion.json (Permission denied), permission denied",
        "/a/champion.json (No such file or directory), there is no such file",
        "/a (b)/champion.json (Is a directory), it is a folder; name a file in it",
        "/a/champion.json (Too many open files), Too many open files",
        "/a/champion.json, there is no such file"
    })
    void messagesOfOlderFileExceptions_areReasons(String message, String reason) {
        assertThat(FileErrors.reason(new FileNotFoundException(message))).isEqualTo(reason);
    }

    @Test
    void refusedAccess_isThePlainReason() {
        assertThat(FileErrors.reason(new AccessDeniedException("a"))).isEqualTo("permission denied");
        assertThat(FileErrors.reason(new IOException("Permission denied"))).isEqualTo("permission denied");
    }
}
