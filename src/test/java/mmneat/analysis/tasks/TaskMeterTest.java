package mmneat.analysis.tasks;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.function.Supplier;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.NetworkPacMan;
import mmneat.mspacman.TaskVersion;
import org.junit.jupiter.api.Test;
import pacman.controllers.Controller;
import pacman.controllers.examples.NearestPillPacMan;
import pacman.controllers.examples.RandomPacMan;
import pacman.controllers.examples.StarterPacMan;
import pacman.game.Constants.MOVE;
import pacman.game.GhostLocations;

/** Thrashing rates and overlaps, and the versions that follow from them. */
class TaskMeterTest {

    private static final int GAMES = 20;

    private static Supplier<Controller<MOVE>> champion(String version) {
        return () -> NetworkPacMan.published(ShippedChampions.read(version).genotype(), null, 0);
    }

    private static TaskMeasurement measure(MsPacManTaskSettings settings, Supplier<Controller<MOVE>> player) {
        return new TaskMeter(settings, TaskDivision.usual(settings.games().version()))
                .measure(player, GAMES, 1, played -> {});
    }

    private static Episode episode(int... tasks) {
        Episode.Counter counter = new Episode.Counter(2);
        for (int bits : tasks) {
            counter.step(bits);
        }
        return counter.finish(0);
    }

    @Test
    void switches_areChangesOfTheTask_perTimeStep() {
        Episode episode = episode(0, 1, 1, 2, 0, 2, 1, 3, 3, 0);
        assertThat(episode.steps()).isEqualTo(10);
        assertThat(episode.switches()).isEqualTo(3);
        assertThat(episode.thrashingRate()).isEqualTo(0.3);
        assertThat(episode.overlapping()).isEqualTo(2);
        assertThat(episode.overlaps()).isDeepEqualTo(new int[][] {{5, 2}, {2, 4}});
    }

    @Test
    void kind_followsFromOverlapAndRate() {
        TaskDivision division = TaskDivision.named("threats,edible");
        assertThat(new TaskMeasurement(division, List.of(episode(1, 1), episode(2))).version())
                .isEqualTo(TaskVersion.ISOLATED);
        int[] seldom = new int[200];
        java.util.Arrays.fill(seldom, 1);
        seldom[199] = 2;
        assertThat(new TaskMeasurement(division, List.of(episode(seldom))).version())
                .isEqualTo(TaskVersion.INTERLEAVED);
        assertThat(new TaskMeasurement(division, List.of(episode(1, 2))).version())
                .isEqualTo(TaskVersion.BLENDED);
        seldom[199] = 3;
        assertThat(new TaskMeasurement(division, List.of(episode(seldom))).version())
                .isEqualTo(TaskVersion.BLENDED);
    }

    @Test
    void interleavedVersion_staysBelowThePapersBound_forEveryPlayer() {
        List<Supplier<Controller<MOVE>>> players = List.of(
                champion("interleaved"),
                champion("blended"),
                NearestPillPacMan::new,
                StarterPacMan::new,
                RandomPacMan::new);
        for (Supplier<Controller<MOVE>> player : players) {
            TaskMeasurement measured = measure(MsPacManTaskSettings.interleaved(), player);
            assertThat(measured.thrashingRates().getMean()).isLessThan(TaskMeasurement.INTERLEAVED_BOUND);
            assertThat(measured.overlap()).isZero();
        }
        assertThat(measure(MsPacManTaskSettings.interleaved(), champion("interleaved"))
                        .version())
                .isEqualTo(TaskVersion.INTERLEAVED);
    }

    @Test
    void blendedVersion_hasOverlappingTasks() {
        TaskMeasurement measured = measure(MsPacManTaskSettings.blended(), champion("blended"));
        assertThat(measured.version()).isEqualTo(TaskVersion.BLENDED);
        assertThat(measured.share(0, 1)).isPositive().isEqualTo(measured.overlap());
        assertThat(measured.share(0, 0)).isBetween(measured.overlap(), 1.0);
    }

    @Test
    void isolatedVersion_neverChangesTheTaskWithinAGame() {
        MsPacManTaskSettings isolated = MsPacManTaskSettings.isolated(GhostLocations.shipped());
        TaskMeasurement measured = new TaskMeter(isolated, TaskDivision.usual(TaskVersion.ISOLATED))
                .measure(champion("isolated"), 2, 1, played -> {});
        assertThat(measured.episodes()).hasSize(10);
        assertThat(measured.version()).isEqualTo(TaskVersion.ISOLATED);
    }

    @Test
    void sameSeed_sameEpisodes() {
        assertThat(measure(MsPacManTaskSettings.blended(), NearestPillPacMan::new)
                        .thrashingRates()
                        .getValues())
                .isEqualTo(measure(MsPacManTaskSettings.blended(), NearestPillPacMan::new)
                        .thrashingRates()
                        .getValues());
    }

    @Test
    void modulesOfADivision_areTasks_thatNeverOverlap() {
        TaskDivision division = TaskDivision.named("GhostThreatEdibleOrBothModeSelector");
        assertThat(division.tasks()).hasSize(3);
        TaskMeasurement measured = new TaskMeter(MsPacManTaskSettings.blended(), division)
                .measure(NearestPillPacMan::new, 5, 1, played -> {});
        assertThat(measured.overlap()).isZero();
        assertThat(measured.share(0, 0) + measured.share(1, 1) + measured.share(2, 2))
                .isEqualTo(1, org.assertj.core.api.Assertions.within(1e-12));
    }

    @Test
    void unknownPredicate_isNamed() {
        assertThatThrownBy(() -> TaskDivision.named("threats,edibel"))
                .isInstanceOf(UserError.class)
                .hasMessage("predicates=threats,edibel: 'edibel' is not one of threats, edible, pills, noPills");
        assertThatThrownBy(() -> TaskDivision.named("threats,threats"))
                .isInstanceOf(UserError.class)
                .hasMessage("predicates=threats,threats: 'threats' is named twice");
        assertThatThrownBy(() -> TaskDivision.named("nothing"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("must be two or more of threats, edible, pills, noPills");
    }
}
