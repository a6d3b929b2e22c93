package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.store.RunParametersFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ExperimentPlanTest {

    private final ParameterReader reader = new ParameterReader(ParameterCatalogue.load());

    private ExperimentPlan plan(String... words) {
        return ExperimentPlan.of(reader.read(List.of(words)).parameters());
    }

    @Test
    void thirtyRuns_areRuns0To29WithSeeds0To29() {
        ExperimentPlan plan = plan("task=blended", "runs=30");
        assertThat(plan.runs()).extracting(RunPlan::number).isEqualTo(range());
        assertThat(plan.runs()).extracting(RunPlan::seed).isEqualTo(range());
        assertThat(plan.name()).isEqualTo("blended-2M");
        assertThat(plan.runs().get(7).directory()).isEqualTo(Path.of("results", "blended", "2M7"));
        assertThat(plan.runs().get(7).prefix()).isEqualTo("blended-2M7_");
        assertThat(plan.runs().get(7).generations()).isEqualTo(200);
    }

    private static List<Integer> range() {
        return IntStream.range(0, 30).boxed().toList();
    }

    @Test
    void oneRunOfMany_isTheSameAsAmongMany() {
        RunPlan alone = plan("task=blended", "run=7").runs().get(0);
        RunPlan among = plan("task=blended", "runs=30").runs().get(7);
        assertThat(alone.directory()).isEqualTo(among.directory());
        assertThat(alone.seed()).isEqualTo(among.seed());
        assertThat(alone.prefix()).isEqualTo(among.prefix());
    }

    @Test
    void originalCommandLine_hasTheOriginalsPlaces() {
        RunPlan run = plan(
                        "runNumber:3",
                        "randomSeed:5",
                        "base:onelifeconflict",
                        "task:edu.southwestern.tasks.mspacman.MsPacManTask",
                        "log:OneLifeConflict-MMD",
                        "saveTo:MMD",
                        "mmdRate:0.1")
                .runs()
                .get(0);
        assertThat(run.number()).isEqualTo(3);
        assertThat(run.seed()).isEqualTo(5);
        assertThat(run.directory()).isEqualTo(Path.of("onelifeconflict", "MMD3"));
        assertThat(run.prefix()).isEqualTo("OneLifeConflict-MMD3_");
    }

    @Test
    void originalTaskWithoutPlaces_goesWhereTheShortFormGoes() {
        ExperimentPlan plan = plan("task:MsPacManTask", "imprisonedWhileEdible:true", "multitaskModes:2");
        assertThat(plan.runs().get(0).directory()).isEqualTo(Path.of("results", "interleaved", "MT20"));
    }

    @Test
    void oneSeedForManyRuns_isAnError() {
        assertThatThrownBy(() -> plan("task=blended", "runs=2", "randomSeed=3"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("2 equal runs");
        assertThatThrownBy(() -> plan("task=blended", "runs=2", "run=1"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("'run' and 'runs'");
    }

    @Test
    void foldersWithDifferentNames_haveFilesWithDifferentNames() {
        assertThat(plan("task=blended", "saveTo=a/b").name()).isEqualTo("blended-a-b");
        // On Windows both mean the same folder.
        boolean isOneFolder = File.separatorChar == '\\';
        assertThat(plan("task=blended", "saveTo=a\\b").name()).isEqualTo(isOneFolder ? "blended-a-b" : "blended-a_b");
    }

    @Test
    void emptyNames_areThoseThatTheProgramChooses() {
        ExperimentPlan plan = plan("task=blended", "base=", "saveTo=", "log=");
        assertThat(plan.base()).isEqualTo(Path.of("results", "blended"));
        assertThat(plan.name()).isEqualTo("blended-2M");
        assertThat(plan.runs().get(0).directory()).isEqualTo(Path.of("results", "blended", "2M0"));
        assertThat(plan.runs().get(0).prefix()).isEqualTo("blended-2M0_");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "..",
                "../",
                "../../ev3/",
                "a/../../b",
                "..\\x",
                "/tmp/x",
                "/",
                "\\x",
                "C:\\x",
                "c:x",
                "a/..",
                ".",
                "a/.",
                ".x"
            })
    void foldersOutsideOfBase_orHidden_areRefused(String saveTo, @TempDir Path folder) throws IOException {
        assertThatThrownBy(() -> plan("task=blended", "saveTo=" + saveTo))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith("saveTo=" + saveTo + ": the folders of runs ");
        Path file =
                Files.writeString(folder.resolve("stranger.properties"), "task=blended\nsaveTo=" + saveTo + "/a/..");
        assertThatThrownBy(() -> plan("config=" + file)).hasMessageContaining(": the folders of runs ");
    }

    @ParameterizedTest
    @ValueSource(strings = {"a/b", "a/", "a..b", "a/./b", "x-", ".a/b", "2M.", "a.b/c..d"})
    void foldersInBase_areAllowed(String saveTo) {
        assertThat(plan("task=blended", "saveTo=" + saveTo).runs().get(0).directory())
                .isEqualTo(Path.of("results", "blended", saveTo + "0"));
    }

    @Test
    void runsOfAnotherFolder_areNotReplacedInTheListOfRuns(@TempDir Path folder) throws IOException {
        String base = "base=" + folder;
        ExperimentView.recordRequested(plan("task=blended", base, "runs=3", "saveTo=a/b"));
        ExperimentView.recordRequested(plan("task=blended", base, "runs=4", "saveTo=a/./b"));
        assertThatThrownBy(() -> ExperimentView.recordRequested(plan("task=blended", base, "runs=2", "saveTo=a-b")))
                .isInstanceOf(UserError.class)
                .hasMessage(folder.resolve("blended-a-b.runs.json") + ": belongs to the runs " + folder.resolve("a/b0")
                        + ", and those of saveTo=a-b would have files of the same names; give log=NAME");
        ExperimentView.recordRequested(plan("task=blended", base, "runs=2", "saveTo=a-b", "log=other"));
    }

    @Test
    void savedParameters_describeTheSameRun(@TempDir Path folder) throws IOException {
        for (String[] words : new String[][] {
            {"task=blended", "run=7", "mu=10", "base=" + folder},
            {"task=interleaved", "method=MT", "runs=3", "base=" + folder, "mazePowerPillGhostMapping=a b\\c:\u00e9=.txt"
            },
            {"task:MsPacManTask", "mating:true", "imprisonedWhileEdible:true", "base=" + folder, "log:x"},
            {"task=com.example.Xor", "jar=x.jar", "task.noise=3", "method=3M", "base=" + folder}
        }) {
            RunPlan run = plan(words).runs().get(0);
            RunParametersFile file = new RunParametersFile(folder);
            file.write(run.parameters());
            // A user's code must be named on the command line, even if the file names it.
            List<String> named = new ArrayList<>(List.of("config=" + folder.resolve("parameters.properties")));
            Stream.of(words).filter(word -> word.startsWith("jar=")).forEach(named::add);
            RunPlan again = plan(named.toArray(String[]::new)).runs().get(0);
            file.requireSame(again.parameters());
            assertThat(again.number()).isEqualTo(run.number());
            assertThat(again.seed()).isEqualTo(run.seed());
            assertThat(again.directory()).isEqualTo(run.directory());
            assertThat(again.prefix()).isEqualTo(run.prefix());
            assertThat(again.parameters().text("mazePowerPillGhostMapping"))
                    .isEqualTo(run.parameters().text("mazePowerPillGhostMapping"));
            assertThat(again.parameters().ofOwnTask())
                    .isEqualTo(run.parameters().ofOwnTask());
        }
    }

    @Test
    void savedParametersOfOneRun_serveForOtherRuns(@TempDir Path folder) throws IOException {
        new RunParametersFile(folder)
                .write(plan("task=blended", "run=7", "mu=10").runs().get(0).parameters());
        ExperimentPlan plan = plan("config=" + folder.resolve("parameters.properties"), "runs=3");
        assertThat(plan.runs()).extracting(RunPlan::seed).containsExactly(0, 1, 2);
        assertThat(plan.parameters().integer("mu")).isEqualTo(10);
    }

    @Test
    void continuingWithOtherParameters_isAnErrorThatNamesThem(@TempDir Path folder) throws IOException {
        RunParametersFile file = new RunParametersFile(folder);
        file.write(plan("task=blended", "mu=10").runs().get(0).parameters());
        assertThatThrownBy(() ->
                        file.requireSame(plan("task=blended").runs().get(0).parameters()))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("begun with mu=10 (now 100)");
        assertThatThrownBy(() -> file.requireSame(
                        plan("task=interleaved", "mu=10").runs().get(0).parameters()))
                .hasMessageContainingAll("task=blended (now interleaved)", "imprisonedWhileEdible=false (now true)");
        assertThatCode(() ->
                        file.requireSame(plan("task=blended", "mu=10", "maxGens=300", "threads=1", "base=elsewhere")
                                .runs()
                                .get(0)
                                .parameters()))
                .doesNotThrowAnyException();
    }

    @ParameterizedTest
    @CsvSource({
        "saveTo=%s, 225, saveTo",
        "saveTo=%s, 256, saveTo",
        "log=%s, 225, log",
        "saveTo=%s log=x, 255, log",
        "saveTo=sub/%s log=x, 255, log"
    })
    void namesThatAreTooLongForFiles_areRefused(String words, int length, String named) {
        List<String> all = new ArrayList<>(List.of("task=blended", "runs=30"));
        all.addAll(List.of(words.formatted("n".repeat(length)).split(" ")));
        assertThatThrownBy(() -> ExperimentPlan.of(reader.read(all).parameters()))
                .isInstanceOf(UserError.class)
                .hasMessageContaining(named)
                .hasMessageContaining("too long");
    }

    @ParameterizedTest
    @ValueSource(strings = {".", "..", ".x"})
    void logOfHiddenFiles_isRefused(String log) {
        assertThatThrownBy(() -> plan("task=blended", "log=" + log))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith("log=" + log + ": the run's files would be hidden");
    }

    @ParameterizedTest
    @ValueSource(strings = {"a/b", "/tmp/x", "..\\x", "\\u0000", "../x"})
    void logWithAPath_isRefused(String log) {
        assertThatThrownBy(() -> ExperimentPlan.of(
                        reader.read(List.of("task=blended", "log=" + log)).parameters()))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("must not contain / or \\");
    }
}
