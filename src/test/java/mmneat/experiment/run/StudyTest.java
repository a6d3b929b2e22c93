package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import mmneat.evolution.XorTask;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Studies: several experiments in one command. */
class StudyTest {

    private static Study study(String... words) {
        return Study.of(List.of(words), ParameterCatalogue.load());
    }

    private static List<String> names(Study study) {
        return study.parts().stream().map(part -> part.plan().name()).toList();
    }

    @Test
    void wholeStudy_isTheSixteenPublishedExperiments() {
        Study study = study("task=blended,interleaved,isolated", "method=all", "runs=30");
        assertThat(names(study))
                .containsExactly(
                        "blended-1M",
                        "blended-2M",
                        "blended-3M",
                        "blended-MMD",
                        "blended-MT2",
                        "blended-MT3",
                        "interleaved-1M",
                        "interleaved-2M",
                        "interleaved-3M",
                        "interleaved-MMD",
                        "interleaved-MT",
                        "isolated-1M",
                        "isolated-2M",
                        "isolated-3M",
                        "isolated-MMD",
                        "isolated-MT");
        assertThat(study.remarks()).isEmpty();
        assertThat(study.parts())
                .allSatisfy(part -> assertThat(part.unfinishedRuns()).hasSize(30));
    }

    @Test
    void listsOfTasksAndMethods_giveEveryCombination_tasksFirst() {
        Study study = study("task=blended,interleaved,isolated", "method=1M,2M", "mu=7");
        assertThat(names(study))
                .containsExactly(
                        "blended-1M", "blended-2M", "interleaved-1M", "interleaved-2M", "isolated-1M", "isolated-2M");
        for (Study.Part part : study.parts()) {
            assertThat(part.plan().parameters().integer("mu")).isEqualTo(7);
            // The words describe the part completely, because each job receives only them.
            assertThat(names(Study.of(part.words(), ParameterCatalogue.load())))
                    .containsExactly(part.plan().name());
        }
    }

    @Test
    void listInTwoWords_orWithSpaces_isOneList() {
        assertThat(names(study("task=blended", "task=isolated", "method= 2M, 1M ")))
                .containsExactly("blended-2M", "blended-1M", "isolated-2M", "isolated-1M");
    }

    @Test
    void allMethods_andHybrids_areTheUnion() {
        assertThat(names(study("task=interleaved", "method=1M,H21,all")))
                .containsExactly(
                        "interleaved-1M",
                        "interleaved-2M",
                        "interleaved-3M",
                        "interleaved-MMD",
                        "interleaved-MT",
                        "interleaved-H21");
        Study study = study("task=blended", "method=all,MT");
        assertThat(study.parts()).hasSize(6);
        assertThat(study.remarks()).hasSize(1).first().asString().startsWith("task=blended has no method MT ");
        requireMistake("method=4M: must be one of 1M", "task=blended", "method=all,4M");
    }

    @Test
    void repetition_isAnError() {
        requireMistake("method=1M,1M: 1M is named twice", "task=blended", "method=1M,1M");
        requireMistake("method=1M,1M: 1M is named twice", "task=blended", "method=1m,1M");
        requireMistake("method=2M,1M,2M: 2M is named twice", "task=blended", "method= 2M, 1M ,2M");
        requireMistake("task=blended,blended: blended is named twice", "task=blended,blended");
        requireMistake("blended is named twice", "task=blended", "task=isolated,blended");
        requireMistake("all is named twice", "task=blended", "method=all,all");
    }

    @Test
    void experimentsOfOneStudy_haveFoldersOfTheirOwn() {
        requireMistake("leave out saveTo=x", "task=blended", "method=1M,2M", "saveTo=x");
        requireMistake("leave out base=pp", "task=blended,isolated", "base=pp");
        requireMistake("leave out log=x", "task=blended", "method=1M,2M", "log=x");
        // Run 10 of the one and run 0 of the other.
        requireMistake("with saveTo=NAME", "task=blended", "method=H11,H111", "runs=11");
        assertThat(names(study("task=blended", "method=H11,H111", "runs=10"))).hasSize(2);
        assertThat(names(study("task=blended,isolated", "method=1M", "saveTo=x")))
                .hasSize(2);
        assertThat(names(study("task=blended", "method=1M,2M", "base=pp"))).hasSize(2);
    }

