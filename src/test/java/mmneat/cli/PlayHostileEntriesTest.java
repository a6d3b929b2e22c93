package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import mmneat.CompiledClasses;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Entries that throw unusual things: each is an ordinary failure of the entry, and the contest goes on. */
class PlayHostileEntriesTest extends CommandTest {

    private static final String SNEAK =
            "@SuppressWarnings(\"unchecked\") static <T extends Throwable> RuntimeException sneak(Throwable t) throws T"
                    + " { throw (T) t; }";

    /** The body of an exception, by the name of its class. */
    private static final Map<String, String> BODIES = new TreeMap<>(Map.of(
            "NoText", "public String toString() { throw Sneaks.<RuntimeException>sneak(new Exception()); }",
            "NullText", "public String toString() { return null; }",
            "NoMessage", "public String getMessage() { throw new IllegalStateException(); }",
            "NoCause", "public Throwable getCause() { throw new IllegalStateException(); }",
            "NewCause", "public Throwable getCause() { return new NewCause(); }",
            "NoTrace", "public StackTraceElement[] getStackTrace() { return null; }",
            "NoPrint", "public void printStackTrace(java.io.PrintWriter out) { throw new IllegalStateException(); }",
            "NoFill", "public Throwable fillInStackTrace() { throw new IllegalStateException(\"unfilled\"); }",
            "NullFill", "public Throwable fillInStackTrace() { return null; }"));

    @TempDir
    private static Path folder;

    private static Path classes;

    @BeforeAll
    static void compile() throws IOException {
        List<String> sources = new ArrayList<>();
        sources.add("public class Sneaks { " + SNEAK + " static RuntimeException sneak() {"
                + " return Sneaks.<RuntimeException>sneak(new java.io.IOException(\"checked\")); } }");
        sources.add("public class Cycle { static RuntimeException made() { RuntimeException a = new"
                + " RuntimeException(\"round\"), b = new RuntimeException(a); a.initCause(b); return a; } }");
        sources.add("public class BadLink extends LinkageError { public String getMessage() {"
                + " throw new IllegalStateException(); } }");
        BODIES.forEach(
                (name, body) -> sources.add("public class " + name + " extends RuntimeException { " + body + " }"));
        sources.add(pacMan("Sneak", "throw Sneaks.sneak();"));
        sources.add(pacMan("Cyclic", "throw Cycle.made();"));
        sources.add(pacMan("Links", "throw new BadLink();"));
        BODIES.keySet().forEach(name -> sources.add(pacMan("Throws" + name, "throw new " + name + "();")));
        sources.add(ghosts("SneakGhosts", "throw Sneaks.sneak();"));
        sources.add(ghosts("CyclicGhosts", "throw Cycle.made();"));
        sources.add(pacMan("Built", "return null; } public Built() { Sneaks.sneak();"));
        sources.add(pacMan("BuiltCyclic", "return null; } public BuiltCyclic() { if (true) throw Cycle.made();"));
        sources.add(pacMan("Static", "return null; } static { if (true) Sneaks.sneak();"));
        sources.add(pacMan("StaticError", "return null; } static { if (true) throw new AssertionError(\"no\");"));
        sources.add("@SuppressWarnings({\"rawtypes\"}) public class Raw extends pacman.controllers.Controller {"
                + " public Object getMove(pacman.game.Game game, long due) { return \"left\"; } }");
        sources.add(ghosts(
                "Texts",
                "java.util.EnumMap moves = new java.util.EnumMap(pacman.game.Constants.GHOST.class);"
                        + " for (pacman.game.Constants.GHOST ghost : pacman.game.Constants.GHOST.values())"
                        + " { moves.put(ghost, \"left\"); } return moves;"));
        sources.add(ghosts(
                "Maps",
                "return new java.util.EnumMap<>(pacman.game.Constants.GHOST.class) {"
                        + " public pacman.game.Constants.MOVE get(Object ghost) { throw Sneaks.sneak(); } };"));
        classes =
                CompiledClasses.compile(folder, System.getProperty("java.class.path"), sources.toArray(String[]::new));
    }

    private static String pacMan(String name, String body) {
        return "import pacman.game.Constants.MOVE; public class " + name
                + " extends pacman.controllers.Controller<MOVE> {"
                + " public MOVE getMove(pacman.game.Game game, long due) { " + body + " } }";
    }

    private static String ghosts(String name, String body) {
        String moves = "java.util.EnumMap<pacman.game.Constants.GHOST, pacman.game.Constants.MOVE>";
        return "public class " + name + " extends pacman.controllers.Controller<" + moves + "> { public " + moves
                + " getMove(pacman.game.Game game, long due) { " + body + " } }";
    }

