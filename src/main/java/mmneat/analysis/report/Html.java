package mmneat.analysis.report;

import java.util.List;
import mmneat.analysis.Page;
import mmneat.analysis.statistics.TextTable;

/** Fragments of HTML: tables and drawings. */
final class Html {

    private Html() {}

    /** A table; rows whose last cell is a star are emphasised. */
    static String table(TextTable table) {
        StringBuilder html = new StringBuilder("<div class=\"scroll\"><table><thead><tr>");
        table.header()
                .forEach(cell -> html.append("<th>").append(Page.escape(cell)).append("</th>"));
        html.append("</tr></thead><tbody>");
        for (List<String> row : table.rows()) {
            html.append(row.get(row.size() - 1).equals("*") ? "<tr class=\"significant\">" : "<tr>");
            row.forEach(cell -> html.append("<td>").append(Page.escape(cell)).append("</td>"));
            html.append("</tr>");
        }
        return html.append("</tbody></table></div>\n").toString();
    }

    /**
     * A drawing as part of the page: its text can be searched and copied, and its parts say what they are when pointed
     * at.
     *
     * @param svg an SVG document without identifiers
     * @param classes CSS classes of the element around it
     */
    static String drawing(String svg, String classes, String description) {
        return "<div class=\"" + classes + "\" role=\"group\" aria-label=\"" + Page.escape(description) + "\">" + svg
                + "</div>";
    }
}
