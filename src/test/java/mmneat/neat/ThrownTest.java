package mmneat.neat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Messages about exceptions whose own methods misbehave. */
class ThrownTest {

    private static class Hostile extends RuntimeException {
        @Override
        public String getMessage() {
            throw new IllegalStateException("no message");
        }

        @Override
        public String toString() {
            throw new IllegalStateException("no text");
        }

        @Override
        public synchronized Throwable getCause() {
            throw new IllegalStateException("no cause");
        }

        @Override
        public StackTraceElement[] getStackTrace() {
            throw new IllegalStateException("no trace");
        }

        @Override
        public void printStackTrace(PrintWriter writer) {
            throw new IllegalStateException("no print");
        }
    }

    private static class Silent extends RuntimeException {
        @Override
        public String toString() {
            return null;
        }

        @Override
        public StackTraceElement[] getStackTrace() {
            return new StackTraceElement[] {null};
        }
    }

    private static class Endless extends RuntimeException {
        @Override
        public synchronized Throwable getCause() {
            return new Endless();
        }
    }

    @Test
    void hostileException_isNamedByItsClass() {
        Thrown thrown = new Thrown(new Hostile());
        assertThat(thrown.line()).isEqualTo(Hostile.class.getName());
        assertThat(thrown.trace()).isEqualTo(Hostile.class.getName() + System.lineSeparator());
        assertThat(thrown.message()).isEmpty();
        assertThat(thrown.place()).isEmpty();
        assertThat(thrown.causes()).containsExactly(thrown.exception());
    }

    @Test
    void missingAnswers_areLeftOut() {
        Thrown thrown = new Thrown(new Silent());
        assertThat(thrown.line()).isEqualTo(Silent.class.getName());
        assertThat(thrown.place()).isEmpty();
    }

    @Test
    void causes_endAtACycle_andAfterAHundred() {
        RuntimeException first = new RuntimeException();
        RuntimeException second = new RuntimeException(first);
        first.initCause(second);
        assertThat(new Thrown(first).causes()).isEqualTo(List.of(first, second));
        assertThat(new Thrown(new Endless()).causes()).hasSize(100);
        assertThat(BadPartException.in(first)).isEmpty();
        assertThat(BadPartException.in(new RuntimeException(new BadPartException("part", "problem"))))
                .isPresent();
    }

    @Test
    void lines_haveNoLineBreaks() {
        Thrown thrown = new Thrown(new IllegalStateException("two\nlines\u2028"));
        assertThat(thrown.line()).isEqualTo("java.lang.IllegalStateException: two?lines?");
        assertThat(new BadPartException("part", thrown.exception())).message().doesNotContain("\n", "\u2028");
    }

    @Test
    void endlessRecursion_isAFailureOfTheCode_exhaustedMemoryIsNot() {
        assertThat(new Thrown(new StackOverflowError()).isOfTheMachine()).isFalse();
        assertThat(new Thrown(new OutOfMemoryError()).isOfTheMachine()).isTrue();
        assertThat(new Thrown(new Error()).isOfTheMachine()).isFalse();
    }
}
