package mmneat.experiment.parameters;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import mmneat.experiment.UserError;
import mmneat.mspacman.GameSettings;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;
import mmneat.mspacman.modules.ModuleDivisions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import pacman.game.GhostLocations;

class ParameterReaderTest {

    private final ParameterReader reader = new ParameterReader(ParameterCatalogue.load());

    private Parameters read(String... words) {
        return reader.read(List.of(words)).parameters();
    }

    private void assertMistake(String message, String... words) {
        assertThatThrownBy(() -> read(words))
                .isInstanceOf(UserError.class)
                .hasMessageContaining(message)
                .message()
                .doesNotContain("\n");
    }

    @Test
    void classOfTheUsersOwnThatIsNeverCalled_isRemarked() {
        String division = "pacmanMultitaskScheme=" + getClass().getName();
        assertThat(reader.read(List.of("task=blended", "method=3M", division)).remarks())
                .containsExactly("pacmanMultitaskScheme has no effect: with method=3M no division chooses modules;"
                        + " method=MT2, MT3 or a hybrid such as H21 uses it");
        assertThat(reader.read(List.of("task=blended", "method=H21", division)).remarks())
                .isEmpty();
        assertThat(reader.read(List.of(
                                "task=blended",
                                "mating=false",
                                "crossover=" + getClass().getName()))
                        .remarks())
                .containsExactly("crossover has no effect without mating=true");
    }

    @Test
    void builtInDivisions_areTheAllowedValuesOfTheirParameter() {
        List<String> allowed =
                ParameterCatalogue.load().require("pacmanMultitaskScheme").choices();
        assertThatThrownBy(() -> ModuleDivisions.named("none"))
                .hasMessageEndingWith(" nor one of " + String.join(", ", allowed));
    }

    @Test
    void builtInGhostTeams_canBeMade() {
        for (String team : ParameterCatalogue.load().require("ghostTeam").choices()) {
            assertThat(Tasks.factory(read("task=blended", "ghostTeam=" + team)).get())
                    .isInstanceOf(MsPacManTask.class);
        }
    }

    /** Only classes of the original and those that are shipped lose their package. */
    @ParameterizedTest
    @CsvSource({
        "ghostTeam, pacman.controllers.examples.Legacy, Legacy",
        "ghostTeam, pacman.controllers.examples.mine.Legacy, pacman.controllers.examples.mine.Legacy",
        "ghostTeam, pacman.controllers.examples.MyGhosts, pacman.controllers.examples.MyGhosts",
        "ghostTeam, pacman.controllers.mine.Legacy, pacman.controllers.mine.Legacy",
        "pacmanMultitaskScheme, edu.southwestern.tasks.mspacman.multitask.AnyPillsModeSelector, AnyPillsModeSelector",
        "pacmanMultitaskScheme, edu.utexas.cs.nn.tasks.mspacman.multitask.AnyPillsModeSelector, AnyPillsModeSelector",
        "pacmanMultitaskScheme, my.AnyPillsModeSelector, my.AnyPillsModeSelector",
        "crossover, pacman.controllers.mine.TWEANNCrossover, pacman.controllers.mine.TWEANNCrossover",
        "task, pacman.controllers.mine.MyTask, pacman.controllers.mine.MyTask"
    })
    void classOfTheUsersOwn_keepsItsPackage(String name, String given, String canonical) {
        assertThat(ParameterCatalogue.load().require(name).check(given)).isEqualTo(canonical);
    }

    @Test
    void taskAlone_meansTwoModulesWithThePapersSettings() {
        Parameters parameters = read("task=blended");
        assertThat(parameters.text("method")).isEqualTo("2M");
        assertThat(parameters.integer("startingModes")).isEqualTo(2);
        assertThat(parameters.integer("mu")).isEqualTo(100);
        assertThat(parameters.integer("maxGens")).isEqualTo(200);
        assertThat(parameters.integer("trials")).isEqualTo(10);
        assertThat(parameters.flag("mating")).isTrue();
    }

