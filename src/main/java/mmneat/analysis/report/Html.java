package mmneat.analysis.report;

import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.List;
import mmneat.analysis.Page;
import mmneat.analysis.statistics.TextTable;

/** Pieces of HTML. */
final class Html {

    private Html() {}

    /** A table; rows whose last cell is a star are set off. */
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

    /** A picture inside the page. Drawings keep their own identifiers apart when they are images. */
    static String image(String svg, String description) {
        String data = Base64.getEncoder().encodeToString(svg.getBytes(StandardCharsets.UTF_8));
        return "<img loading=\"lazy\" alt=\"" + Page.escape(description) + "\" src=\"data:image/svg+xml;base64," + data
                + "\">";
    }
}
