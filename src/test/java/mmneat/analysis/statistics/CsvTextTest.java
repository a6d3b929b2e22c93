package mmneat.analysis.statistics;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CsvTextTest {

    private static String cell(Object value) {
        String text = new CsvText("name").row(value).text();
        return text.substring("name\n".length(), text.length() - 1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"=cmd|calc", "+cmd", "-cmd", "@SUM(A1)", "-1+cmd", " =1+1", "--1", "=1", "+", "-"})
    void textsThatSpreadsheetsRun_startWithAnApostrophe(String text) {
        assertThat(cell(text).replace("\"", "")).isEqualTo("'" + text);
    }

    @Test
    void textsThatBeginWithControlCharacters_startWithAnApostrophe() {
        assertThat(cell("\t=1")).isEqualTo("\"'\t=1\"");
        assertThat(cell("\r=1")).isEqualTo("\"'\r=1\"");
        assertThat(cell("\t")).contains("'");
    }

    @ParameterizedTest
    @ValueSource(strings = {"2M", "-5", "+5", "-1.5E-7", "1M; 2M", "df=1", "a-b", "'", "", "2M (paper)"})
    void otherTextsAndNumbers_stayAsTheyAre(String text) {
        assertThat(cell(text).replace("\"", "")).isEqualTo(text);
    }

    @Test
    void numbers_areWrittenInFull_andHeadersAreCellsToo() {
        assertThat(cell(-0.1)).isEqualTo("-0.1");
        assertThat(cell(Double.NEGATIVE_INFINITY)).isEqualTo("-Infinity");
        assertThat(new CsvText("=a", "b").row("x,\"y\"", 1).text()).isEqualTo("\"'=a\",b\n\"x,\"\"y\"\"\",1\n");
    }
}
