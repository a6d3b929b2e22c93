package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.Reader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.parameters.Parameters;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.neat.Genotype;
import mmneat.neat.io.GenotypeFiles;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Hybrid methods: the names, the presets, and whole runs. */
class HybridRunsTest {

    private static final Set<String> OF_THE_MOMENT =
            Set.of("status.json", "parameters.properties", "checkpoint.json.gz", "checkpoint-previous.json.gz");

    @TempDir
    private Path folder;

    private static Parameters parameters(String... words) {
        return new ParameterReader(ParameterCatalogue.load())
                .read(List.of(words))
                .parameters();
    }

    private void run(String base, int generations, String... words) throws Exception {
        List<String> all = new ArrayList<>(List.of(
                "saveTo=run",
                "log=log",
                "mu=6",
                "trials=1",
                "pacManLevelTimeLimit=400",
                "maxGens=" + generations,
                "base=" + folder.resolve(base)));
        all.addAll(Arrays.asList(words));
        RunOutcome outcome = new ExperimentRunner(ExperimentPlan.of(parameters(all.toArray(String[]::new))))
                .run()
                .get(0);
        assertThat(outcome.message()).isNull();
    }

    private Map<String, String> files(String base) throws IOException {
        Path of = folder.resolve(base).resolve("run0");
        try (Stream<Path> found = Files.walk(of)) {
            Map<String, String> texts = new TreeMap<>();
            for (Path file : found.filter(Files::isRegularFile).toList()) {
                String name = file.getFileName().toString();
                if (!OF_THE_MOMENT.contains(name) && !name.contains("Performance")) {
                    texts.put(of.relativize(file).toString(), Files.readString(file));
                }
            }
            return texts;
        }
    }

    @ParameterizedTest
    @CsvSource({"blended, MT2", "interleaved, MT", "isolated, MT"})
    void oneModuleInEachGroup_isTheMultitaskMethod_drawForDraw(String task, String multitask) throws Exception {
        run("hybrid", 3, "task=" + task, "method=H11");
        run("multitask", 3, "task=" + task, "method=" + multitask);
        assertThat(files("hybrid")).hasSizeGreaterThan(10).isEqualTo(files("multitask"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"method=H21", "method=H12MMD mmdRate=0.5"})
    void interruptedRun_equalsAnUninterruptedOne(String words) throws Exception {
        String[] hybrid = ("task=blended " + words).split(" ");
        for (int generations = 1; generations <= 4; generations++) {
            run("interrupted", generations, hybrid);
        }
        run("whole", 4, hybrid);
        assertThat(files("interrupted")).isEqualTo(files("whole"));

        Genotype champion = GenotypeFiles.read(folder.resolve("whole/run0/champion.json"));
        assertThat(champion.layout().choicesOfTask()).isEqualTo(2);
        try (Stream<Path> networks = Files.walk(folder.resolve("whole/run0/gen4"))) {
            for (Path file : networks.filter(Files::isRegularFile).toList()) {
                assertThat(GenotypeFiles.read(file).layout().isGrouped()).isTrue();
            }
        }
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ' ',
            value = {
                "blended H:threat=2,edible=1 H21 2,1",
                "blended H:edible=1,threat=2 H21 2,1",
                "interleaved H:threat=1,edible=3,MMD H13MMD 1,3",
                "isolated H:pills=1,ghosts=2 H12 1,2",
                "blended H:both=3,threat=2,edible=1 H123 1,2,3",
            })
    void namedGroups_haveAShortName(String task, String method, String name, String groups) {
        Parameters parameters = parameters("task=" + task, "method=" + method);
        assertThat(parameters.text("method")).isEqualTo(name);
        assertThat(parameters.text("moduleGroups")).isEqualTo(groups);
        assertThat(PublishedTask.method(parameters.values())).contains(name);
        assertThat(ExperimentPlan.of(parameters).name()).isEqualTo(task + "-" + name);
    }

    @ParameterizedTest
    @CsvSource({"blended, H11", "blended, H21", "interleaved, H11", "interleaved, H21", "isolated, H11", "isolated, H21"
    })
    void presetFile_saysWhatTheMethodSets(String task, String method) throws IOException {
        Properties file = new Properties();
        try (Reader reader = Files.newBufferedReader(Path.of("configs", task, method + ".properties"))) {
            file.load(reader);
        }
        Parameters ofMethod = parameters("task=" + task, "method=" + method);
        assertThat(file.stringPropertyNames()).allMatch(ofMethod::isGiven);
        Map<String, String> ofFile =
                new TreeMap<>(parameters("config=" + Path.of("configs", task, method + ".properties"))
                        .values());
        ofFile.put("config", "");
        assertThat(ofFile).isEqualTo(new TreeMap<>(ofMethod.values()));
    }

    @Test
    void studyOfAllMethods_hasNoHybrids_butAListMayNameThem() {
        List<String> all = Study.of(List.of("task=blended", "method=all"), ParameterCatalogue.load()).parts().stream()
                .map(part -> part.plan().name())
                .toList();
        assertThat(all).noneMatch(name -> name.contains("-H"));
        Study study = Study.of(List.of("task=blended", "method=2M,MT2,H21"), ParameterCatalogue.load());
        assertThat(study.parts())
                .extracting(part -> part.plan().name())
                .containsExactly("blended-2M", "blended-MT2", "blended-H21");
        assertThat(Study.of(List.of("task=blended", "method=H:threat=2,edible=1"), ParameterCatalogue.load())
                        .parts())
                .extracting(part -> part.plan().name())
                .containsExactly("blended-H21");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "task=blended method=H:threat=2 | such as H:threat=1,edible=1 or H:edible=1,threat=1,both=1",
                "task=blended method=H:threat=2,threat=1 | 'threat=1' is not allowed; give every group once",
                "task=blended method=H:threat=2,edible=0 | 'edible=0' is not allowed; give every group once",
                "task=isolated method=H:threat=2,edible=1 | such as H:pills=1,ghosts=1",
                "task=blended method=H2 | or a hybrid such as H21",
                "task=blended method=H20 | or a hybrid such as H21",
                "task=blended method=H21 moduleGroups=2,1,1 | names 3 groups, but the division chooses among multitaskModes=2",
                "task=blended method=H21 moduleGroups=x | moduleGroups=x: must be the number of modules of each group",
                "task=blended method=H21 startingModes=2 | cannot be combined with startingModes=2",
                "task=blended method=H21 multitaskModes=1 | names 2 groups, but the division chooses among multitaskModes=1",
                "task=my.Task method=H21 | needs a human-specified task division",
            })
    void wrongGroups_areMistakes(String words, String message) {
        assertThatThrownBy(() -> parameters(words.split(" ")))
                .isInstanceOf(UserError.class)
                .hasMessageContaining(message);
    }
}