    private void assertFailure(String failure, String... words) {
        List<String> all = new ArrayList<>(List.of("play", "games=3", "classpath=" + classes));
        all.addAll(List.of(words));
        all.add("onFailure=stop");
        assertThat(execute(all.toArray(String[]::new))).isEqualTo(2);
        assertThat(errors.toString().lines().reduce((first, last) -> last).orElseThrow())
                .startsWith("mmneat: " + failure)
                .endsWith("; game 1 of 3 ended the contest; onFailure=skip or onFailure=score0 plays on");
        all.set(all.size() - 1, "onFailure=skip");
        assertThat(execute(all.toArray(String[]::new))).isEqualTo(2);
        assertThat(errors.toString()).contains("mmneat: no game was played to its end: " + failure);
        all.set(all.size() - 1, "onFailure=score0");
        assertThat(execute(all.toArray(String[]::new))).isZero();
        assertThat(out.toString()).contains(", 3 games").contains("failures: 3 games failed");
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            pacman=Sneak          | Sneak failed: java.io.IOException: checked
            pacman=Cyclic         | Cyclic failed: java.lang.RuntimeException: round
            pacman=Links          | Links failed: BadLink
            pacman=ThrowsNoText   | ThrowsNoText failed: NoText
            pacman=ThrowsNullText | ThrowsNullText failed: NullText
            pacman=ThrowsNoMessage | ThrowsNoMessage failed: NoMessage
            pacman=ThrowsNoCause  | ThrowsNoCause failed: NoCause
            pacman=ThrowsNewCause | ThrowsNewCause failed: NewCause
            pacman=ThrowsNoTrace  | ThrowsNoTrace failed: NoTrace
            pacman=ThrowsNoPrint  | ThrowsNoPrint failed: NoPrint
            pacman=ThrowsNoFill   | ThrowsNoFill failed: java.lang.IllegalStateException: unfilled
            pacman=ThrowsNullFill | ThrowsNullFill failed: NullFill
            ghosts=SneakGhosts    | SneakGhosts failed: java.io.IOException: checked
            ghosts=CyclicGhosts   | CyclicGhosts failed: java.lang.RuntimeException: round
            pacman=Raw            | Raw failed: java.lang.ClassCastException: class java.lang.String cannot be cast
            ghosts=Texts          | Texts failed: java.lang.ClassCastException: class java.lang.String cannot be cast
            ghosts=Maps           | Maps failed: java.io.IOException: checked
            pacman=Built          | the constructor of Built threw java.io.IOException: checked
            pacman=BuiltCyclic    | the constructor of BuiltCyclic threw java.lang.RuntimeException: round
            """)
    void whateverAnEntryThrows_isAFailureOfTheEntry(String word, String failure) {
        assertFailure(failure, word);
        assertFailure(failure, word, "moveLimit=5");
    }

    @ParameterizedTest
    @CsvSource({"Static, java.io.IOException: checked", "StaticError, java.lang.AssertionError: no"})
    void staticInitialiserThatThrows_isAFailureOfTheEntry(String name, String thrown) {
        assertThat(execute("play", "classpath=" + classes, "pacman=" + name)).isEqualTo(2);
        assertThat(errors.toString())
                .startsWith("mmneat: the static initialiser of " + name + " threw " + thrown + "; game 1 of 1");
    }

    @ParameterizedTest
    @ValueSource(strings = {"Sneak", "Cyclic", "ThrowsNoText", "ThrowsNewCause", "Links"})
    void timedGames_survive(String name) {
        Thread.UncaughtExceptionHandler before = Thread.getDefaultUncaughtExceptionHandler();
        Thread.setDefaultUncaughtExceptionHandler((thread, failure) -> {});
        try {
            String pacMan = "pacman=" + name;
            assertThat(execute("play", "classpath=" + classes, pacMan, "timed=fast", "rules=mmneat"))
                    .isEqualTo(2);
            assertThat(errors.toString()).contains("mmneat: " + name + " failed: ");
        } finally {
            Thread.setDefaultUncaughtExceptionHandler(before);
        }
    }

    /** The answers arrive, but the game cannot use them. */
    @ParameterizedTest
    @ValueSource(strings = {"pacman=Raw", "ghosts=Texts", "ghosts=Maps"})
    void answersOfAnotherType_failTimedGamesToo(String word) {
        assertFailure(word.split("=")[1] + " failed: java.", word, "timed=fast");
    }

    @Test
    void recordedGame_thatFails_isReported() {
        Path file = folder.resolve("game.txt");
        assertThat(execute("play", "classpath=" + classes, "pacman=Sneak", "record=" + file))
                .isEqualTo(2);
        assertThat(errors.toString()).contains("mmneat: Sneak failed: java.io.IOException: checked; game 1 of 1");
        assertThat(Files.exists(file)).isFalse();
    }
}
