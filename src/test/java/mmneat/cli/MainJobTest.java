package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The main job, {@code status} and {@code params} as words on the command line. */
class MainJobTest extends CommandTest {

    @TempDir
    Path folder;

    private int evolve(String... more) {
        String[] words = new String[more.length + 5];
        words[0] = "task=mmneat.evolution.XorTask";
        words[1] = "mating=true";
        words[2] = "mu=5";
        words[3] = "maxGens=2";
        words[4] = "base=" + folder.resolve("xor");
        System.arraycopy(more, 0, words, 5, more.length);
        return execute(words);
    }

    @Test
    void nextCommands_nameTheJarOfTheUsersClasses() {
        assertThat(evolve("runs=2", "jar=" + folder)).isZero();
        assertThat(out.toString())
                .containsPattern(" network .*champion\\.json jar=" + Pattern.quote(folder.toString()));
    }

    @Test
    void experiment_endsWithATableOfChampions_aLearningCurve_andNextCommands() {
        assertThat(evolve("runs=2")).isZero();
        assertThat(out.toString())
                .contains("XorTask-1M: 2 runs in " + folder.resolve("xor"))
                .containsPattern("run +best +median +folder")
                .contains(folder.resolve("xor").resolve("1M1").toString())
                .contains("champion.json: the best parent of generation 1,")
                .contains(" network " + folder.resolve("xor"))
                .doesNotContain("\u001b");
        assertThat(folder.resolve("xor/XorTask-1M_learning-curve.svg"))
                .content()
                .contains("<svg");
        assertThat(folder.resolve("xor/XorTask-1M_learning-curve.png")).isNotEmptyFile();
        assertThat(errors.toString()).isEmpty();

        assertThat(execute("status", folder.toString())).isZero();
        assertThat(out.toString()).contains("2 of 2 finished; best of the last generation");
        assertThat(evolve("runs=2")).isZero();
        assertThat(out.toString()).contains("2 runs were already complete");
        assertThat(evolve("runs=3", "maxGens=2", "quiet=true")).isZero();
    }

    @Test
    void quiet_printsNothing() {
        assertThat(evolve("quiet=true")).isZero();
        assertThat(out.toString()).isEmpty();
        assertThat(errors.toString()).isEmpty();
    }

    @Test
    void status_ofAFolderWithoutRuns_isAnError() {
        assertThat(execute("status", folder.toString())).isEqualTo(2);
        assertThat(errors.toString().lines()).singleElement().asString().contains("holds no runs");
        assertThat(execute("status", folder.resolve("none").toString())).isEqualTo(2);
    }

    @Test
    void status_followsSymbolicLinks_evenInCircles() throws IOException {
        assertThat(evolve("runs=1")).isZero();
        Path link = Files.createSymbolicLink(folder.resolve("link"), folder.resolve("xor"));
        Files.createSymbolicLink(folder.resolve("xor").resolve("circle"), folder);
        assertThat(execute("status", link.toString())).isZero();
        assertThat(out.toString()).contains("1 of 1 finished");
    }

    @Test
    void damagedListOfRuns_isAnErrorWithAdvice() throws IOException {
        assertThat(evolve("runs=1")).isZero();
        Files.writeString(folder.resolve("xor/XorTask-1M.runs.json"), "{\"saveTo");
        assertMistake("is damaged; remove it", "status", folder.toString());
    }

    @Test
    void damagedParametersOfARun_areAnErrorThatNamesThem() throws IOException {
        assertThat(evolve("runs=1")).isZero();
        Path parameters = folder.resolve("xor/1M0/parameters.properties");
        Files.writeString(parameters, Files.readString(parameters).replace("runNumber=0", "runNumber=x"));
        assertMistake(parameters + ": runNumber=x: must be a whole number", "status", folder.toString());
        Files.writeString(parameters, "mu=3\nmu=4\n");
        assertMistake(parameters + ": 'mu' is given twice", "status", folder.toString());
        Files.writeString(parameters, "# für", StandardCharsets.ISO_8859_1);
        assertMistake(parameters + ": cannot be read: it is not a text in UTF-8", "status", folder.toString());
    }

