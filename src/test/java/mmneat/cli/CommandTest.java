package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import picocli.CommandLine;

/** Base class that runs the program's commands and captures their output. */
abstract class CommandTest {

    /** Standard output of the last command. */
    final StringWriter out = new StringWriter();

    /** Standard error of the last command. */
    final StringWriter errors = new StringWriter();

    /** Runs a command and returns its exit code. */
    final int execute(String... arguments) {
        return execute(Main.commandLine(), arguments);
    }

    /** Runs a command with a command line that a test has changed. */
    final int execute(CommandLine line, String... arguments) {
        out.getBuffer().setLength(0);
        errors.getBuffer().setLength(0);
        line.setOut(new PrintWriter(out, true));
        line.setErr(new PrintWriter(errors, true));
        return line.execute(arguments);
    }

    /** Asserts a user's error: exit code 2, one line that says what is wrong, and no result. */
    final void assertMistake(String message, String... arguments) {
        assertThat(execute(arguments)).isEqualTo(2);
        assertThat(errors.toString().lines()).hasSize(1);
        assertThat(errors.toString()).contains(message);
        assertThat(out.toString()).isEmpty();
    }
}
