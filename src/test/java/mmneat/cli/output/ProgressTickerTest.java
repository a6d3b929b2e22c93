package mmneat.cli.output;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;

class ProgressTickerTest {

    private final StringWriter text = new StringWriter();
    private final PrintWriter out = new PrintWriter(text, true);

    @Test
    void log_getsTheCurrentLines_withoutEscapes() throws InterruptedException {
        CountDownLatch asked = new CountDownLatch(1);
        String result = ProgressTicker.during(
                out,
                () -> {
                    asked.countDown();
                    return List.of("3 of 4 games");
                },
                () -> {
                    asked.await();
                    return "done";
                });
        assertThat(result).isEqualTo("done");
        assertThat(text.toString().lines()).containsExactly("3 of 4 games");
    }

    @Test
    void shortWork_showsNothing() {
        assertThat(ProgressTicker.during(out, () -> List.of("line"), () -> 7)).isEqualTo(7);
        assertThat(text.toString()).isEmpty();
    }

    @Test
    void failureOfTheWork_isPassedOn() {
        assertThatThrownBy(() -> ProgressTicker.during(out, List::of, () -> {
                    throw new IOException("broken");
                }))
                .isInstanceOf(IOException.class);
    }
}
