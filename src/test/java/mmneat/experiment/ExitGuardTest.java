package mmneat.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import mmneat.CompiledClasses;
import mmneat.ProgramRun;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Foreign classes that end the program with exit code 0, in separate processes. */
class ExitGuardTest {

    @TempDir
    private static Path folder;

    private static Path classes;

    @BeforeAll
    static void compile() throws IOException {
        String leave = "System.exit(0);";
        classes = CompiledClasses.compile(
                folder,
                System.getProperty("java.class.path"),
                "package my; public class Leaves extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + " private static int games; public Leaves() { games++; }"
                        + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) {"
                        + " try { if (games == 3) { System.class.getMethod(\"exit\", int.class).invoke(null, 0); } }"
                        + " catch (ReflectiveOperationException e) { throw new IllegalStateException(e); }"
                        + " return pacman.game.Constants.MOVE.LEFT; } }",
                "package my; public class Sensor implements mmneat.mspacman.sensors.Sensor {"
                        + " public String label() { return \"x\"; }"
                        + " public double sense(mmneat.mspacman.sensors.Observation observation) {"
                        + " if (Boolean.getBoolean(\"leave\")) {" + leave + "} return 0; } }",
                "package my; public class Task implements mmneat.evolution.Task { public Task() {" + leave + "}"
                        + " public java.util.List<String> objectiveNames() { return null; }"
                        + " public java.util.List<String> inputLabels() { return null; }"
                        + " public int policyNeuronsPerModule() { return 1; }"
                        + " public mmneat.evolution.Evaluation evaluate(mmneat.neat.Genotype genotype,"
                        + " mmneat.random.ResumableRandom random) { return null; } }",
                "package my; public class Selection implements mmneat.nsga2.Selection {"
                        + " public int[] survivors(double[][] scores, int count, mmneat.random.ResumableRandom random) {"
                        + leave
                        + " return null; } public java.util.function.ToIntFunction<mmneat.random.ResumableRandom>"
                        + " parents(double[][] scores) { return random -> 0; } }");
    }

    private static ProgramRun program(boolean leaves, String... words) throws IOException, InterruptedException {
        return ProgramRun.java(
                folder,
                Stream.concat(
                                Stream.of("-Dleave=" + leaves, "-cp", ProgramRun.classPath(), "mmneat.cli.Main"),
                                Stream.of(words))
                        .toArray(String[]::new));
    }

    private static ProgramRun evolution(boolean leaves, String... words) throws IOException, InterruptedException {
        List<String> small = List.of("mu=2", "maxGens=1", "trials=1", "pacManLevelTimeLimit=100", "jar=" + classes);
        return program(leaves, Stream.concat(Stream.of(words), small.stream()).toArray(String[]::new));
    }

    @Test
    void controllerThatEndsTheProgramByReflection_losesNoFinishedGame() throws IOException, InterruptedException {
        ProgramRun run = program(false, "play", "classpath=" + classes, "pacman=Leaves", "games=5");
        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.output()).startsWith("my.Leaves against Legacy, 2 of 5 games");
        assertThat(run.errors())
                .contains("mmneat: my.Leaves ended the program by a call of exit in game 3 of 5;"
                        + " the result is that of the games before");
    }

    @Test
    void partThatEndsTheProgramDuringARun_isNoSuccess() throws IOException, InterruptedException {
        for (String way : List.of("parallelEvaluations=false", "parallelEvaluations=true")) {
            ProgramRun sensor = evolution(true, "task=blended", "base=" + way, "ownSensors=my.Sensor", way);
            assertThat(sensor.exitCode()).isEqualTo(1);
            assertThat(sensor.errors())
                    .contains("mmneat: my.Sensor ended the program by a call of exit; remove that call; every run is"
                            + " saved up to its last complete generation. To continue, give the same command again:");
        }
        ProgramRun selection = evolution(false, "task=blended", "base=selection", "selection=my.Selection");
        assertThat(selection.exitCode()).isEqualTo(1);
        assertThat(selection.errors()).contains("mmneat: my.Selection ended the program by a call of exit");
    }

    @Test
    void taskThatEndsTheProgramBeforeTheFirstRun_isNoSuccess() throws IOException, InterruptedException {
        ProgramRun run = evolution(false, "task=my.Task", "base=task");
        assertThat(run.exitCode()).isEqualTo(1);
        assertThat(run.errors().lines())
                .contains("mmneat: my.Task ended the program by a call of exit before the command was complete");
    }

    @Test
    void sensorThatEndsAnEvaluation_isNoSuccess() throws IOException, InterruptedException {
        ProgramRun evolved = evolution(false, "task=blended", "base=evaluated", "saveTo=run", "ownSensors=my.Sensor");
        assertThat(evolved.exitCode()).as(evolved.errors()).isZero();
        ProgramRun run = program(true, "evaluate", "evaluated", "jar=" + classes, "games=2");
        assertThat(run.exitCode()).as(run.output() + run.errors()).isEqualTo(1);
        assertThat(run.errors())
                .contains("mmneat: my.Sensor ended the program by a call of exit before the command was complete");
    }
}
