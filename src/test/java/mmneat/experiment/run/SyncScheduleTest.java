package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class SyncScheduleTest {

    private long nanos = Long.MAX_VALUE - 5;
    private final SyncSchedule schedule = new SyncSchedule(() -> nanos);

    @Test
    void firstTime_isAlwaysDue() {
        assertThat(schedule.isDue(0)).isTrue();
        schedule.done();
        assertThat(schedule.isDue(0)).isFalse();
    }

    @Test
    void halfAMinute_isTheLongest() {
        schedule.done();
        nanos += Duration.ofSeconds(30).toNanos() - 1;
        assertThat(schedule.isDue(499)).isFalse();
        nanos++;
        assertThat(schedule.isDue(0)).isTrue();
        schedule.done();
        assertThat(schedule.isDue(0)).isFalse();
    }

    @Test
    void fiveHundredFiles_areTheMost() {
        schedule.done();
        assertThat(schedule.isDue(499)).isFalse();
        assertThat(schedule.isDue(500)).isTrue();
    }
}
