package mmneat.analysis.evaluation;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import mmneat.GoldenData;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.run.ExperimentPlan;
import mmneat.experiment.run.ExperimentRunner;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

@Tag("conformance")
class EvaluationReportConformanceTest {

    @TempDir
    Path base;

    /** The run that left the golden logs, made again, and its champion evaluated with three trials. */
    @Test
    void reportOfAChampion_isTheOriginals_byteForByte() throws Exception {
        Path golden = GoldenData.folder("logs").resolve("P-MMD0_Eval-Net4_log.txt");
        ExperimentPlan plan = ExperimentPlan.of(new ParameterReader(ParameterCatalogue.load())
                .read(List.of(
                        "task=blended",
                        "method=MMD",
                        "mu=6",
                        "maxGens=3",
                        "trials=2",
                        "runNumber=0",
                        "randomSeed=3",
                        "log=P-MMD",
                        "saveTo=MMD",
                        "base=" + base))
                .parameters());
        new ExperimentRunner(plan).run();
        Champion champion = Champion.read(base.resolve("MMD0"));
        Path report = EvaluationReport.write(
                champion, PlayerSettings.of(champion, Optional.empty(), Rules.TRAINING, Optional.empty()), 3);
        assertThat(report.getFileName()).hasToString("P-MMD0_Eval-Net4_log.txt");
        assertThat(Files.readString(report)).isEqualTo(Files.readString(golden).replace("\r\n", "\n"));
    }
}