    @Test
    void finishedRunWithoutItsTable_isAnError_behindTheResults() throws IOException {
        assertThat(evolve("runs=1")).isZero();
        Files.delete(folder.resolve("xor/1M0/generations.csv"));
        Files.delete(folder.resolve("xor/1M0/XorTask-1M0_parents_log.txt"));
        assertThat(evolve("runs=1")).isEqualTo(2);
        assertThat(out.toString()).contains("1 run was already complete");
        assertThat(errors.toString())
                .isEqualToIgnoringNewLines("mmneat: " + folder.resolve("xor/1M0")
                        + ": generations.csv is missing; restore it or leave the run out");
    }

    @Test
    void experimentsOfOtherRunNames_inOneFolder_areTwo() {
        assertThat(evolve("runs=2")).isZero();
        assertThat(evolve("runs=1", "saveTo=other-")).isZero();
        assertThat(out.toString()).contains("XorTask-other: run 0 in").doesNotContain(" watch ");
        assertThat(execute("status", folder.toString())).isZero();
        assertThat(out.toString()).contains("2 of 2 finished").contains("1 of 1 finished");
    }

    @Test
    void reportOfAnotherTask_hasCurvesAndNetworks_butNoGames() {
        assertThat(evolve("runs=2")).isZero();
        Path page = folder.resolve("report.html");
        assertThat(execute("report", folder.resolve("xor").toString(), "out=" + page))
                .as(errors.toString())
                .isZero();
        assertThat(page)
                .content()
                .contains(
                        "1 experiment, 2 runs",
                        "aria-label=\"network of run 1\"",
                        "They come from few evaluations and are too high")
                .doesNotContain("-replays/", "the replays are in the folder", "Run evaluate");
        assertThat(folder.resolve("report-replays")).doesNotExist();
    }

    @Test
    void noWord_showsTheFirstCommands() {
        for (String[] arguments : new String[][] {{}, {"help"}}) {
            assertThat(execute(arguments)).isZero();
            assertThat(out.toString()).contains("task=blended", "status", "params", "--help");
        }
    }

    @Test
    void userErrors_areOneLine_withExitCode2() {
        assertMistake("did you mean 'maxGens'?", "task=blended", "maxGen=3");
        assertMistake("none.txt", "task=isolated", "mazePowerPillGhostMapping=none.txt");
        assertMistake("'evolve' is not a command", "evolve");
        assertMistake("'evalute' is not a command (did you mean 'evaluate'?)", "evalute", "first");
        assertMistake("must end in .html", "watch", "champion=blended", "out=game.mp4");
    }

    @Test
    void params_listsThem_andDescribesOne() {
        assertThat(execute("params")).isZero();
        assertThat(out.toString()).contains("mu=50", "crossoverRate=0.5").doesNotContain("logLock");
        assertThat(execute("params", "crossoverRate")).isZero();
        assertThat(out.toString()).contains("allowed   a number from 0.0 to 1.0");
        assertThat(execute("params", "crosoverRate")).isEqualTo(2);
        assertThat(errors.toString()).contains("did you mean 'crossoverRate'?");
    }

    @Test
    void exitCodeOfTwoJobs_isThatOfTheFailedRun_thenOfTheMistake_thenOfTheLock() {
        assertThat(MainJob.worse(0, 0)).isZero();
        assertThat(MainJob.worse(3, 0)).isEqualTo(3);
        assertThat(MainJob.worse(3, 2)).isEqualTo(2);
        assertThat(MainJob.worse(1, 2)).isEqualTo(1);
        assertThat(MainJob.worse(1, 3)).isEqualTo(1);
    }
}
