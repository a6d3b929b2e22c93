package mmneat.analysis.statistics;

import com.fasterxml.jackson.databind.ObjectWriter;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Pattern;

/**
 * A table as CSV (RFC 4180, lines end with a line feed): a header line, then one line per row.
 *
 * <p>Spreadsheet programs run a text that begins like a formula. So a text gets an apostrophe in front if its first
 * character is one of {@code = + - @} or a tab, unless the text is a number.
 */
public final class CsvText {

    private static final Pattern FORMULA = Pattern.compile("(?s)\\s*[=+\\-@\t\r].*");
    private static final Pattern NUMBER = Pattern.compile("[+-]?\\d+(\\.\\d+)?([eE][+-]?\\d+)?");

    private final int columns;
    private final ObjectWriter writer;
    private final StringBuilder text = new StringBuilder();

    /** A table without rows. */
    public CsvText(String... columns) {
        this.columns = columns.length;
        CsvSchema schema = CsvSchema.builder()
                .addColumns(List.of(columns), CsvSchema.ColumnType.NUMBER_OR_STRING)
                .build();
        writer = new CsvMapper().writer(schema);
        row((Object[]) columns);
    }

    /**
     * Appends a row: texts are quoted where they need it, numbers are written in full precision.
     *
     * @throws IllegalArgumentException if there is not one cell per column
     */
    public CsvText row(Object... cells) {
        if (cells.length != columns) {
            throw new IllegalArgumentException(cells.length + " cells for " + columns + " columns");
        }
        try {
            text.append(writer.writeValueAsString(
                    Arrays.stream(cells).map(CsvText::harmless).toArray()));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return this;
    }

    private static Object harmless(Object cell) {
        return cell instanceof String words
                        && FORMULA.matcher(words).matches()
                        && !NUMBER.matcher(words).matches()
                ? "'" + words
                : cell;
    }

    /** The header and the rows. */
    public String text() {
        return text.toString();
    }
}