    @Test
    void layers_laterOnesWin(@TempDir Path folder) throws IOException {
        Path config = folder.resolve("mine.properties");
        Files.writeString(config, "# mine\ntask=interleaved\nmu=20\ntrials: 3\n");
        Parameters parameters = read("config=" + config, "mu:30");
        assertThat(parameters.integer("mu")).isEqualTo(30);
        assertThat(parameters.integer("trials")).isEqualTo(3);
        assertThat(parameters.flag("imprisonedWhileEdible")).isTrue();
        assertThat(parameters.integer("lairTime")).isEqualTo(40);
        assertThat(parameters.isGiven("lairTime")).isFalse();
    }

    @Test
    void methodOfTheCommandLine_isNotMadeAnotherByTheFile(@TempDir Path folder) throws IOException {
        String twoModules = "config=configs/blended/2M.properties";
        assertMistake(
                "startingModes=2 in " + twoModules + " contradicts method=MMD, which means startingModes=1",
                twoModules,
                "task=blended",
                "method=MMD");
        assertMistake("contradicts method=1M", twoModules, "task=com.example.Xor", "method=1M");
        Path nameless = Files.writeString(folder.resolve("nameless.properties"), "mmdRate=0.1\n");
        assertMistake(
                "mmdRate=0.1 in config=" + nameless + " contradicts task=blended without a method,"
                        + " which means mmdRate=0.0: give the file's method with method=NAME",
                "config=" + nameless,
                "task=blended");
        assertThat(read(twoModules, "task=blended", "method=2M").integer("startingModes"))
                .isEqualTo(2);
        assertThat(read(twoModules, "task=com.example.Xor").integer("startingModes"))
                .isEqualTo(2);
        Parameters both = read(twoModules, "task=blended", "method=MMD", "startingModes=2");
        assertThat(both.number("mmdRate")).isEqualTo(0.1);
    }

