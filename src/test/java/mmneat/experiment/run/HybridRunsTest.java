package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import mmneat.analysis.results.RunReader;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.parameters.Parameters;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.experiment.store.RunParametersFile;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.sensors.Observation;
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
    @ValueSource(strings = {"method=H21", "method=H12MMD mmdRate=0.5"})
    void tableOfGenerations_hasTheModulesAndTheUseOfEachGroup(String words) throws Exception {
        run("table", 3, ("task=blended " + words).split(" "));
        List<String> lines = Files.readAllLines(folder.resolve("table/run0/generations.csv"));
        List<String> header = List.of(lines.get(0).replace("\"", "").split(","));
        assertThat(header.subList(header.size() - 4, header.size()))
                .containsExactly("modules of group 0", "use of group 0", "modules of group 1", "use of group 1");
        for (String line : lines.subList(1, lines.size())) {
            List<String> row = List.of(line.split(","));
            assertThat(row).hasSameSizeAs(header);
            List<String> groups = row.subList(row.size() - 4, row.size());
            assertThat(Integer.parseInt(groups.get(0)) + Integer.parseInt(groups.get(2)))
                    .isEqualTo(Integer.parseInt(row.get(header.indexOf("modules"))));
            assertThat(Double.parseDouble(groups.get(1)) + Double.parseDouble(groups.get(3)))
                    .isCloseTo(1, within(1e-9));
        }
        Genotype champion = GenotypeFiles.read(folder.resolve("table/run0/champion.json"));
        List<String> ofChampion = List.of(lines.get(3).split(","));
        int[] usage = champion.moduleUsage();
        int ofGroup0 = IntStream.range(0, usage.length)
                .filter(module -> champion.layout().choiceOf(module) == 0)
                .map(module -> usage[module])
                .sum();
        assertThat(ofChampion.get(header.size() - 4))
                .isEqualTo(champion.layout().sizesOfGroups().get(0).toString());
        assertThat(Double.parseDouble(ofChampion.get(header.size() - 3)))
                .isEqualTo((double) ofGroup0 / Arrays.stream(usage).sum());
    }

    /** The table of a version that did not know these columns. */
    @Test
    void tableWithoutColumnsOfGroups_goesOnWithoutThem_andIsRead() throws Exception {
        run("old", 2, "task=blended", "method=H21");
        Path of = folder.resolve("old/run0");
        Path table = of.resolve("generations.csv");
        List<String> shorter = Files.readAllLines(table).stream()
                .map(line -> line.split(","))
                .map(fields -> String.join(",", Arrays.copyOf(fields, fields.length - 4)))
                .toList();
        // The checkpoint was written before the last generation, the third line of the table.
        String kept = String.join("\n", shorter.subList(0, 3)) + "\n";
        long before = String.join("\n", Files.readAllLines(table).subList(0, 3)).length() + 1L;
        Files.writeString(table, String.join("\n", shorter) + "\n");
        for (String name : List.of("checkpoint.json.gz", "checkpoint-previous.json.gz")) {
            replaceIn(of.resolve(name), "\"generations.csv\":" + before, "\"generations.csv\":" + kept.length());
        }
        run("old", 3, "task=blended", "method=H21");
        run("new", 3, "task=blended", "method=H21");

        List<String> continued = Files.readAllLines(table);
        List<String> whole = Files.readAllLines(folder.resolve("new/run0/generations.csv"));
        assertThat(continued).hasSize(5);
        for (int i = 0; i < continued.size(); i++) {
            assertThat(whole.get(i)).startsWith(continued.get(i) + ",");
        }
        assertThat(RunReader.championScores(of)).isEqualTo(RunReader.championScores(folder.resolve("new/run0")));
    }

    private static void replaceIn(Path packed, String before, String after) throws IOException {
        String text;
        try (GZIPInputStream in = new GZIPInputStream(Files.newInputStream(packed))) {
            text = new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
        try (GZIPOutputStream out = new GZIPOutputStream(Files.newOutputStream(packed))) {
            out.write(text.replace(before, after).getBytes(StandardCharsets.UTF_8));
        }
    }

    /** A division of the user's own: three kinds of time steps. */
    public static final class Thirds implements ModuleDivision {
        @Override
        public int modules() {
            return 3;
        }

        @Override
        public int module(Observation observation) {
            return observation.highestEdibleTime() > 0 ? 2 : observation.isAtJunction() ? 1 : 0;
        }
    }

    @Test
    void divisionOfTheUsersOwn_choosesTheGroup() throws Exception {
        String division = "pacmanMultitaskScheme=" + Thirds.class.getName();
        run("long", 2, "task=blended", "method=H:0=2,2=1,1=3", division);
        run("short", 2, "task=blended", "method=H231", division);
        run("published", 2, "task=blended", "method=H231");
        assertThat(files("long")).isEqualTo(files("short")).isNotEqualTo(files("published"));
        Genotype champion = GenotypeFiles.read(folder.resolve("long/run0/champion.json"));
        assertThat(champion.layout().sizesOfGroups()).containsExactly(2, 3, 1);

        run("growing", 2, "task=blended", "method=H:0=1,1=2,2=1,MMD", "mmdRate=0.9", division);
        try (Stream<Path> networks = Files.walk(folder.resolve("growing/run0/gen2"))) {
            assertThat(networks.filter(Files::isRegularFile).toList())
                    .extracting(file -> GenotypeFiles.read(file).layout().choicesOfTask())
                    .containsOnly(3);
        }
    }

    @Test
    void groupsOfAnotherDivision_haveNumbersInsteadOfNames() {
        assertThatThrownBy(() -> parameters(
                        "task=blended", "method=H:threat=2,edible=1", "pacmanMultitaskScheme=AnyPillsModeSelector"))
                .isInstanceOf(UserError.class)
                .hasMessage("method=H:threat=2,edible=1: 'threat=2' is not allowed; give every group of"
                        + " pacmanMultitaskScheme=AnyPillsModeSelector once by its number from 0, such as"
                        + " H:0=1,1=1");
        assertThat(parameters(
                                "task=blended",
                                "method=H:threat=2,edible=1",
                                "pacmanMultitaskScheme=AnyGhostEdibleModeSelector")
                        .text("method"))
                .isEqualTo("H21");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ' ',
            value = {
                "blended H:threat=2,edible=1 H21 2,1",
                "blended h:Threat=2,EDIBLE=1,mmd H21MMD 2,1",
                "blended h21 H21 2,1",
                "blended h21mmd H21MMD 2,1",
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
    @CsvSource({"H11, 10, H111, 0", "H111, 0, H11, 10", "H21, 11, H211, 1"})
    void runsOfTwoHybridsWithOneFolder_areToldApart(String first, int firstRun, String second, int secondRun)
            throws Exception {
        String base = "base=" + folder;
        RunPlan begun = ExperimentPlan.of(parameters("task=blended", "method=" + first, "run=" + firstRun, base))
                .runs()
                .get(0);
        new RunParametersFile(Files.createDirectories(begun.directory())).write(begun.parameters());
        String[] words = {"task=blended", "method=" + second, "run=" + secondRun, base};
        RunPlan other = ExperimentPlan.of(parameters(words)).runs().get(0);
        assertThat(other.directory()).isEqualTo(begun.directory());
        assertThatThrownBy(() -> new RunParametersFile(other.directory()).requireSame(other.parameters()))
                .isInstanceOf(UserError.class)
                .hasMessage("%s is run %s of %s, and run %s of %s would have the same folder; give saveTo=%s-"
                        .formatted(other.directory(), firstRun, first, secondRun, second, second));
        RunPlan renamed = ExperimentPlan.of(
                        parameters(("saveTo=" + second + "- " + String.join(" ", words)).split(" ")))
                .runs()
                .get(0);
        assertThat(renamed.directory()).isEqualTo(folder.resolve(second + "-" + secondRun));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "task=blended method=H:threat=2 | such as H:threat=1,edible=1 or H:edible=1,threat=1,both=1",
                "task=blended method=H:threat=2,threat=1 | 'threat=1' is not allowed; give every group once",
                "task=blended method=H:threat=2,edible=1, | '' is not allowed; give every group once",
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
