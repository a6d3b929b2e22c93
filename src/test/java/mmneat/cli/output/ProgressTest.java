package mmneat.cli.output;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import mmneat.experiment.run.RunMonitor.Phase;
import mmneat.experiment.run.RunMonitor.Snapshot;
import org.junit.jupiter.api.Test;

class ProgressTest {

    private static Snapshot in(Phase phase) {
        return new Snapshot(phase, 0, 200, Double.NaN, Double.NaN, 0, 0, null);
    }

    @Test
    void runsDone_areThoseFinishedNowOrBefore() {
        assertThat(Progress.counts(
                        List.of(in(Phase.FINISHED), in(Phase.ALREADY_FINISHED), in(Phase.RUNNING), in(Phase.WAITING))))
                .isEqualTo("2 of 4 done");
    }

    @Test
    void runsThatThisProcessWillNotFinish_areNotDone() {
        assertThat(Progress.counts(List.of(in(Phase.FAILED), in(Phase.IN_USE), in(Phase.FINISHED), in(Phase.IN_USE))))
                .isEqualTo("1 of 4 done, 2 in use elsewhere, 1 failed");
    }
}
