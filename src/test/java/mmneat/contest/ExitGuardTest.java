package mmneat.contest;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import mmneat.CompiledClasses;
import mmneat.ProgramRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Controllers that end the program in ways that their byte code does not show, in separate processes. */
class ExitGuardTest {

    @TempDir
    private Path folder;

    @Test
    void endByReflection_isNoSuccess_andTheFinishedGamesAreReported() throws IOException, InterruptedException {
        Path classes = CompiledClasses.compile(
                folder,
                System.getProperty("java.class.path"),
                "public class Leaves extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + " private static int games; public Leaves() { games++; }"
                        + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) {"
                        + " try { if (games == 3) { System.class.getMethod(\"exit\", int.class).invoke(null, 0); } }"
                        + " catch (ReflectiveOperationException e) { throw new IllegalStateException(e); }"
                        + " return pacman.game.Constants.MOVE.LEFT; } }");
        ProgramRun run = ProgramRun.java(
                folder,
                "-cp",
                ProgramRun.classPath(),
                "mmneat.cli.Main",
                "play",
                "classpath=" + classes,
                "pacman=Leaves",
                "games=5");
        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.output()).startsWith("Leaves against Legacy, 2 of 5 games");
        assertThat(run.errors())
                .contains("the program was ended in game 3 of 5; the result is that of the games before");
    }
}
