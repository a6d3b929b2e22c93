package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.InvalidPathException;
import java.util.List;
import java.util.concurrent.Callable;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Command;

class MainTest extends CommandTest {

    private int execute(Object extraCommand, String... arguments) {
        CommandLine line = Main.commandLine();
        line.addSubcommand(extraCommand);
        return execute(line, arguments);
    }

    @Command(name = "mistake")
    static final class Mistake implements Runnable {
        @Override
        public void run() {
            throw new UserError("no such thing; try another");
        }
    }

    @Command(name = "failure")
    static final class Failure implements Runnable {
        @Override
        public void run() {
            throw new IllegalStateException("broken");
        }
    }

    @Test
    void userError_isOneLine_andExitsWith2() {
        assertThat(execute(new Mistake(), "mistake")).isEqualTo(2);
        assertThat(errors.toString().lines()).containsExactly("mmneat: no such thing; try another");
        assertThat(out.toString()).isEmpty();
    }

    @Test
    void anyOtherException_printsAStackTrace_andExitsWith1() {
        assertThat(execute(new Failure(), "failure")).isEqualTo(1);
        assertThat(errors.toString()).contains("IllegalStateException: broken").contains("at mmneat.cli.MainTest");
    }

    @Command(name = "file")
    static final class FileFailure implements Callable<Integer> {
        @Override
        public Integer call() throws IOException {
            throw new AccessDeniedException("results");
        }
    }

    @Command(name = "name")
    static final class NameFailure implements Runnable {
        @Override
        public void run() {
            throw new InvalidPathException("\u00fc", "Malformed input");
        }
    }

    @Test
    void fileError_isOneLine_andExitsWith2() {
        assertThat(execute(new FileFailure(), "file")).isEqualTo(2);
        assertThat(errors.toString().lines()).containsExactly("mmneat: results: permission denied");
        assertThat(execute(new NameFailure(), "name")).isEqualTo(2);
        assertThat(errors.toString().lines()).singleElement().asString().contains("LC_ALL=C.UTF-8");
    }

    @Test
    void unknownOption_isOneLine_andExitsWith2() {
        assertThat(execute(new Mistake(), "mistake", "--nonsense")).isEqualTo(2);
        assertThat(errors.toString().lines()).hasSize(1);
        assertThat(errors.toString()).contains("--nonsense").contains("mistake --help");
    }

    @Test
    void helpOfACommandThatDoesNotExist_isAnError() {
        assertMistake("'hv' is not a command", "hv", "--help");
        assertMistake("'hv' is not a command", "--help", "hv");
        assertMistake("'multiple' is not a command", "multiple", "-h");
        assertMistake("'wach' is not a command (did you mean 'watch'?)", "wach", "--help");
        assertMistake("'hv' is not a command", "hv", "--version");
        assertThat(execute("task=blended", "--help")).isZero();
        assertThat(execute("help", "--help")).isZero();
    }

    @Test
    void emptyArgument_isAPlainMistake() {
        for (String command : List.of("compare", "evaluate", "report")) {
            assertMistake("'' is not a name: give EXPERIMENT", command, "");
        }
        for (String command : List.of("network", "watch", "replay", "record-ghosts", "status", "params")) {
            assertMistake("'' is not a name: give ", command, "");
            assertMistake("' ' is not a name: give ", command, " ");
        }
    }

    @Test
    void help_andVersion_succeed() {
        assertThat(execute(new Mistake(), "--help")).isZero();
        assertThat(out.toString()).contains("Usage: mmneat");
        assertThat(errors.toString()).isEmpty();
        assertThat(execute(new Mistake(), "--version")).isZero();
        assertThat(out.toString()).contains("MM-NEAT (not packaged)");
        assertThat(errors.toString()).isEmpty();
    }
}
