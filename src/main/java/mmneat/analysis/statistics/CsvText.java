package mmneat.analysis.statistics;

import com.fasterxml.jackson.databind.ObjectWriter;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;

/** A table as CSV (RFC 4180, lines end with a line feed): a header line, then one line per row. */
public final class CsvText {

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
            text.append(writer.writeValueAsString(cells));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return this;
    }

    /** The header and the rows. */
    public String text() {
        return text.toString();
    }
}
