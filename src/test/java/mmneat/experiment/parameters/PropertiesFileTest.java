package mmneat.experiment.parameters;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.TreeMap;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PropertiesFileTest {

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "task=blended|task|blended",
                "'task=blended  \t'|task|blended",
                "'  task\t= blended'|task|blended",
                "task:blended|task|blended",
                "task blended|task|blended",
                "base=C:\\users\\me|base|C:\\users\\me",
                "base=win\\results\\new|base|win\\results\\new",
                "base=C:\\u0041\\t|base|C:\\u0041\\t",
                "base:C:\\x=y|base|C:\\x=y",
                "'base=ends\\ '|base|ends\\",
                "base=two\\\\|base|two\\\\",
                "saveTo=#1!|saveTo|#1!",
                "saveTo=|saveTo|''",
                "saveTo|saveTo|''",
                "saveTo=M\u00fchle \u732b|saveTo|M\u00fchle \u732b"
            })
    void line_isANameAndATrimmedValue_withLiteralBackslashes(String line, String name, String value) {
        for (String text :
                new String[] {line, line + "\n", "\ufeff# comment\r\n\r\n  ! comment\\\r\n" + line + "\r\n"}) {
            assertThat(PropertiesFile.read(text)).as(text).containsExactly(Map.entry(name, value));
        }
    }

    @Test
    void singleBackslashAtTheEndOfALine_joinsTheNext() {
        assertThat(PropertiesFile.read("ownSensors=my.One,\\\n    my.Two\\\n\nmu=3\\"))
                .containsExactlyInAnyOrderEntriesOf(Map.of("ownSensors", "my.One,my.Two", "mu", "3"));
    }

    @Test
    void nameThatIsGivenTwice_isRefused() {
        assertThatThrownBy(() -> PropertiesFile.read("mu=3\nmu = 4"))
                .isInstanceOf(UserError.class)
                .hasMessage("'mu' is given twice; give it once");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "a b",
                "C:\\",
                "C:\\users\\me",
                "two\\\\",
                "a=b:c",
                "#x",
                "\\u0041",
                "M\u00fchle \ud83d\ude00"
            })
    void writtenValues_areReadBack(String value) {
        Map<String, String> values = new TreeMap<>(Map.of("base", value, "mu", "3"));
        assertThat(PropertiesFile.read(PropertiesFile.write(values, "comment"))).isEqualTo(values);
    }
}
