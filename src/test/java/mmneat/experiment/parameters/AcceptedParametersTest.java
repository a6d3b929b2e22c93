package mmneat.experiment.parameters;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.annotation.JsonPropertyOrder;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import mmneat.GoldenData;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/**
 * Every accepted parameter gives the original's results. If a parameter of the original is accepted with a value that
 * none of the sixteen configurations has, a recorded run has such a value, or a list here gives the reason.
 */
@Tag("conformance")
class AcceptedParametersTest {

    /** Stands for any other value of parameters whose values cannot be listed. */
    private static final String ANY = "*";

    /** Parameters that do not affect results, such as file names. */
    private static final Set<String> NO_MATTER_OF_EQUALITY =
            Set.of("base", "saveTo", "log", "mazePowerPillGhostMapping");

    private final ParameterCatalogue catalogue = ParameterCatalogue.load();

    @JsonPropertyOrder({"name", "value", "reason"})
    private record Listed(String name, String value, String reason) {}

    private static List<Listed> list() throws IOException {
        try (InputStream table = AcceptedParametersTest.class.getResourceAsStream("accepted-without-runs.csv")) {
            return new CsvMapper()
                    .readerFor(Listed.class)
                    .with(CsvSchema.emptySchema().withHeader())
                    .<Listed>readValues(table)
                    .readAll();
        }
    }

    /**
     * Returns the values of the sixteen configurations by name, including the defaults of parameters that a
     * configuration does not name.
     */
    private Map<String, Set<String>> valuesOfTheSixteen() throws IOException {
        JsonNode configurations = new ObjectMapper()
                .readTree(GoldenData.folder("parameters")
                        .resolve("configurations.json")
                        .toFile());
        Map<String, Set<String>> values = new HashMap<>();
        for (Parameter parameter : catalogue.all()) {
            Set<String> of = new HashSet<>();
            for (JsonNode configuration : configurations) {
                JsonNode value = configuration.get("parameters").get(parameter.name());
                of.add(value == null ? parameter.defaultValue() : canonical(parameter, value.asText()));
            }
            values.put(parameter.name(), of);
        }
        return values;
    }

    private static String canonical(Parameter parameter, String text) {
        return parameter.accepts(text) ? parameter.check(text) : text;
    }

    /** The values of all recorded command lines, by name. */
    private Map<String, Set<String>> recordedValues() throws IOException {
        Map<String, Set<String>> values = new HashMap<>();
        for (String part : List.of("runs", "runs-options")) {
            try (Stream<Path> folders = Files.list(GoldenData.folder(part))) {
                for (Path folder : folders.filter(Files::isDirectory).toList()) {
                    for (String word : Files.readString(folder.resolve("command.txt"))
                            .strip()
                            .split(" ")) {
                        ParameterWord parsed = ParameterWord.parse(word);
                        values.computeIfAbsent(parsed.name(), name -> new HashSet<>())
                                .add(parsed.canonicalFor(catalogue.require(parsed.name())));
                    }
                }
            }
        }
        return values;
    }

    /** The accepted values that the sixteen configurations do not have and no recorded run has, by name. */
    private Map<String, List<String>> unrecorded() throws IOException {
        Map<String, Set<String>> sixteen = valuesOfTheSixteen();
        Map<String, Set<String>> recorded = recordedValues();
        Map<String, List<String>> unrecorded = new TreeMap<>();
        for (Parameter parameter : catalogue.all()) {
            String name = parameter.name();
            if (!parameter.isOfOriginal()
                    || parameter.support() != Parameter.Support.YES
                    || NO_MATTER_OF_EQUALITY.contains(name)) {
                continue;
            }
            Set<String> seen = new HashSet<>(recorded.getOrDefault(name, Set.of()));
            seen.removeAll(sixteen.get(name));
            List<String> missing = new ArrayList<>();
            List<String> choices = parameter.type() == ParameterType.BOOLEAN
                    ? List.of("true", "false")
                    : parameter.allowed().choices();
            if (choices.isEmpty()) {
                // Parameters with several values in the sixteen configurations are also recorded.
                if (seen.isEmpty() && sixteen.get(name).size() == 1 && parameter.type() != ParameterType.TEXT) {
                    missing.add(ANY);
                }
            } else {
                choices.stream()
                        .filter(choice -> !sixteen.get(name).contains(choice) && !seen.contains(choice))
                        .forEach(missing::add);
            }
            if (!missing.isEmpty()) {
                unrecorded.put(name, missing);
            }
        }
        return unrecorded;
    }

    @Test
    void acceptedValues_areRecordedOrListed_andTheListHasNoOthers() throws IOException {
        Map<String, List<String>> listed = new TreeMap<>();
        list().forEach(row ->
                listed.computeIfAbsent(row.name, name -> new ArrayList<>()).add(row.value));
        Map<String, Set<String>> expected = new LinkedHashMap<>();
        unrecorded().forEach((name, values) -> expected.put(name, Set.copyOf(values)));
        Map<String, Set<String>> found = new LinkedHashMap<>();
        listed.forEach((name, values) -> found.put(name, Set.copyOf(values)));

        assertThat(found).isEqualTo(expected);
    }

    @Test
    void reasons_nameTestsAndChaptersThatExist() throws IOException {
        Set<String> tests = new HashSet<>();
        try (Stream<Path> files = Files.walk(Path.of("src/test/java"))) {
            files.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith("Test.java"))
                    .forEach(name -> tests.add(name.substring(0, name.length() - ".java".length())));
        }
        Pattern chapter = Pattern.compile("docs/[\\w/-]+\\.md");
        for (Listed row : list()) {
            assertThat(tests).as(row.name).contains(row.reason.substring(0, row.reason.indexOf(':')));
            Matcher cited = chapter.matcher(row.reason);
            while (cited.find()) {
                assertThat(Path.of(cited.group())).as(row.name).exists();
            }
        }
    }

    @Test
    void unsupportedParameters_haveTheirDefaultsOnly() {
        for (Parameter parameter : catalogue.all()) {
            if (parameter.support() == Parameter.Support.NO) {
                String other = otherValue(parameter);
                assertThat(parameter.check(parameter.defaultValue())).isEqualTo(parameter.defaultValue());
                assertThatThrownBy(() -> parameter.check(other))
                        .isInstanceOf(UserError.class)
                        .hasMessageContaining(parameter.name());
            }
        }
    }

    private static String otherValue(Parameter parameter) {
        return switch (parameter.type()) {
            case BOOLEAN -> Boolean.toString(!Boolean.parseBoolean(parameter.defaultValue()));
            case INTEGER, LONG -> Long.toString(Long.parseLong(parameter.defaultValue()) == 1 ? 2 : 1);
            case DOUBLE -> parameter.defaultValue().equals("1.0") ? "2.0" : "1.0";
            case TEXT, CLASS -> "other";
        };
    }
}
