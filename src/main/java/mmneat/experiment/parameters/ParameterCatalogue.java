package mmneat.experiment.parameters;

import com.fasterxml.jackson.annotation.JsonPropertyOrder;
import com.fasterxml.jackson.databind.MappingIterator;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import mmneat.experiment.NearestName;
import mmneat.experiment.UserError;

/**
 * The list of all parameters: those of the original, supported or not, and those of this program alone for everyday
 * use, such as {@code runs} and {@code method}.
 *
 * <p>The catalogue is data, the table {@code parameters.csv} beside this class, so that the command line, the help, the
 * documentation and the checks use the same facts. Source: docs/specification/evolution.md, sections 13 and 14.
 */
public final class ParameterCatalogue {

    private final Map<String, Parameter> parameters;

    private ParameterCatalogue(Map<String, Parameter> parameters) {
        this.parameters = parameters;
    }

    /** Reads the catalogue in the program's jar. */
    public static ParameterCatalogue load() {
        try (InputStream table = ParameterCatalogue.class.getResourceAsStream("parameters.csv");
                MappingIterator<Row> rows = new CsvMapper()
                        .readerFor(Row.class)
                        .with(CsvSchema.emptySchema().withHeader())
                        .readValues(table)) {
            Map<String, Parameter> parameters = new LinkedHashMap<>();
            for (Row row : rows.readAll()) {
                parameters.put(row.name, row.parameter());
            }
            return new ParameterCatalogue(Collections.unmodifiableMap(parameters));
        } catch (IOException e) {
            throw new UncheckedIOException("the packed catalogue of parameters cannot be read", e);
        }
    }

    /** All parameters, grouped, the most used first. */
    public Collection<Parameter> all() {
        return parameters.values();
    }

    /** The parameter with exactly this name. */
    public Optional<Parameter> find(String name) {
        return Optional.ofNullable(parameters.get(name));
    }

    /**
     * The parameter with this name.
     *
     * @throws UserError if the name is unknown; the message contains the nearest known name
     */
    public Parameter require(String name) {
        Parameter parameter = parameters.get(name);
        if (parameter == null) {
            String nearest = NearestName.suggestion(name, parameters.keySet());
            throw new UserError("unknown parameter '" + name + "'"
                    + (nearest.isEmpty() ? "; 'params' lists all parameters" : nearest));
        }
        return parameter;
    }

    List<String> names() {
        return List.copyOf(parameters.keySet());
    }

    /** One line of the table. */
    @JsonPropertyOrder({"name", "type", "default", "support", "allowed", "group", "meaning"})
    private record Row(
            String name,
            String type,

            @com.fasterxml.jackson.annotation.JsonProperty("default")
            String defaultValue,

            String support,
            String allowed,
            String group,
            String meaning) {

        Parameter parameter() {
            return new Parameter(
                    name,
                    ParameterType.of(type),
                    defaultValue,
                    Parameter.Support.of(support),
                    AllowedValues.of(allowed),
                    group,
                    meaning);
        }
    }
}
