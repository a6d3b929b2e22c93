package mmneat.cli;

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
}
