package mmneat.experiment.parameters;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import mmneat.GoldenData;
import mmneat.experiment.UserError;
import mmneat.mspacman.TaskVersion;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** The original's parameters, its parser, its saved files and its sixteen published command lines. */
@Tag("conformance")
class ParametersConformanceTest {

    private final ParameterCatalogue catalogue = ParameterCatalogue.load();
    private final ParameterReader reader = new ParameterReader(catalogue);

    @Test
    void catalogue_hasEveryParameterOfTheOriginal_withItsTypeAndDefault() throws IOException {
        Map<String, String> expected = new TreeMap<>();
        for (String line : Files.readAllLines(GoldenData.folder("parameters").resolve("defaults.txt"))) {
            String[] fields = line.split("\t", -1);
            String value = fields[1].equals("class") ? simpleName(fields[2]) : fields[2];
            expected.put(fields[0], fields[1] + " " + value);
        }
        // The only deliberate difference (docs/fidelity.md): the number of threads is the number of cores.
        assertThat(expected.replace("threads", "integer 0")).isEqualTo("integer 4");

        Map<String, String> ours = new TreeMap<>();
        for (Parameter parameter : catalogue.all()) {
            if (parameter.isOfOriginal()) {
                String type = parameter.type() == ParameterType.TEXT
                        ? "string"
                        : parameter.type().toString();
                ours.put(parameter.name(), type + " " + parameter.defaultValue());
            }
        }
        assertThat(ours).isEqualTo(expected).hasSize(378);
    }

    @Test
    void wordsWithAColon_areReadAsByTheOriginal() throws IOException {
        int read = 0;
        for (JsonNode example : json("parse_examples.json")) {
            String argument = example.get("argument").asText();
            Parameter parameter = catalogue.require(example.get("parameter").asText());
            ParameterWord word = ParameterWord.original(argument);
            assertThat(word.name()).as(argument).isEqualTo(parameter.name());
            if (example.has("throws")) {
                // The original fails with an exception; here the error names the allowed values.
                assertThatThrownBy(() -> word.canonicalFor(parameter))
                        .as(argument)
                        .isInstanceOf(UserError.class)
                        .hasMessageContaining(parameter.name())
                        .hasMessageContaining("a whole number");
            } else if (parameter.support() == Parameter.Support.NO) {
                assertThat(word.value())
                        .as(argument)
                        .isEqualTo(example.get("value").asText());
            } else {
                assertThat(readOriginal(word, parameter))
                        .as(argument)
                        .isEqualTo(example.get("value").asText());
            }
            read++;
        }
        assertThat(read).isEqualTo(23);
    }

    /** Only the parser, without checks of ranges, as for the recorded examples. */
    private static String readOriginal(ParameterWord word, Parameter parameter) {
        Parameter anyValue = new Parameter(
                parameter.name(),
                parameter.type(),
                parameter.defaultValue(),
                Parameter.Support.IGNORED,
                parameter.allowed(),
                parameter.group(),
                parameter.meaning());
        return word.canonicalFor(anyValue);
    }

    @Test
    void publishedCommandLines_ofBothPackages_areUnderstood() throws IOException {
        int read = 0;
        for (JsonNode configuration : json("configurations.json")) {
            for (String ofPackage :
                    List.of("", "edu.southwestern.tasks.mspacman.", "edu.utexas.cs.nn.tasks.mspacman.")) {
                List<String> words = words(configuration.get("parameters"), ofPackage);
                Parameters parameters = reader.read(words).parameters();
                configuration.get("parameters").fields().forEachRemaining(entry -> assertThat(
                                parameters.text(entry.getKey()))
                        .as("%s %s", configuration.get("configuration"), entry.getKey())
                        .isEqualTo(catalogue
                                .require(entry.getKey())
                                .check(entry.getValue().asText().replace("<run>", "7"))));
                assertThat(PublishedTask.version(parameters).orElseThrow().label())
                        .isEqualTo(configuration.get("version").asText());
            }
            read++;
        }
        assertThat(read).isEqualTo(16);
    }

    @Test
    void shortForm_meansTheSameAsThePublishedCommandLine() throws IOException {
        List<String> places = List.of("base", "saveTo", "log", "task", "runNumber", "randomSeed");
        for (JsonNode configuration : json("configurations.json")) {
            String task = configuration.get("version").asText();
            String method = configuration.get("method").asText().replace("MM(D)", "MMD");
            Parameters ours =
                    reader.read(List.of("task=" + task, "method=" + method)).parameters();
            Map<String, String> differing = new TreeMap<>();
            Map<String, String> published = reader.read(words(configuration.get("parameters"), ""))
                    .parameters()
                    .values();
            ours.values().forEach((name, value) -> {
                if (!value.equals(published.get(name)) && !places.contains(name)) {
                    differing.put(name, value);
                }
            });
            differing.remove("method");
            if (task.equals("isolated")) {
                // The path on the published command line is specific to its author.
                differing.remove("mazePowerPillGhostMapping");
            }
            assertThat(differing).as("%s %s", task, method).isEmpty();
        }
    }

    @Test
    void parameterFileSavedByTheOriginal_isReadAsAConfigFile() throws IOException {
        Path saved = GoldenData.folder("parameters").resolve("example_saved_parameters.txt");
        Parameters parameters = reader.read(List.of("config=" + saved)).parameters();
        int compared = 0;
        for (String line : Files.readAllLines(saved)) {
            String name = line.substring(0, line.indexOf(':'));
            Parameter parameter = catalogue.require(name);
            assertThat(parameters.text(name))
                    .as(name)
                    .isEqualTo(parameter.check(line.substring(line.indexOf(':') + 1)));
            compared++;
        }
        assertThat(compared).isGreaterThan(350);
        assertThat(parameters.integer("mu")).isEqualTo(6);
        assertThat(parameters.text("utPath")).isEqualTo("ut\\game");
        assertThat(PublishedTask.version(parameters)).contains(TaskVersion.BLENDED);
    }

    private static List<String> words(JsonNode parameters, String ofPackage) {
        List<String> words = new ArrayList<>();
        parameters.fields().forEachRemaining(entry -> {
            String value = entry.getValue().asText().replace("<run>", "7");
            String prefix = !ofPackage.isEmpty()
                    ? switch (entry.getKey()) {
                        case "task" -> ofPackage;
                        case "pacmanInputOutputMediator" -> ofPackage + "sensors.mediators.";
                        case "pacmanMultitaskScheme" -> ofPackage + "multitask.";
                        default -> "";
                    }
                    : "";
            words.add(entry.getKey() + ":" + prefix + value);
        });
        return words;
    }

    private static JsonNode json(String file) throws IOException {
        return new JsonMapper()
                .readTree(GoldenData.folder("parameters").resolve(file).toFile());
    }

    private static String simpleName(String className) {
        return className.equals("null") ? "" : className.substring(className.lastIndexOf('.') + 1);
    }
}
