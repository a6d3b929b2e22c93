package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import mmneat.CompiledClasses;
import mmneat.ProgramRun;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The command play with competition entries: their class paths, arguments, failures and punctuality. */
class PlayEntriesTest extends CommandTest {

    @TempDir
    private Path folder;

    private String scoreLine() {
        return out.toString().lines().toList().get(1);
    }

    /** Compiles Ms. Pac-Man controllers in package my. */
    private Path compiled(String... classes) throws IOException {
        String[] sources = new String[classes.length / 2];
        for (int i = 0; i < sources.length; i++) {
            sources[i] = "package my; public class " + classes[2 * i]
                    + " extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                    + " private static int games; public " + classes[2 * i] + "() { games++; }"
                    + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) { "
                    + classes[2 * i + 1] + " } }";
        }
        return CompiledClasses.compile(
                Files.createTempDirectory(folder, "entry"), System.getProperty("java.class.path"), sources);
    }

    /** A controller that answers LEFT, and fails in its third game. */
    private Path failingInItsThirdGame() throws IOException {
        return compiled(
                "Third",
                "if (games == 3 && game.getTotalTime() == 9) { throw new IllegalStateException(\"tired\"); }"
                        + " return pacman.game.Constants.MOVE.LEFT;");
    }

    @Test
    void timedGames_reportThePunctualityOfEachSide() throws IOException {
        // A null move ends the game by MM-NEAT's rules in its twelfth step.
        Path classes = compiled("Silent", "return null;");
        for (String timed : List.of("true", "fast")) {
            assertThat(execute("play", "timed=" + timed, "classpath=" + classes, "pacman=Silent", "rules=mmneat"))
                    .isZero();
            assertThat(out.toString())
                    .contains(timed.equals("fast") ? ", timed, at most 40 ms per step" : ", timed, 40 ms per step")
                    .containsPattern("Ms. Pac-Man: late answers \\d+, exceptions 0, repeated moves \\d+ of 12")
                    .containsPattern("ghosts: late answers \\d+, exceptions 0, repeated moves \\d+ of 12");
        }
        assertMistake("timed=slow: must be one of false, true, fast", "play", "timed=slow");
    }

    @Test
    void timedControllerThatThrows_isReported() throws IOException {
        Path classes = compiled("Throws", "throw new IllegalStateException(\"never\");");
        String[] words = {"play", "timed=fast", "classpath=" + classes, "pacman=Throws", "rules=mmneat", "games=2"};
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> {});
        try {
            assertThat(execute(words)).isEqualTo(2);
            assertThat(errors.toString())
                    .contains("my.Throws threw an exception in game 1")
                    .contains("mmneat: my.Throws failed: java.lang.IllegalStateException: never; game 1 of 2 ended");
            assertThat(out.toString()).contains("1 of 2 games").contains("exceptions 1, repeated moves 12 of 12");
            words[5] = "onFailure=skip";
            assertThat(execute(words)).isEqualTo(2);
            assertThat(errors.toString()).contains("no game was played to its end: my.Throws failed");
            words[5] = "onFailure=score0";
            assertThat(execute(words)).isZero();
            assertThat(out.toString()).contains("score: mean 0.0");
        } finally {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
    }

    @Test
    void failureInALaterGame_losesNoFinishedGame() throws IOException {
        String[] words = {"play", "classpath=" + failingInItsThirdGame(), "pacman=Third", "games=5", "onFailure=stop"};
        assertThat(execute(words)).isEqualTo(2);
        assertThat(out.toString())
                .startsWith("my.Third against Legacy, 2 of 5 games")
                .contains("failures: 1 game failed, the contest ended there; game 3: my.Third failed");
        assertThat(errors.toString()).contains("my.Third failed: java.lang.IllegalStateException: tired; game 3 of 5");

        words[1] = "classpath=" + failingInItsThirdGame();
        words[4] = "onFailure=skip";
        assertThat(execute(words)).isZero();
        assertThat(out.toString()).contains("4 of 5 games").contains("it is left out");
        assertThat(out.toString()).doesNotContain("minimum 0,");

        words[1] = "classpath=" + failingInItsThirdGame();
        words[4] = "onFailure=score0";
        assertThat(execute(words)).isZero();
        assertThat(out.toString()).contains(", 5 games").contains("minimum 0,").contains("it counts with score 0");
    }

