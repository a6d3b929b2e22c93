package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.atomic.AtomicLong;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class CheckpointScheduleTest {

    private final AtomicLong now = new AtomicLong();

    @Test
    void auto_savesTheFirstAndTheLast_andOthersAtMostOnceASecond() {
        CheckpointSchedule schedule = CheckpointSchedule.of("auto", now::get);
        assertThat(schedule.isDue(1, false)).isTrue();
        schedule.done();
        now.addAndGet(999_999_999);
        assertThat(schedule.isDue(2, false)).isFalse();
        assertThat(schedule.isDue(2, true)).isTrue();
        now.addAndGet(1);
        assertThat(schedule.isDue(3, false)).isTrue();
        schedule.done();
        assertThat(schedule.isDue(4, false)).isFalse();
    }

    @Test
    void number_savesAtItsMultiples_whateverTheTime() {
        CheckpointSchedule schedule = CheckpointSchedule.of("5", now::get);
        assertThat(schedule.isDue(1, false)).isTrue();
        schedule.done();
        now.addAndGet(10_000_000_000L);
        assertThat(schedule.isDue(4, false)).isFalse();
        assertThat(schedule.isDue(5, false)).isTrue();
        assertThat(schedule.isDue(7, true)).isTrue();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "0", "-1", "Auto", "1.5", "9999999999"})
    void anythingElse_isRefused(String text) {
        assertThatThrownBy(() -> CheckpointSchedule.of(text, now::get))
                .isInstanceOf(UserError.class)
                .hasMessage("checkpointEvery=" + text + ": must be auto or a whole number of generations, at least 1");
    }
}
