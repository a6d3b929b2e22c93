package mmneat.experiment.parameters;

import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.dataformat.javaprop.JavaPropsMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import mmneat.experiment.PlainText;

/**
 * The checked values of all parameters: the defaults, overridden by the layers that are added to them.
 *
 * <p>Immutable. Made by {@link ParameterReader}. Code that needs more than a few values binds them to a record whose
 * components have the parameters' names ({@link #as}).
 */
public final class Parameters {

    private static final JavaPropsMapper MAPPER = JavaPropsMapper.builder()
            .disable(DeserializationFeature.FAIL_ON_UNKNOWN_PROPERTIES)
            .enable(DeserializationFeature.FAIL_ON_MISSING_CREATOR_PROPERTIES)
            .build();

    private final ParameterCatalogue catalogue;
    private final Map<String, String> values;
    private final Set<String> given;
    private final Map<String, String> ofOwnTask;

    private Parameters(
            ParameterCatalogue catalogue,
            Map<String, String> values,
            Set<String> given,
            Map<String, String> ofOwnTask) {
        this.catalogue = catalogue;
        this.values = values;
        this.given = given;
        this.ofOwnTask = ofOwnTask;
    }

    /** Returns the defaults. */
    static Parameters defaults(ParameterCatalogue catalogue) {
        Map<String, String> values = new LinkedHashMap<>();
        for (Parameter parameter : catalogue.all()) {
            values.put(parameter.name(), parameter.defaultValue());
        }
        return new Parameters(catalogue, values, Set.of(), Map.of());
    }

    /** Returns these values overridden by a layer, whose texts are checked. */
    public Parameters with(Map<String, String> layer) {
        Map<String, String> newValues = new LinkedHashMap<>(values);
        Set<String> newGiven = new HashSet<>(given);
        Map<String, String> newOfOwnTask = new TreeMap<>(ofOwnTask);
        layer.forEach((name, text) -> {
            if (name.startsWith(OwnTask.PREFIX)) {
                PlainText.require("the name of a parameter", name);
                PlainText.require(name, PlainText.trimmed(text));
                newOfOwnTask.put(name.substring(OwnTask.PREFIX.length()), PlainText.trimmed(text));
            } else {
                newValues.put(name, catalogue.require(name).check(text));
                newGiven.add(name);
            }
        });
        return new Parameters(catalogue, newValues, newGiven, newOfOwnTask);
    }

    /** Returns these values with one value changed. */
    public Parameters with(String name, Object value) {
        return with(Map.of(name, String.valueOf(value)));
    }

    /**
     * Whether a layer above the defaults gives the parameter a value: the published settings, the file or the command
     * line. True also if this value equals the default.
     */
    public boolean isGiven(String name) {
        catalogue.require(name);
        return given.contains(name);
    }

    /** The value as text, in canonical form ({@link Parameter#check}). */
    public String text(String name) {
        catalogue.require(name);
        return Objects.requireNonNull(values.get(name), name);
    }

    /** The value of a parameter that is a whole number. */
    public int integer(String name) {
        return Integer.parseInt(text(name));
    }

    /** The value of a parameter that is a number. */
    public double number(String name) {
        return Double.parseDouble(text(name));
    }

    /** The value of a parameter that is true or false. */
    public boolean flag(String name) {
        return Boolean.parseBoolean(text(name));
    }

    /** Returns the values as a record whose components have the names of parameters in the catalogue. */
    public <T> T as(Class<T> record) {
        try {
            return MAPPER.readMapAs(values, record);
        } catch (IOException e) {
            throw new UncheckedIOException("the parameters do not fit the record " + record, e);
        }
    }

    /** Returns the parameters of a user's task, without the prefix {@code task.}. */
    public Map<String, String> ofOwnTask() {
        return Collections.unmodifiableMap(ofOwnTask);
    }

    /** The catalogue of these parameters. */
    public ParameterCatalogue catalogue() {
        return catalogue;
    }

    /** All values, in the catalogue's order. */
    public Map<String, String> values() {
        return Collections.unmodifiableMap(values);
    }
}
