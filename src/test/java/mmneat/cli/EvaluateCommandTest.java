package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import mmneat.ProgramRun;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.results.RunFixture;
import mmneat.neat.ModuleLayout;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class EvaluateCommandTest extends CommandTest {

    @TempDir
    Path base;

    @Test
    void championNamedTwice_playsOnce() throws IOException {
        Path run = RunFixture.run(base, "blended", "2M", 0, 1000, 2000);
        Path champion = RunFixture.champion(run, ModuleLayout.withPreferenceNeurons(2, 1), 1);
        int code = execute("evaluate", run.toString(), champion.toString(), "games=3");
        assertThat(errors.toString()).isEmpty();
        assertThat(code).isZero();
        assertThat(run.resolve("evaluation-training.csv")).content().hasLineCount(1 + 3);
    }

    @Test
    void folderThatIsALinkToAnotherRun_isEvaluatedOnce() throws IOException {
        Path run = RunFixture.run(base, "blended", "2M", 0, 1000, 2000);
        RunFixture.champion(run, ModuleLayout.withPreferenceNeurons(2, 1), 1);
        Files.createSymbolicLink(base.resolve("blended/2M7"), Path.of("2M0"));
        assertThat(execute("evaluate", base.resolve("blended").toString(), "games=2"))
                .isZero();
        assertThat(out.toString().lines().filter(line -> line.startsWith("2M")))
                .singleElement()
                .asString()
                .startsWith("2M0");
    }

    @Test
    void championInBothForms_isToldAsOne() throws IOException {
        Path run = RunFixture.run(base, "blended", "2M", 0, 1000, 2000);
        Path champion = RunFixture.champion(run, ModuleLayout.withPreferenceNeurons(2, 1), 1);
        Path folder = Files.createDirectory(run.resolve("bestPacMan"));
        Path other = Files.copy(champion, folder.resolve("bestPacMan.xml"));
        assertMistake(
                other + ": another of these champions has the same table, " + run.resolve("evaluation-training.csv")
                        + "; name one of them",
                "evaluate",
                run.toString(),
                other.toString(),
                "games=3");
        assertThat(execute("evaluate", other.toString(), "games=3")).isZero();
        assertThat(run.resolve("evaluation-training.csv")).content().hasLineCount(4);
    }

    @Test
    void tableWithADamagedLine_isRefusedByEvaluateAndReport() throws IOException {
        Path run = RunFixture.run(base, "blended", "2M", 0, 1000, 2000);
        RunFixture.champion(run, ModuleLayout.withPreferenceNeurons(2, 1), 1);
        String experiment = base.resolve("blended").toString();
        assertThat(execute("evaluate", experiment, "games=4")).isZero();
        Path table = run.resolve("evaluation-training.csv");
        String whole = Files.readString(table);
        for (String line : List.of("5,x\n", whole, whole.replace("game,seed", "4,Z"))) {
            Files.writeString(table, whole + line);
            String mistake = table + ", line 6: ";
            assertMistake(mistake, "evaluate", experiment, "games=4");
            assertMistake(mistake, "report", experiment, "out=" + base.resolve("report.html"));
            assertThat(table).hasContent(whole + line);
        }
        Files.writeString(table, whole + "4,12");
        assertThat(execute("report", experiment, "out=" + base.resolve("report.html")))
                .isZero();
    }

    @Test
    void evaluationWithAnotherSeed_isKept_withARemark() throws IOException {
        Path run = RunFixture.run(base, "blended", "2M", 0, 1000, 2000);
        RunFixture.champion(run, ModuleLayout.withPreferenceNeurons(2, 1), 1);
        assertThat(execute("evaluate", run.toString(), "games=4")).isZero();
        assertThat(errors.toString()).isEmpty();
        String whole = Files.readString(run.resolve("evaluation-training.csv"));
        assertThat(execute("evaluate", run.toString(), "games=1", "seed=1")).isZero();
        assertThat(errors.toString())
                .contains("held another evaluation (4 games; ", "kept as evaluation-training-old-1.csv");
        assertThat(run.resolve("evaluation-training-old-1.csv")).hasContent(whole);
    }

    @Test
    void stoppedEvaluation_saysHowToContinue_andContinues() throws Exception {
        Path run = RunFixture.run(base, "blended", "2M", 0, 1000, 2000);
        RunFixture.champion(run, ModuleLayout.withPreferenceNeurons(2, 1), 1);
        Path messages = base.resolve("messages.txt");
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        ProgramRun.classPath(),
                        "mmneat.cli.Main",
                        "evaluate",
                        run.toString(),
                        "games=1000000",
                        "threads=1")
                .redirectErrorStream(true)
                .redirectOutput(messages.toFile())
                .start();
        Path table = run.resolve("evaluation-training.csv");
        while (process.isAlive() && (!Files.exists(table) || Files.size(table) < 2000)) {
            Thread.sleep(50);
        }
        process.destroy();
        assertThat(process.waitFor()).isEqualTo(128 + 15);
        assertThat(messages)
                .content()
                .contains(
                        "stopped; finished games are saved in blocks of 20. To continue, give the same command again:")
                .contains(" evaluate " + run + " games=1000000 threads=1");
        List<String> games = Files.readAllLines(table);
        assertThat(execute("evaluate", run.toString(), "games=1")).isZero();
        assertThat(table).content().startsWith(String.join("\n", games.subList(0, 21)));
    }

    @ParameterizedTest
    @CsvSource({
        "H111, 'moduleGroups=1,1', 1, 'H11, run 1'",
        "MT20, multitaskModes=2, 0, 'MT2, run 0'",
        "MT220, multitaskModes=2, 20, 'MT2, run 20'",
        "2M11, startingModes=2, 11, 2M11",
        "own3, 'moduleGroups=1,1', 3, own3"
    })
    void labelOfAChampion_tellsMethodAndNumberApart(String folder, String modules, int number, String label)
            throws IOException {
        Path run = Files.createDirectories(base.resolve(folder));
        RunFixture.champion(run, ModuleLayout.withPreferenceNeurons(2, 1), 1);
        Files.writeString(
                run.resolve("parameters.properties"), "task=blended\nrunNumber=" + number + "\n" + modules + "\n");
        assertThat(Champion.read(run).label()).isEqualTo(label);
    }
}
