package mmneat.analysis.results;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ExperimentFinderTest {

    @TempDir
    Path base;

    @Test
    void folderOfRuns_isEveryMethod_inThePapersOrder() throws IOException {
        RunFixture.run(base, "blended", "2M", 10, 100, 200);
        RunFixture.run(base, "blended", "2M", 2, 100, 300);
        RunFixture.run(base, "blended", "1M", 0, 50);
        RunFixture.run(base, "blended", "MMD", 0, 70);
        List<Experiment> found = ExperimentFinder.find(List.of(base.resolve("blended")));
        assertThat(found).extracting(Experiment::label).containsExactly("1M", "MM(D)", "2M");
        assertThat(found).extracting(Experiment::version).containsOnly("blended");
        assertThat(found.get(2).runs()).extracting(RunResult::number).containsExactly(2, 10);
        assertThat(found.get(2).championScores(false)).containsExactly(300, 200);
        assertThat(found.get(2).championScoresAt(0)).containsExactly(100, 100);
    }

    @Test
    void stem_isTheRunsThatBeginWithIt_andNoOther() throws IOException {
        RunFixture.run(base, "interleaved", "MT", 20, 1);
        RunFixture.run(base, "blended", "MT2", 0, 2);
        RunFixture.run(base, "blended", "MT2", 1, 3);
        assertThat(ExperimentFinder.find(List.of(base.resolve("interleaved/MT"))))
                .singleElement()
                .satisfies(e -> assertThat(e.runs())
                        .singleElement()
                        .extracting(RunResult::number)
                        .isEqualTo(20));
        assertThat(ExperimentFinder.find(List.of(base.resolve("blended/MT2"))))
                .singleElement()
                .satisfies(e -> {
                    assertThat(e.method()).isEqualTo("MT2");
                    assertThat(e.runs()).hasSize(2);
                });
        assertThatThrownBy(() -> ExperimentFinder.find(List.of(base.resolve("blended/MT"))))
                .isInstanceOf(UserError.class);
    }

    @Test
    void folderThatCannotBeRead_isNamed() throws IOException {
        RunFixture.run(base, "blended", "2M", 0, 1);
        Path closed = Files.createDirectory(base.resolve("blended/closed"));
        assumeThat(closed.toFile().setReadable(false)).isTrue();
        assumeThat(Files.isReadable(closed)).isFalse();
        assertThatThrownBy(() -> ExperimentFinder.find(List.of(base.resolve("blended"))))
                .isInstanceOf(UserError.class)
                .hasMessage(closed + ": cannot be read: permission denied");
    }

    @Test
    void averagesOverAllRuns_makeNoRunOfTheFolder() throws IOException {
        RunFixture.run(base, "blended", "2M", 0, 1);
        Files.writeString(base.resolve("blended/blended-2MAVG_parents_log.txt"), "0\t1\n");
        assertThat(ExperimentFinder.find(List.of(base.resolve("blended"))))
                .extracting(Experiment::label)
                .containsExactly("2M");
    }

    @Test
    void evaluationOfAnEarlierChampion_isNone() throws IOException {
        Path run = RunFixture.run(base, "blended", "2M", 0, 1);
        RunFixture.evaluation(run, 4000, 1, 2);
        Files.writeString(run.resolve("champion.json"), "{\"id\" : 0}");
        assertThat(RunReader.read(run).evaluation()).isPresent();
        Files.writeString(run.resolve("champion.json"), "{\"id\" : 7}");
        assertThat(RunReader.read(run).evaluation()).isEmpty();
    }

    @Test
    void runMeantTwice_isThereOnce_andHidesNoOther() throws IOException {
        for (int run = 0; run < 3; run++) {
            RunFixture.run(base, "blended", "2M", run, 1);
        }
        assertThat(ExperimentFinder.find(List.of(base.resolve("blended/2M"), base.resolve("blended/2M1"))))
                .singleElement()
                .satisfies(
                        e -> assertThat(e.runs()).extracting(RunResult::number).containsExactly(0, 1, 2));
    }

    @Test
    void sameMethodWithOtherSettings_isToldApartByTheFolder() throws IOException {
        RunFixture.run(base, "blended", "2M", 0, 1);
        Files.move(RunFixture.run(base, "blended", "2M", 1, 1), base.resolve("blended/2M-quick1"));
        assertThat(ExperimentFinder.find(List.of(base.resolve("blended"))))
                .extracting(Experiment::label)
                .containsExactly("2M", "2M-quick");
    }

    @Test
    void sameMethodOfTwoVersions_isToldApartByTheLabel() throws IOException {
        RunFixture.run(base, "blended", "1M", 0, 1);
        RunFixture.run(base, "isolated", "1M", 0, 1);
        assertThat(ExperimentFinder.find(List.of(base.resolve("blended"), base.resolve("isolated"))))
                .extracting(Experiment::label)
                .containsExactly("blended 1M", "isolated 1M");
    }

    @Test
    void runOfTheOriginal_isUnderstood() throws IOException {
        Path folder = RunFixture.run(base, "onelifeconflict", "MMD", 3, 10, 20);
        Files.delete(folder.resolve("parameters.properties"));
        Files.writeString(
                folder.resolve("OneLifeConflict-MMD3_parameters.txt"),
                "runNumber:3\nmmdRate:0.1\nimprisonedWhileEdible:false\n"
                        + "task:edu.utexas.cs.nn.tasks.mspacman.MsPacManTask\n");
        assertThat(ExperimentFinder.find(List.of(folder))).singleElement().satisfies(e -> {
            assertThat(e.version()).isEqualTo("blended");
            assertThat(e.method()).isEqualTo("MMD");
            assertThat(e.runs().get(0).lastScore()).isEqualTo(20);
        });
    }

    @Test
    void evaluation_isRead() throws IOException {
        Path folder = RunFixture.run(base, "blended", "2M", 0, 10, 20);
        RunFixture.evaluation(folder, 4321.5, 900, 100);
        Experiment experiment = ExperimentFinder.find(List.of(folder)).get(0);
        assertThat(experiment.runs().get(0).isComparable()).isTrue();
        assertThat(experiment.championScores(true)).containsExactly(4321.5);
        assertThat(experiment.runs().get(0).evaluation().orElseThrow().mostUsedModulePercent())
                .isEqualTo(90);
    }

    @Test
    void folderOfExperiments_isEveryExperimentBelowIt() throws IOException {
        RunFixture.run(base.resolve("results"), "blended", "2M", 0, 1);
        RunFixture.run(base.resolve("results/more"), "isolated", "1M", 0, 1);
        assertThat(ExperimentFinder.find(List.of(base.resolve("results"))))
                .extracting(Experiment::label)
                .containsExactly("2M", "1M");
    }

    @Test
    void variantOfAMethod_hasTheNameOfItsFolder_andIsNotThePapersMethod() throws IOException {
        Path variant = RunFixture.run(base, "blended", "MMD", 0, 1);
        Path parameters = variant.resolve("parameters.properties");
        Files.writeString(parameters, Files.readString(parameters).replace("mmdRate=0.1", "mmdRate=0.2"));
        Files.move(variant, base.resolve("blended/MMD02-0"));
        assertThat(ExperimentFinder.find(List.of(base.resolve("blended"))))
                .singleElement()
                .satisfies(experiment -> {
                    assertThat(experiment.label()).isEqualTo("MMD02");
                    assertThat(experiment.isVariant()).isTrue();
                    assertThat(experiment.paperMethod()).isEmpty();
                    assertThat(experiment.differencesFromPaper()).containsEntry("mmdRate", "0.1");
                });
    }

    @Test
    void bestRun_isTheBestEvaluated_orWithoutEvaluationsTheBestWhenChosen() throws IOException {
        RunFixture.run(base, "blended", "2M", 0, 100, 5000, 100);
        RunFixture.run(base, "blended", "2M", 1, 100, 300, 9000);
        Path evaluated = RunFixture.run(base, "blended", "2M", 2, 100, 200, 200);
        List<Path> folder = List.of(base.resolve("blended"));
        assertThat(ExperimentFinder.find(folder).get(0).best().number()).isZero();
        RunFixture.evaluation(evaluated, 50, 1);
        assertThat(ExperimentFinder.find(folder).get(0).best().number()).isEqualTo(2);
    }

    @Test
    void linkToTheFolderOfARun_isNoRunOfItsOwn() throws IOException {
        Path run = RunFixture.run(base, "blended", "2M", 0, 1, 2);
        RunFixture.run(base, "blended", "2M", 1, 1, 2);
        Path earlier = Files.createSymbolicLink(base.resolve("blended/1M0"), Path.of("2M0"));
        Path later = Files.createSymbolicLink(base.resolve("blended/2M7"), Path.of("2M0"));
        for (List<Path> paths :
                List.of(List.of(base.resolve("blended")), List.of(run, base.resolve("blended/2M"), earlier, later))) {
            assertThat(ExperimentFinder.find(paths)).singleElement().satisfies(experiment -> assertThat(
                            experiment.runs())
                    .extracting(found -> found.folder().getFileName().toString())
                    .containsExactly("2M0", "2M1"));
        }
        assertThat(ExperimentFinder.find(List.of(later))).hasSize(1);
    }

    @Test
    void noRuns_isAnErrorThatNamesThePath() {
        assertThatThrownBy(() -> ExperimentFinder.find(List.of(base.resolve("nothing"))))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("nothing")
                .hasMessageContaining("results/blended");
    }

    @Test
    void brokenLog_isAnErrorThatNamesFileAndLine() throws IOException {
        Path folder = RunFixture.run(base, "blended", "1M", 0, 1, 2);
        Files.writeString(folder.resolve("blended-1M0_parents_log.txt"), "0\t1.0\n");
        assertThatThrownBy(() -> ExperimentFinder.find(List.of(folder)))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("blended-1M0_parents_log.txt, line 1");
    }

    @Test
    void parameterThatIsNoNumber_isAnErrorThatNamesIt() throws IOException {
        Path run = RunFixture.run(base, "blended", "2M", 0, 1000, 2000);
        Path parameters = run.resolve("parameters.properties");
        Files.writeString(parameters, Files.readString(parameters).replace("runNumber=0", "runNumber=x"));
        assertThatThrownBy(() -> ExperimentFinder.find(List.of(base.resolve("blended"))))
                .isInstanceOf(UserError.class)
                .hasMessage(parameters + ": runNumber=x: must be a whole number");
    }
}