    @Test
    void recursionMemoryAndEnds_areFailuresToo() throws IOException {
        Path classes = compiled(
                "Deep", "return getMove(game, due);",
                "Fat",
                        "java.util.List<long[]> all = new java.util.ArrayList<>();"
                                + " while (true) { all.add(new long[Integer.MAX_VALUE]); }",
                "Leaves", "System.exit(0); return null;",
                "Halts", "Runtime.getRuntime().halt(0); return null;");
        for (String[] name : new String[][] {
            {"Deep", "java.lang.StackOverflowError"},
            {"Fat", "java.lang.OutOfMemoryError"},
            {"Leaves", "the controller called System.exit(0) to end the program"},
            {"Halts", "the controller called Runtime.halt(0) to end the program"}
        }) {
            assertThat(execute("play", "classpath=" + classes, "pacman=" + name[0], "games=2"))
                    .isEqualTo(2);
            assertThat(errors.toString())
                    .contains("my." + name[0] + " failed: ")
                    .contains(name[1]);
            assertThat(errors.toString().lines().count()).isLessThan(40);
        }
    }

    @Test
    void controllerThatNeverAnswers_losesItsGameAfterTheMoveLimit() throws IOException {
        Path classes = compiled(
                "Ponders",
                "while (games == 2 && game.getTotalTime() == 3) { Thread.onSpinWait();"
                        + " if (Thread.currentThread().isInterrupted()) { throw new IllegalStateException(); } }"
                        + " return pacman.game.Constants.MOVE.LEFT;");
        assertThat(execute("play", "classpath=" + classes, "pacman=Ponders", "games=3", "moveLimit=1"))
                .isEqualTo(2);
        assertThat(out.toString()).contains("1 of 3 games");
        assertThat(errors.toString().lines())
                .containsExactly("mmneat: my.Ponders failed: did not answer for 1 s; game 2 of 3 ended the contest;"
                        + " onFailure=skip or onFailure=score0 plays on");
        assertMistake("moveLimit=1 has no effect here", "play", "timed=fast", "moveLimit=1");
        assertMistake("moveLimit=0: must be a whole number, at least 1", "play", "moveLimit=0");
    }

    @Test
    void constructorThatThrows_isOneLine_andLosesNoFinishedGame() throws IOException {
        Path classes = CompiledClasses.compile(
                folder,
                System.getProperty("java.class.path"),
                "package my; public class Second extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + " private static int games;"
                        + " public Second() { if (++games == 2) { throw new IllegalStateException(\"full\"); } }"
                        + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) {"
                        + " return pacman.game.Constants.MOVE.LEFT; } }");
        assertThat(execute("play", "classpath=" + classes, "pacman=Second", "games=4"))
                .isEqualTo(2);
        assertThat(out.toString()).contains("1 of 4 games");
        assertThat(errors.toString().lines()).hasSize(1);
        assertThat(errors.toString())
                .contains("the constructor of my.Second threw java.lang.IllegalStateException: full; game 2 of 4");
    }

