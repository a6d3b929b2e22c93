package mmneat.neat.io;

import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import java.io.IOException;

/** Layout of a genotype's JSON: each field of the document and each gene on a separate line. */
final class OneGenePerLine extends DefaultPrettyPrinter {

    private static final Indenter LINES = new DefaultIndenter("  ", "\n");
    private static final Indenter INLINE = new FixedSpaceIndenter();

    private int depth;

    OneGenePerLine() {
        indentArraysWith(LINES);
    }

    @Override
    public DefaultPrettyPrinter createInstance() {
        return new OneGenePerLine();
    }

    @Override
    public void writeStartObject(JsonGenerator generator) throws IOException {
        indentObjectsWith(++depth == 1 ? LINES : INLINE);
        super.writeStartObject(generator);
    }

    @Override
    public void writeEndObject(JsonGenerator generator, int fields) throws IOException {
        super.writeEndObject(generator, fields);
        indentObjectsWith(--depth == 1 ? LINES : INLINE);
    }
}