    @Test
    void oneTaskWithoutAMethod_isTheDefaultMethod_asForTheMainJob() {
        assertThat(names(study("task=interleaved"))).containsExactly("interleaved-2M");
        assertThat(names(study("task=interleaved,isolated"))).containsExactly("interleaved-2M", "isolated-2M");
    }

    @Test
    void methodOfOneVersionOnly_isLeftOutOfTheOthers_andSaidSo() {
        Study study = study("task=blended,interleaved", "method=MT,MT2,1M");
        assertThat(names(study)).containsExactly("blended-MT2", "blended-1M", "interleaved-MT", "interleaved-1M");
        assertThat(study.remarks())
                .containsExactly(
                        "task=blended has no method MT (it has 1M, 2M, 3M, MMD, MT2, MT3): left out",
                        "task=interleaved has no method MT2 (it has 1M, 2M, 3M, MMD, MT): left out");
    }

    @Test
    void userTask_isAStudyOfOneExperiment() {
        String task = "task=" + XorTask.class.getName();
        assertThat(names(study(task, "method=3M"))).containsExactly("XorTask-3M");
    }

    @Test
    void impossibleRequests_areOneClearLine() {
        requireMistake("method=MT cannot be combined with task=blended; its methods are", "task=blended", "method=MT");
        requireMistake("task=interleaved has no method MT3", "task=interleaved,isolated", "method=MT3,MT2");
        requireMistake("method=4M: must be one of 1M", "task=blended", "method=4M");
        requireMistake("method=4M: must be one of 1M", "task=blended,isolated", "method=4M,1M");
        requireMistake("did you mean 'blended'?", "task=blendet,isolated");
        requireMistake("task is missing", "method=1M,2M");
        requireMistake("task is missing", "method=1M");
        requireMistake("task is missing", "task=", "method=all");
        requireMistake("a list takes blended", "task=" + XorTask.class.getName() + ",blended");
        requireMistake("a list takes blended", "task=" + XorTask.class.getName(), "method=1M,2M");
        requireMistake("unknown parameter 'tial'", "task=blended,isolated", "tial=3");
    }

    @Test
    void impossibleExperiment_isAnError_beforeAnyJobIsSubmitted() {
        requireMistake("none.txt: cannot be read", "task=isolated", "mazePowerPillGhostMapping=none.txt");
        requireMistake(
                "mmdRate=0.2 cannot be combined with multitaskModes=2", "task=interleaved", "method=MT", "mmdRate=0.2");
        requireMistake("disabledMode=2: the networks have modules 0 to 1", "task=blended", "disabledMode=2");
        requireMistake(
                "softmaxTemperature=0: must be positive",
                "task=blended",
                "softmaxModeSelection=true",
                "softmaxTemperature=0");
        requireMistake(
                "multitaskModes=2: MazeModeSelector chooses among 4 modules",
                "task=interleaved",
                "method=MT",
                "pacmanMultitaskScheme=MazeModeSelector");
    }

    @Test
    void completeRuns_areNotUnfinished(@TempDir Path folder) throws InterruptedException {
        String[] words = {"task=" + XorTask.class.getName(), "mu=2", "maxGens=1", "runs=3", "base=" + folder};
        Study study = study(words);
        ParameterReader reader = new ParameterReader(ParameterCatalogue.load());
        words[3] = "run=1";
        new ExperimentRunner(ExperimentPlan.of(reader.read(List.of(words)).parameters())).run();
        assertThat(study.parts().get(0).unfinishedRuns()).containsExactly(0, 2);
    }

    private static void requireMistake(String message, String... words) {
        assertThatThrownBy(() -> study(words))
                .isInstanceOf(UserError.class)
                .hasMessageContaining(message)
                .hasMessageNotContaining("\n");
    }
}