    /** The entry fills the heap with small objects in a static field, in a process with little memory. */
    @Test
    void entryThatKeepsAllMemory_losesNoFinishedGame() throws IOException, InterruptedException {
        Path classes = compiled(
                "Keeps",
                "java.util.List<Object> all = KEPT; while (games == 2) { all.add(new Object()); }"
                        + " return pacman.game.Constants.MOVE.LEFT; }"
                        + " private static final java.util.List<Object> KEPT = new java.util.LinkedList<>(); {");
        ProgramRun run = ProgramRun.java(
                folder,
                "-Xmx160m",
                "-XX:+UseSerialGC",
                "-cp",
                ProgramRun.classPath(),
                "mmneat.cli.Main",
                "play",
                "classpath=" + classes,
                "pacman=Keeps",
                "games=3");
        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.output()).startsWith("my.Keeps against Legacy, 1 of 3 games");
        assertThat(run.errors()).contains("java.lang.OutOfMemoryError").contains("game 2 of 3 ended the contest");
    }

    @Test
    void memberThatTheCompetitionNeverHad_isNamedWhenItIsMissed() throws IOException {
        Path later = CompiledClasses.compile(
                folder.resolve("api"),
                System.getProperty("java.class.path"),
                "package pacman.game; public class Game { public int getShield() { return 1; } }",
                "package pacman.controllers; public abstract class Controller<T> {"
                        + " public abstract T getMove(pacman.game.Game game, long due); }");
        Path classes = CompiledClasses.compile(
                folder.resolve("entry"),
                later + java.io.File.pathSeparator + System.getProperty("java.class.path"),
                "package my; public class Later extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) {"
                        + " return pacman.game.Constants.MOVE.values()[game.getShield()]; } }");
        assertThat(execute("play", "classpath=" + classes, "pacman=Later")).isEqualTo(2);
        assertThat(errors.toString())
                .contains("getShield")
                .contains("release 6.2 of the competition has no such member");
    }

    @Test
    void moveLimit_changesNoGame() {
        execute("play", "games=20");
        String plain = scoreLine();
        assertThat(execute("play", "games=20", "moveLimit=100")).isZero();
        assertThat(scoreLine()).isEqualTo(plain);
    }

    @Test
    void checkRepeat_tellsWhetherScoresAreReproducible() throws IOException {
        Path classes = compiled(
                "Own",
                "java.util.Random own = new java.util.Random(System.nanoTime());"
                        + " return pacman.game.Constants.MOVE.values()[own.nextInt(4)];");
        assertThat(execute("play", "games=3", "check=repeat")).isZero();
        assertThat(out.toString()).contains("check: game 1 gave the same result when it was repeated: score ");
        assertThat(execute("play", "classpath=" + classes, "pacman=Own", "check=repeat"))
                .isZero();
        assertThat(out.toString()).contains("check: the scores are not reproducible: game 1 scored ");
    }

    @Test
    void eachSide_hasItsOwnClassPath() throws IOException {
        String ghosts = "package pacman.entries.ghosts; public class MyGhosts extends"
                + " pacman.controllers.Controller<java.util.EnumMap<pacman.game.Constants.GHOST,"
                + " pacman.game.Constants.MOVE>> { public java.util.EnumMap<pacman.game.Constants.GHOST,"
                + " pacman.game.Constants.MOVE> getMove(pacman.game.Game game, long due) {"
                + " if (!help.Helper.NAME.equals(\"ghosts\")) { throw new IllegalStateException(); } return null; } }";
        String player = "package pacman.entries.pacman; public class MyPacMan extends"
                + " pacman.controllers.Controller<pacman.game.Constants.MOVE> { public pacman.game.Constants.MOVE"
                + " getMove(pacman.game.Game game, long due) {"
                + " if (!help.Helper.NAME.equals(\"pacman\")) { throw new IllegalStateException(); } return null; } }";
        String helper = "package help; public class Helper { public static final String NAME = \"%s\".toString(); }";
        String ours = System.getProperty("java.class.path");
        Path first = CompiledClasses.compile(folder.resolve("a"), ours, player, helper.formatted("pacman"));
        Path second = CompiledClasses.compile(folder.resolve("b"), ours, ghosts, helper.formatted("ghosts"));
        assertThat(execute(
                        "play",
                        "pacmanClasspath=" + first,
                        "pacman=MyPacMan",
                        "ghostsClasspath=" + second,
                        "ghosts=MyGhosts"))
                .isZero();
        assertThat(out.toString())
                .contains("classes: pacman.entries.pacman.MyPacMan from " + first
                        + "; pacman.entries.ghosts.MyGhosts from " + second);
        assertThat(execute("play", "pacmanClasspath=" + first, "pacman=MyPacMan"))
                .isZero();
        assertThat(out.toString()).contains("; Legacy from this program");
    }

    @Test
    void unusedClassPath_isAnError() throws IOException {
        Path empty = Files.createDirectories(folder.resolve("empty"));
        assertMistake(
                "there is no class 'pacman.entries.pacman.MyPacMan' in " + empty,
                "play",
                "classpath=" + empty,
                "pacman=pacman.entries.pacman.MyPacMan");
        assertMistake("there is no class 'MyGhosts' in " + empty, "play", "classpath=" + empty, "ghosts=MyGhosts");
        assertMistake("classpath=" + empty + " has no effect here", "play", "classpath=" + empty);
        assertMistake("pacman=StarterPacMan: the class is not in " + empty, "play", "pacmanClasspath=" + empty);
        assertMistake("ghosts=Legacy: the class is not in " + empty, "play", "ghostsClasspath=" + empty);
        assertMistake(
                "pacmanClasspath=" + empty + " has no effect here",
                "play",
                "pacman=champion:blended",
                "pacmanClasspath=" + empty);
    }

    @Test
    void controllersAreArgumentsToo() throws IOException {
        Path classes = CompiledClasses.compile(
                folder,
                System.getProperty("java.class.path"),
                "package my; public class Fears extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + " private final pacman.controllers.NewGhostController model;"
                        + " public Fears(pacman.controllers.NewGhostController model, int depth) { this.model = model; }"
                        + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) {"
                        + " model.getMove(game.copy(), due); return pacman.game.Constants.MOVE.LEFT; } }");
        assertThat(execute("play", "classpath=" + classes, "pacman=my.Fears(Legacy,3)"))
                .isZero();
        assertThat(out.toString()).startsWith("my.Fears(Legacy,3) against Legacy");
        assertMistake(
                "my.Fears has no constructor without arguments; it has Fears(NewGhostController, int)",
                "play",
                "classpath=" + classes,
                "pacman=Fears");
    }
}
