package mmneat.analysis.statistics;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * A table of texts that can be written in aligned columns or as LaTeX. The first column is aligned left, all others
 * right by default.
 */
public final class TextTable {

    private final List<String> header;
    private final List<List<String>> rows = new ArrayList<>();
    private final Set<String> leftColumns = new HashSet<>();

    public TextTable(String... header) {
        this.header = List.of(header);
    }

    /** Aligns columns left in {@link #text}, besides the first; they are named by their headers. */
    public TextTable alignLeft(String... columns) {
        leftColumns.addAll(List.of(columns));
        return this;
    }

    /** Appends a row with one cell per column. */
    public TextTable row(String... cells) {
        if (cells.length != header.size()) {
            throw new IllegalArgumentException(cells.length + " cells for " + header.size() + " columns");
        }
        rows.add(List.of(cells));
        return this;
    }

    public List<String> header() {
        return header;
    }

    public List<List<String>> rows() {
        return List.copyOf(rows);
    }

    /** Columns set apart by two blanks, a rule under the header. */
    public String text() {
        int[] widths = new int[header.size()];
        for (int column = 0; column < widths.length; column++) {
            int c = column;
            widths[c] = Math.max(
                    header.get(c).length(),
                    rows.stream().mapToInt(row -> row.get(c).length()).max().orElse(0));
        }
        StringBuilder text = new StringBuilder(line(header, widths));
        text.append("-".repeat(java.util.Arrays.stream(widths).sum() + 2 * (widths.length - 1)))
                .append('\n');
        rows.forEach(row -> text.append(line(row, widths)));
        return text.toString();
    }

    private String line(List<String> cells, int[] widths) {
        StringBuilder line = new StringBuilder();
        for (int c = 0; c < widths.length; c++) {
            String padding = " ".repeat(widths[c] - cells.get(c).length());
            boolean isLeft = c == 0 || leftColumns.contains(header.get(c));
            line.append(c == 0 ? "" : "  ").append(isLeft ? cells.get(c) + padding : padding + cells.get(c));
        }
        return line.toString().stripTrailing() + "\n";
    }

    /** A {@code tabular} with booktabs rules. */
    public String latex() {
        return "\\begin{tabular}{l" + "r".repeat(header.size() - 1) + "}\n\\toprule\n" + latexLine(header)
                + "\\midrule\n" + rows.stream().map(TextTable::latexLine).collect(Collectors.joining())
                + "\\bottomrule\n\\end{tabular}\n";
    }

    private static String latexLine(List<String> cells) {
        return cells.stream()
                        .map(cell -> cell.replace("\\", "\\textbackslash{}")
                                .replace("_", "\\_")
                                .replace("%", "\\%")
                                .replace("&", "\\&")
                                .replace("#", "\\#"))
                        .collect(Collectors.joining(" & "))
                + " \\\\\n";
    }
}