    @Test
    void taskOrMethodOfTheFile_overriddenByTheCommandLine_isRemarked(@TempDir Path folder) throws IOException {
        Path file = Files.writeString(folder.resolve("mine.properties"), "task=blended\nmethod=mmd\nmu=20\n");
        String config = "config=" + file;
        ParameterReader.Result read = reader.read(List.of(config, "task=interleaved", "method=2m"));
        assertThat(read.parameters().text("method")).isEqualTo("2M");
        assertThat(read.parameters().text("task")).isEqualTo("interleaved");
        assertThat(read.parameters().integer("startingModes")).isEqualTo(2);
        assertThat(read.remarks())
                .containsExactly(
                        "task=blended in " + config + " is overridden by task=interleaved",
                        "method=MMD in " + config + " is overridden by method=2M");
        assertThat(reader.read(List.of(config, "method=H21")).remarks())
                .containsExactly("method=MMD in " + config + " is overridden by method=H21");
        assertThat(reader.read(List.of(config, "task=blended", "method=MMD")).remarks())
                .isEmpty();
        assertThat(reader.read(List.of(config, "mu=10")).remarks()).isEmpty();
        Path original = Files.writeString(folder.resolve("original.properties"), "task=MsPacManTask\nmu=20\n");
        assertThat(reader.read(List.of("config=" + original, "task=blended")).remarks())
                .isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "trials=1000000000 | trials=1000000000: must be a whole number from 1 to 100000",
                "maxGens=2147483647 | maxGens=2147483647: must be a whole number from 0 to 100000000",
                "runs=99999999999 | runs=99999999999: must be a whole number from 1 to 100000",
                "run=99999999999 | run=99999999999: must be a whole number from 0 to 2147483647",
                "run=-99999999999 | run=-99999999999: must be a whole number from 0 to 2147483647",
                "randomSeed=99999999999 | must be a whole number from -2147483648 to 2147483647",
                "run=-1 | run=-1: must be a whole number, at least 0",
                "run=x | run=x: must be a whole number, at least 0",
            })
    void numberThatIsTooLarge_isToldItsLimits(String word, String message) {
        assertMistake(message, "task=blended", word);
    }

    @Test
    void eachPublishedFile_isItsExperiment() {
        for (TaskVersion version : TaskVersion.values()) {
            String task = version.label();
            for (String method : PublishedConfigurations.methodsOf(version)) {
                String config = "config=configs/" + task + "/" + method + ".properties";
                assertThat(withoutConfig(read(config)))
                        .as(config)
                        .isEqualTo(withoutConfig(read("task=" + task, "method=" + method)));
            }
        }
    }

    private static Map<String, String> withoutConfig(Parameters parameters) {
        Map<String, String> values = new TreeMap<>(parameters.values());
        values.remove("config");
        return values;
    }

    @Test
    void taskOfTheCommandLine_isNotMadeAnotherByTheFile() {
        assertMistake(
                "removePillsNearPowerPills=true in config=configs/isolated/2M.properties contradicts task=blended",
                "config=configs/isolated/2M.properties",
                "task=blended");
        assertMistake("contradicts task=interleaved", "config=configs/blended/2M.properties", "task=interleaved");
    }

    @Test
    void fileOfTheSameTaskAndMethod_mayChangeThem(@TempDir Path folder) throws IOException {
        Path config = folder.resolve("mine.properties");
        Files.writeString(config, "task=blended\nmethod=mmd\nstartingModes=2\n");
        List<List<String>> named = List.of(
                List.of(), List.of("method=MMD"), List.of("task=blended"), List.of("task=blended", "method=MMD"));
        for (List<String> words : named) {
            List<String> all = new ArrayList<>(words);
            all.add("config=" + config);
            assertThat(read(all.toArray(String[]::new)).integer("startingModes"))
                    .as("%s", words)
                    .isEqualTo(2);
        }
    }

    @Test
    void namesOfMethodsAndTasks_areThoseInWhichThePublishedOnesAndHybridsDiffer() {
        assertThat(PublishedConfigurations.namesOfMethods())
                .containsExactly("startingModes", "mmdRate", "multitaskModes", "pacmanMultitaskScheme", "moduleGroups");
        assertThat(PublishedConfigurations.namesOfTasks())
                .containsExactlyInAnyOrder("imprisonedWhileEdible", "removePillsNearPowerPills");
    }

    @Test
    void methods_areThoseOfTheCatalogueThatHaveAFile() {
        assertThat(PublishedConfigurations.METHODS)
                .isEqualTo(ParameterCatalogue.load().require("method").allowed().choices());
        assertThat(PublishedConfigurations.methodsOf(TaskVersion.BLENDED))
                .containsExactly("1M", "2M", "3M", "MMD", "MT2", "MT3");
        assertThat(PublishedConfigurations.methodsOf(TaskVersion.INTERLEAVED))
                .containsExactly("1M", "2M", "3M", "MMD", "MT");
        assertThat(PublishedConfigurations.methodsOf(TaskVersion.ISOLATED))
                .containsExactly("1M", "2M", "3M", "MMD", "MT");
    }

    /** The library's presets equal the files of the published configurations. */
    @Test
    void presetsOfTheTask_equalThePublishedConfigurations() {
        for (MsPacManTaskSettings preset : List.of(
                MsPacManTaskSettings.blended(),
                MsPacManTaskSettings.interleaved(),
                MsPacManTaskSettings.isolated(GhostLocations.shipped()))) {
            GameSettings games = preset.games();
            Parameters parameters = read("task=" + games.version().label(), "method=1M");
            MsPacManTaskSettings settings =
                    ((MsPacManTask) Tasks.factory(parameters).get()).settings();
            assertThat(settings.games().trials()).isEqualTo(games.trials());
            assertThat(settings.games().deterministic()).isEqualTo(games.deterministic());
            assertThat(settings.networks()).isEqualTo(preset.networks());
            assertThat(settings.objectives()).isEqualTo(preset.objectives());
            assertThat(settings.games().ghosts().get())
                    .hasSameClassAs(games.ghosts().get());
            assertThat(settings.games().ofTrial().toString())
                    .isEqualTo(games.ofTrial().toString());
        }
    }

    /** Version and method are recognised from the values, however the parameters are written. */
    @Test
    void versionAndMethod_areReadBackFromTheValues() {
        for (TaskVersion version : TaskVersion.values()) {
            for (String method : PublishedConfigurations.methodsOf(version)) {
                Parameters parameters = read("task=" + version.label(), "method=" + method);
                assertThat(PublishedTask.version(parameters)).contains(version);
                assertThat(PublishedTask.version(parameters.values())).contains(version);
                assertThat(PublishedTask.method(parameters.values())).contains(method);
            }
        }
        assertThat(PublishedTask.version(Map.of("task", "edu.example.MsPacManTask", "imprisonedWhileEdible", "True")))
                .contains(TaskVersion.INTERLEAVED);
        assertThat(PublishedTask.version(Map.of("task", "com.example.Xor"))).isEmpty();
        assertThat(PublishedTask.method(Map.of("mmdRate", "0.1", "startingModes", "2")))
                .isEmpty();
    }

    @Test
    void unknownName_namesTheNearest() {
        assertMistake("unknown parameter 'maxGen' (did you mean 'maxGens'?)", "task=blended", "maxGen=3");
        assertMistake("did you mean 'config'", "confg=x");
    }

    @Test
    void badValue_namesParameterValueAndAllowedValues() {
        assertMistake("mu=many: must be a whole number from 1 to 100000", "task=blended", "mu=many");
        assertMistake("mu=0: must be a whole number from 1 to 100000", "task=blended", "mu=0");
        assertMistake("crossoverRate=1.5: must be a number from 0.0 to 1.0", "task=blended", "crossoverRate=1.5");
        assertMistake("crossoverRate=NaN: must be", "task=blended", "crossoverRate=NaN");
        assertMistake("mating=yes: must be true or false", "task=blended", "mating=yes");
        assertMistake("method=4M: must be one of 1M, 2M", "task=blended", "method=4M");
    }

    @Test
    void unsupportedParameter_isAnErrorUnlessItIsTheDefault() {
        assertMistake("parameter 'periodicDeltaCoding' is not supported", "task=blended", "periodicDeltaCoding=true");
        assertThat(read("task=blended", "periodicDeltaCoding=false").flag("periodicDeltaCoding"))
                .isFalse();
    }

    @Test
    void errorInAFile_namesTheFile(@TempDir Path folder) throws IOException {
        Path config = folder.resolve("mine.properties");
        Files.writeString(config, "task=blended\nmu=-1\n");
        assertMistake("mine.properties: mu=-1: must be", "config=" + config);
        assertMistake("cannot be read", "config=" + folder.resolve("none"));
        assertMistake("config=: must be the name of a file", "config=");
        Path large = Files.write(folder.resolve("large"), new byte[(1 << 20) + 1]);
        assertMistake("large: cannot be read: it is larger than 1 MiB", "config=" + large);
    }

    @Test
    void fileInAnotherEncoding_saysWhichLine(@TempDir Path folder) throws IOException {
        Path config = folder.resolve("mine.properties");
        Files.writeString(config, "task=blended\nmu=3\n# für uns\n", StandardCharsets.ISO_8859_1);
        assertMistake("mine.properties: line 3 is not UTF-8", "config=" + config);
        Files.writeString(config, "\uFEFFtask=blended\nmu=3\n# für uns\n");
        assertThat(read("config=" + config).integer("mu")).isEqualTo(3);
    }

    @Test
    void parameterTwiceInAFile_isAnError(@TempDir Path folder) throws IOException {
        Path config = folder.resolve("mine.properties");
        Files.writeString(config, "task=blended\nmu=3\nmu=4\n");
        assertMistake("mine.properties: 'mu' is given twice", "config=" + config);
    }

    @Test
    void otherFileOrFolder_isNotAFileOfParameters(@TempDir Path folder) throws IOException {
        Path page = Files.writeString(folder.resolve("page.md"), "* one\n* two\n");
        assertMistake("page.md: is not a file of parameters, one name=value per line", "config=" + page);
        assertMistake(": cannot be read: it is a folder; name a file in it", "config=" + folder);
    }

    @Test
    void ghostLocations_ofAnotherTaskThanTheIsolated_areRemarkedUpon() {
        List<String> words = List.of("task=blended", "mazePowerPillGhostMapping=mine.txt");
        assertThat(reader.read(words).remarks())
                .singleElement()
                .asString()
                .startsWith("mazePowerPillGhostMapping has no effect");
        assertThat(reader.read(List.of("task=isolated", words.get(1))).remarks())
                .isEmpty();
    }

    @Test
    void task_missingOrUnknown_listsTheTasks() {
        assertMistake("task is missing; give it as task=blended|interleaved|isolated", "mu=3");
        assertMistake("task=blend: must be one of blended, interleaved, isolated", "task=blend");
    }

    @Test
    void method_ofAnotherTask_namesTheMethodsOfThisTask() {
        assertMistake("its methods are 1M, 2M, 3M, MMD, MT2, MT3", "task=blended", "method=MT");
    }

    @Test
    void method_isTheSameInUpperAndLowerCase() {
        assertThat(read("task=blended", "method=mmd").number("mmdRate")).isEqualTo(0.1);
    }

    @Test
    void equalsSign_takesTheWholeRest_colonTakesThePieceUpToTheNext() {
        assertThat(read("task=blended", "base=C:\\runs").text("base")).isEqualTo("C:\\runs");
        assertThat(read("task=blended", "base:C:\\runs").text("base")).isEqualTo("C");
        assertThat(read("task=blended", "base=").text("base")).isEmpty();
        assertMistake("'base:' has no value", "task=blended", "base:");
    }

    @Test
    void colonForm_ofANonBoolean_isRemarkedUpon() {
        ParameterReader.Result result = reader.read(List.of("task=blended", "mating:yes"));
        assertThat(result.parameters().flag("mating")).isFalse();
        assertThat(result.remarks()).singleElement().asString().contains("mating:yes", "mating=false");
    }

    @Test
    void wordGivenTwice_theLaterOneOverrides_withARemark() {
        ParameterReader.Result read = reader.read(List.of("task=blended", "mu=3", "trials=2", "mu:4"));
        assertThat(read.parameters().integer("mu")).isEqualTo(4);
        assertThat(read.remarks()).containsExactly("mu=3 is overridden by mu=4, which comes later");
        assertThat(reader.read(List.of("task=blended", "mu=3", "mu:3")).remarks())
                .isEmpty();
        assertThat(read("task=isolated", "task=blended").text("task")).isEqualTo("blended");
    }

    @Test
    void ownTasksParameters_areForOwnTasksOnly() {
        assertMistake("unknown parameter 'task.noise'", "task=blended", "task.noise=3");
        assertThat(read("task=com.example.Xor", "task.noise=3").ofOwnTask()).containsEntry("noise", "3");
    }

    @Test
    void modesOfTheOriginalsFirstArgument_nameTheirReplacements() {
        assertMistake("runs=30", "multiple:30", "task=blended");
        assertMistake("use the command 'process'", "process:30");
        assertMistake("use the command 'process'", "hv:30");
        assertMistake("there is no lineage browser; the file ..._Lineage_log.txt", "lineage:2");
        assertMistake("parameters are written name=value", "blended");
    }

    @ParameterizedTest
    @CsvSource({
        "watch:true, watch FOLDER",
        "showNetworks:true, watch FOLDER",
        "evalReport:true, evaluate FOLDER report=true",
        "recordPacman:true, record=FILE",
        "pacmanSaveFile:x, record=FILE",
        "replayPacman:true, replay FILE",
        "logGhostLocOnPowerPill:true, record-ghosts FOLDER",
        "experiment:edu.utexas.cs.nn.experiment.BestNetworkExperiment, evaluate FOLDER",
        "experiment:ObjectiveBestNetworksExperiment, bestObjectives",
        "experiment:edu.utexas.cs.nn.experiment.LoadAndWatchExperiment, watch FILE"
    })
    void wordOfTheOriginal_thatIsACommandHere_namesTheCommand(String word, String command) {
        assertMistake(command, "task=blended", word);
    }

    @Test
    void values_bindToARecord() {
        record Some(int mu, boolean mating, double crossoverRate, String log) {}
        assertThat(read("task=blended", "mu=3", "log=x").as(Some.class)).isEqualTo(new Some(3, true, 0.5, "x"));
    }
}
