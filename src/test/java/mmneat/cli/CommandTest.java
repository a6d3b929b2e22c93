package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import picocli.CommandLine;

/** Runs the program's commands as its command line does, and keeps what they print. */
abstract class CommandTest {

    /** What the last command printed as its result. */
    final StringWriter out = new StringWriter();

    /** What the last command printed beside it. */
    final StringWriter errors = new StringWriter();

    /** Runs a command, and gives its exit code. */
    final int execute(String... arguments) {
        return execute(Main.commandLine(), arguments);
    }

    /** The same with a command line that a test has changed. */
    final int execute(CommandLine line, String... arguments) {
        out.getBuffer().setLength(0);
        errors.getBuffer().setLength(0);
        line.setOut(new PrintWriter(out, true));
        line.setErr(new PrintWriter(errors, true));
        return line.execute(arguments);
    }

    /** A user's mistake: exit code 2, one line that says what is wrong, and no result. */
    final void assertMistake(String message, String... arguments) {
        assertThat(execute(arguments)).isEqualTo(2);
        assertThat(errors.toString().lines()).hasSize(1);
        assertThat(errors.toString()).contains(message);
        assertThat(out.toString()).isEmpty();
    }
}
