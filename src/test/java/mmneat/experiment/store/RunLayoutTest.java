package mmneat.experiment.store;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Names and columns of a run's files; the golden runs check the names themselves. */
class RunLayoutTest {

    @Test
    void championScore_isInTheColumnsOfTheSpecification() {
        assertThat(RunLayout.championScoreColumnOfTable()).isEqualTo(2);
        assertThat(RunLayout.championScoreColumnOfLog()).isEqualTo(12);
    }

    @Test
    void names_equalTheOriginals() {
        assertThat(RunLayout.network("Blended-2M3_", 0, 7)).isEqualTo("initial/Blended-2M3_initial_7.xml");
        assertThat(RunLayout.network("Blended-2M3_", 12, 7)).isEqualTo("gen12/Blended-2M3_gen12_7.xml");
        assertThat(RunLayout.isNetworksFolder("initial")).isTrue();
        assertThat(RunLayout.isNetworksFolder("gen12")).isTrue();
        assertThat(RunLayout.isNetworksFolder("genes")).isFalse();
        assertThat(RunLayout.log("X0_", RunLayout.MODULE_COUNTS)).isEqualTo("X0_ModeUsage_log.txt");
        assertThat(RunLayout.otherScores("X0_", RunLayout.CHILDREN, 4)).isEqualTo("X0_child_other_scores_gen4.txt");
        assertThat(RunLayout.evaluationReport("X0_", 55)).isEqualTo("X0_Eval-Net55_log.txt");
    }

    @Test
    void filesOfTheOriginal_areFoundInItsFolder_oursAreTakenFirst(@TempDir Path folder) throws IOException {
        assertThat(RunLayout.parentsLogIn(folder)).isEmpty();
        assertThat(RunLayout.prefixIn(folder)).isEmpty();
        assertThat(RunLayout.parametersIn(folder)).isEmpty();
        assertThat(RunLayout.championIn(folder)).isEmpty();

        Files.writeString(folder.resolve("Blended-AVG_parents_log.txt"), "");
        assertThat(RunLayout.parentsLogIn(folder)).isEmpty();
        Path log = Files.writeString(folder.resolve("Blended-2M3_parents_log.txt"), "");
        assertThat(RunLayout.parentsLogIn(folder)).contains(log);
        assertThat(RunLayout.prefixIn(folder)).isEqualTo("Blended-2M3_");

        Path theirParameters = Files.writeString(folder.resolve("Blended-2M3_parameters.txt"), "");
        assertThat(RunLayout.parametersIn(folder)).contains(theirParameters);
        Path parameters = Files.writeString(folder.resolve("parameters.properties"), "");
        assertThat(RunLayout.parametersIn(folder)).contains(parameters);

        Files.createDirectory(folder.resolve("bestPacMan"));
        Path theirChampion = Files.writeString(folder.resolve("bestPacMan/bestPacMan.xml"), "");
        assertThat(RunLayout.championIn(folder)).contains(theirChampion);
        assertThat(RunLayout.isNamedAsChampion(theirChampion)).isTrue();
        assertThat(RunLayout.isNamedAsChampion(Path.of("bestPacMan.xml"))).isTrue();
        Path champion = Files.writeString(folder.resolve("champion.json"), "");
        assertThat(RunLayout.championIn(folder)).contains(champion);
        assertThat(RunLayout.isNamedAsChampion(champion)).isTrue();
        assertThat(RunLayout.isNamedAsOriginalChampion(champion)).isFalse();
        assertThat(RunLayout.isNamedAsChampion(folder.resolve("gen12/X0_gen12_7.xml")))
                .isFalse();
    }
}
