package mmneat.analysis;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A self-contained HTML page, made from a template with placeholders. The template is a resource of the program. The
 * placeholder {@code {{name}}} is replaced by the value set with {@link #with}, and {@code {{file:name}}} by the
 * content of another resource of the same folder.
 */
public final class Page {

    private static final Pattern PLACE = Pattern.compile("\\{\\{([a-zA-Z:._-]+)}}");

    private final String folder;
    private final String template;
    private final Map<String, String> values = new LinkedHashMap<>();

    /**
     * A page from a template.
     *
     * @param folder folder of the resources below {@code mmneat/analysis}, for example {@code replay}
     * @param template file name of the template
     */
    public Page(String folder, String template) {
        this.folder = folder;
        this.template = template;
    }

    /** Sets the value of a placeholder; the HTML is inserted unchanged. */
    public Page with(String name, String html) {
        values.put(name, html);
        return this;
    }

    /** Sets the value of a placeholder to plain text; special characters are escaped. */
    public Page withText(String name, String text) {
        return with(name, escape(text));
    }

    /** Sets the value of a placeholder inside a script element to JSON. */
    public Page withJson(String name, String json) {
        // "</script>" inside a string would end the element; JSON lets us write the slash escaped.
        return with(name, json.replace("</", "<\\/"));
    }

    /**
     * The complete page.
     *
     * @throws IllegalStateException if a placeholder of the template has no value
     */
    public String html() {
        return PLACE.matcher(resource(template)).replaceAll(match -> Matcher.quoteReplacement(at(match.group(1))));
    }

    private String at(String place) {
        if (place.startsWith("file:")) {
            return resource(place.substring("file:".length()));
        }
        String value = values.get(place);
        if (value == null) {
            throw new IllegalStateException("nothing was given for '" + place + "' of " + template);
        }
        return value;
    }

    private String resource(String name) {
        try (InputStream in = Page.class.getResourceAsStream(folder + "/" + name)) {
            if (in == null) {
                throw new IllegalStateException("the resource " + folder + "/" + name + " is missing");
            }
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Plain text with the special characters of HTML escaped. */
    public static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;")
                .replace("'", "&#39;");
    }
}
