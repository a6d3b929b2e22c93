package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.parameters.Tasks;
import mmneat.experiment.store.GhostLocationsCopy;
import mmneat.experiment.store.RunParametersFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import pacman.game.GhostLocations;

/** An isolated run only needs its folder. */
class GhostLocationsCopyTest {

    @TempDir
    Path folder;

    private Path recording;

    @BeforeEach
    void userRecording() throws IOException {
        recording = Files.writeString(folder.resolve("mine.txt"), GhostLocations.shippedText() + "\n");
    }

    private RunPlan plan(String base, String... words) {
        List<String> all = new ArrayList<>(List.of("task=isolated", "base=" + folder.resolve(base)));
        all.addAll(Arrays.asList(words));
        return ExperimentPlan.of(
                        new ParameterReader(ParameterCatalogue.load()).read(all).parameters())
                .runs()
                .get(0);
    }

    private String asked() {
        return "mazePowerPillGhostMapping=" + recording;
    }

    @Test
    void copy_isTheFileThatWasAskedFor_orTheShippedOne() throws IOException {
        RunPlan mine = plan("mine", asked());
        GhostLocationsCopy.keep(mine.directory(), mine.parameters());
        assertThat(mine.directory().resolve("ghost-locations.txt")).hasSameBinaryContentAs(recording);
        RunPlan shipped = plan("shipped");
        GhostLocationsCopy.keep(shipped.directory(), shipped.parameters());
        assertThat(shipped.directory().resolve("ghost-locations.txt")).hasContent(GhostLocations.shippedText());
    }

    @Test
    void startedRun_usesItsCopy_evenIfTheFileChanges() throws IOException {
        RunPlan run = plan("run", asked());
        assertThat(GhostLocationsCopy.parameters(run.directory(), run.parameters())
                        .text(Tasks.GHOST_LOCATIONS))
                .isEqualTo(recording.toString());
        GhostLocationsCopy.keep(run.directory(), run.parameters());
        Files.delete(recording);
        GhostLocationsCopy.requireSame(run.directory(), run.parameters());
        assertThat(GhostLocationsCopy.parameters(run.directory(), run.parameters())
                        .text(Tasks.GHOST_LOCATIONS))
                .isEqualTo(run.directory().resolve("ghost-locations.txt").toString());
        assertThat(Tasks.factory(GhostLocationsCopy.parameters(run.directory(), run.parameters()))
                        .get()
                        .inputs())
                .isEqualTo(26);
    }

    @Test
    void otherLocationsThanAtTheStartOfTheRun_areAnError() throws IOException {
        RunPlan run = plan("run");
        GhostLocationsCopy.keep(run.directory(), run.parameters());
        GhostLocationsCopy.requireSame(run.directory(), run.parameters());
        RunPlan other = plan("run", asked());
        assertThatThrownBy(() -> GhostLocationsCopy.requireSame(other.directory(), other.parameters()))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("was begun with other ghost locations than " + asked());
    }

    @Test
    void savedParameters_referToTheCopy_whereverTheFolderIs() throws IOException {
        RunPlan run = plan("run", asked());
        GhostLocationsCopy.keep(run.directory(), run.parameters());
        new RunParametersFile(run.directory()).write(run.parameters());
        assertThat(run.directory().resolve("parameters.properties"))
                .content()
                .contains("mazePowerPillGhostMapping=ghost-locations.txt");
        Path moved = Files.move(run.directory(), folder.resolve("moved"));
        assertThat(plan("again", "config=" + moved.resolve("parameters.properties"))
                        .parameters()
                        .text(Tasks.GHOST_LOCATIONS))
                .isEqualTo(moved.resolve("ghost-locations.txt").toString());
    }
}
