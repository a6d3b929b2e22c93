package mmneat.contest.entry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import mmneat.CompiledClasses;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import pacman.Executor;
import pacman.controllers.Controller;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.NearestPillPacMan;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** Competition entries are found and play our game. */
class ControllerLoaderTest {

    private static final String OUR_CLASSES = System.getProperty("java.class.path");

    /**
     * Returns the source of an entry that heads for the nearest pill, in a given package and with a given copy of the
     * interface.
     */
    private static String entry(String packageLine, String api, String className) {
        return packageLine
                + "import " + api + "controllers.Controller;"
                + "import " + api + "game.Constants.DM;"
                + "import " + api + "game.Constants.MOVE;"
                + "import " + api + "game.Game;"
                + "public class " + className + " extends Controller<MOVE> {"
                + "  private final Target target = new Target();"
                + "  public MOVE getMove(Game game, long timeDue) { return target.move(game.copy()); }"
                + "  private static class Target {"
                + "    MOVE move(Game game) {"
                + "      int position = game.getPacmanCurrentNodeIndex();"
                + "      int[] pills = game.getActivePillsIndices();"
                + "      int[] powerPills = game.getActivePowerPillsIndices();"
                + "      int[] all = java.util.Arrays.copyOf(pills, pills.length + powerPills.length);"
                + "      System.arraycopy(powerPills, 0, all, pills.length, powerPills.length);"
                + "      int target = game.getClosestNodeIndexFromNodeIndex(position, all, DM.PATH);"
                + "      return game.getNextMoveTowardsTarget(position, target, DM.PATH);"
                + "    }"
                + "  }"
                + "}";
    }

    @TempDir
    private Path folder;

    private Path compiled(String... sources) throws IOException {
        return CompiledClasses.compile(folder, OUR_CLASSES, sources);
    }

    private static String gamePlayedBy(Controller<MOVE> pacMan) {
        Game game = new Game(7);
        new Executor().runExperiment(pacMan, new Legacy(), game);
        return game.getGameState();
    }

    private static void assertPlaysAsNearestPillPacMan(Path place, String name) {
        Controller<MOVE> entry =
                new ControllerLoader(List.of(place)).pacMan(name).create();
        assertThat(entry.getClass().getClassLoader()).isNotEqualTo(Controller.class.getClassLoader());
        assertThat(gamePlayedBy(entry)).isEqualTo(gamePlayedBy(new NearestPillPacMan()));
    }

    @Test
    void ours_areFoundWithAndWithoutPackage() {
        ControllerLoader loader = new ControllerLoader(List.of());
        assertThat(loader.pacMan("StarterPacMan").create().getClass().getName())
                .isEqualTo("pacman.controllers.examples.StarterPacMan");
        assertThat(loader.ghosts("pacman.controllers.examples.Legacy").name()).isEqualTo("Legacy");
        assertThat(loader.pacMan("MyPacMan").create())
                .isNotSameAs(loader.pacMan("MyPacMan").create());
        assertThat(loader.ghosts("MyGhosts").name()).isEqualTo("MyGhosts");
    }

    @Test
    void entryInAFolderOrJar_isFoundWithAndWithoutPackage() throws IOException {
        Path classes = compiled(entry("package my.own;", "pacman.", "Entry"));
        assertPlaysAsNearestPillPacMan(classes, "my.own.Entry");
        assertPlaysAsNearestPillPacMan(CompiledClasses.jar(classes, folder.resolve("entry.jar")), "Entry");
    }

    @Test
    void entryWithoutPackage_isFound() throws IOException {
        assertPlaysAsNearestPillPacMan(compiled(entry("", "pacman.", "Entry")), "Entry");
    }

    @Test
    void entryNamedAsOurSkeleton_comesFromItsJar() throws IOException {
        Path classes = compiled(entry("package pacman.entries.pacman;", "pacman.", "MyPacMan"));
        assertPlaysAsNearestPillPacMan(classes, "MyPacMan");
        assertPlaysAsNearestPillPacMan(classes, "pacman.entries.pacman.MyPacMan");
    }

    @Test
    void entryPackedWithItsOwnCopyOfTheInterface_usesOurs() throws IOException {
        Path classes = compiled(
                entry("package my.own;", "pacman.", "Entry"),
                "package pacman.controllers.examples; public class Legacy {}");
        assertPlaysAsNearestPillPacMan(classes, "Entry");
        assertThat(new ControllerLoader(List.of(classes)).ghosts("Legacy").create())
                .isInstanceOf(Legacy.class);
    }

    /** Returns the sources of a copy of the interface in another package, as far as the entry needs it. */
    private static String[] copiedInterface(String root) {
        String unsupported = "{ throw new UnsupportedOperationException(); }";
        return new String[] {
            "package " + root + "game; public class Constants {"
                    + "  public enum MOVE { UP, RIGHT, DOWN, LEFT, NEUTRAL } public enum DM { PATH } }",
            "package " + root + "game; public class Game {"
                    + "  public Game copy() " + unsupported
                    + "  public int getPacmanCurrentNodeIndex() " + unsupported
                    + "  public int[] getActivePillsIndices() " + unsupported
                    + "  public int[] getActivePowerPillsIndices() " + unsupported
                    + "  public int getClosestNodeIndexFromNodeIndex(int a, int[] b, Constants.DM c) " + unsupported
                    + "  public Constants.MOVE getNextMoveTowardsTarget(int a, int b, Constants.DM c) " + unsupported
                    + "}",
            "package " + root + "controllers; public abstract class Controller<T> {" + "  public abstract T getMove("
                    + root + "game.Game game, long timeDue); }"
        };
    }

    @Test
    void entryWithACopyOfTheInterfaceInAnotherPackage_playsOurGame() throws IOException {
        String[] copy = copiedInterface("edu.example.pacman.");
        Path classes = compiled(
                copy[0],
                copy[1],
                copy[2],
                entry("package edu.example.pacman.entries;", "edu.example.pacman.", "Entry"));
        assertPlaysAsNearestPillPacMan(classes, "edu.example.pacman.entries.Entry");
        // The copy itself may be missing: only its name matters.
        try (var copies = Files.walk(classes.resolve("edu/example/pacman/game"))) {
            for (Path file : copies.filter(Files::isRegularFile).toList()) {
                Files.delete(file);
            }
        }
        Files.delete(classes.resolve("edu/example/pacman/controllers/Controller.class"));
        assertPlaysAsNearestPillPacMan(classes, "Entry");
    }

    @Test
    void entryNamedAsOneOfOurs_inAnotherPackage_isTheEntry() throws IOException {
        Path classes = compiled(
                entry("package team.controllers.examples;", "pacman.", "StarterPacMan"),
                "package team; public class Teams { public static class Nested extends"
                        + " pacman.controllers.Controller<pacman.game.Constants.MOVE> { public pacman.game.Constants.MOVE"
                        + " getMove(pacman.game.Game game, long due) { return null; } } }");
        assertPlaysAsNearestPillPacMan(classes, "team.controllers.examples.StarterPacMan");
        ControllerLoader loader = new ControllerLoader(List.of(classes));
        assertThat(loader.pacMan("StarterPacMan").name()).isEqualTo("team.controllers.examples.StarterPacMan");
        assertThat(loader.pacMan("Nested").name()).isEqualTo("team.Teams$Nested");
        assertThat(loader.pacMan("Teams$Nested").name()).isEqualTo("team.Teams$Nested");
    }

    @Test
    void movesOfGenericBaseClasses_areChecked() throws IOException {
        String decides = " public T getMove(pacman.game.Game game, long due) { return null; } }";
        Path classes = compiled(
                "public abstract class Base<K, T> extends pacman.controllers.Controller<T> {" + decides,
                "public class Ghosts extends Base<String,"
                        + " java.util.EnumMap<pacman.game.Constants.GHOST, pacman.game.Constants.MOVE>> {}",
                "public class Pac extends Base<String, pacman.game.Constants.MOVE> {}",
                "@SuppressWarnings(\"rawtypes\") public class Raw extends Base {}");
        ControllerLoader loader = new ControllerLoader(List.of(classes));
        assertThatThrownBy(() -> loader.pacMan("Ghosts"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("Ghosts must return moves for Ms. Pac-Man (MOVE), returns EnumMap");
        assertThatThrownBy(() -> loader.ghosts("Pac")).hasMessageContaining("returns MOVE");
        assertThat(loader.pacMan("Pac").create()).isNotNull();
        assertThat(loader.ghosts("Raw").create()).isNotNull();
    }

    @Test
    void staticInitialiserThatThrows_isNamedWithItsException() throws IOException {
        Path classes = compiled(
                "public class Static extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + " static int size = Integer.parseInt(\"x\");"
                        + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) { return null; } }");
        assertThatThrownBy(() ->
                        new ControllerLoader(List.of(classes)).pacMan("Static").create())
                .isInstanceOf(UserError.class)
                .hasMessageContaining("the static initialiser of Static threw java.lang.NumberFormatException");
    }

    @Test
    void constructor_findsItsFilesByTheThreadsClassLoader() throws IOException {
        Path classes = compiled(
                "public class Weights extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + " public Weights() { if (Thread.currentThread().getContextClassLoader()"
                        + ".getResource(\"weights.txt\") == null) throw new IllegalStateException(); }"
                        + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) { return null; } }");
        Files.writeString(classes.resolve("weights.txt"), "1");
        ClassLoader before = Thread.currentThread().getContextClassLoader();
        assertThat(new ControllerLoader(List.of(classes)).pacMan("Weights").create())
                .isNotNull();
        assertThat(Thread.currentThread().getContextClassLoader()).isSameAs(before);
    }

    @Test
    void unknownClass_isAnErrorWithASuggestion() throws IOException {
        ControllerLoader ours = new ControllerLoader(List.of());
        assertThatThrownBy(() -> ours.ghosts("Legcy"))
                .isInstanceOf(UserError.class)
                .hasMessage("there is no controller 'Legcy' (did you mean 'Legacy'?)");
        assertThatThrownBy(() -> ours.pacMan("my.Entry"))
                .hasMessage("there is no class 'my.Entry'; give its jar or class folder as classpath=FILE");
        Path classes = compiled(
                entry("package my.own;", "pacman.", "Entry"),
                "package my.own; public abstract class Base<T> extends pacman.controllers.Controller<T> {}");
        ControllerLoader loader = new ControllerLoader(List.of(classes));
        assertThatThrownBy(() -> loader.pacMan("my.own.Entri"))
                .hasMessage("there is no class 'my.own.Entri' in " + classes + " (did you mean 'my.own.Entry'?)");
        assertThatThrownBy(() -> loader.pacMan("Something"))
                .hasMessage("there is no class 'Something' in " + classes + " (controllers there: [my.own.Entry])");
    }

    @Test
    void ambiguousName_isAnError() throws IOException {
        Path classes = compiled(entry("package a;", "pacman.", "Entry"), entry("package b;", "pacman.", "Entry"));
        assertThatThrownBy(() -> new ControllerLoader(List.of(classes)).pacMan("Entry"))
                .isInstanceOf(UserError.class)
                .hasMessage("'Entry' may be a.Entry or b.Entry; give it with its package");
    }

    @Test
    void controllerOfTheWrongSide_isAnError() {
        ControllerLoader loader = new ControllerLoader(List.of());
        assertThatThrownBy(() -> loader.pacMan("Legacy"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("must return moves for Ms. Pac-Man (MOVE), returns EnumMap");
        assertThatThrownBy(() -> loader.ghosts("StarterPacMan"))
                .hasMessageContaining("must return moves for the ghosts (EnumMap<GHOST, MOVE>), returns MOVE");
        assertThatThrownBy(() -> loader.ghosts("pacman.Executor")).hasMessageContaining("is not a controller");
        assertThatThrownBy(() -> loader.ghosts("pacman.controllers.NewGhostController"))
                .hasMessageContaining("is abstract");
    }

    @Test
    void entryThatCannotBeMade_isAnError() throws IOException {
        String decides =
                "public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) { return null; } }";
        Path classes = compiled(
                "public class NeedsArgument extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + "public NeedsArgument(int size) {}" + decides,
                "public class Throws extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + "public Throws() { throw new IllegalStateException(\"no file\"); }" + decides,
                "public class Missing extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + "private final Library library = new Library();" + decides,
                "public class Library {}",
                "class Hidden extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {" + decides);
        Files.delete(classes.resolve("Library.class"));
        ControllerLoader loader = new ControllerLoader(List.of(classes));
        assertThatThrownBy(() -> loader.pacMan("NeedsArgument"))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith(
                        "NeedsArgument has no constructor without arguments; it has NeedsArgument(int): give numbers");
        assertThatThrownBy(() -> loader.pacMan("Throws").create())
                .hasMessage("the constructor of Throws threw java.lang.IllegalStateException: no file");
        assertThatThrownBy(() -> loader.pacMan("Missing").create())
                .isInstanceOf(UserError.class)
                .hasMessageContaining("Library");
        assertThat(loader.pacMan("Hidden").create().getMove()).isNull();
    }

    @Test
    void classPathThatCannotBeRead_isAnError() throws IOException {
        assertThatThrownBy(() -> new ControllerLoader(List.of(folder.resolve("none.jar"))))
                .isInstanceOf(UserError.class)
                .hasMessage("classpath: there is no file or folder " + folder.resolve("none.jar"));
        Path text = Files.writeString(folder.resolve("text.jar"), "not a jar");
        assertThatThrownBy(() -> new ControllerLoader(List.of(text)))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("is not a readable jar or class folder");
        Path classes = Files.createDirectories(folder.resolve("damaged"));
        Files.writeString(classes.resolve("Entry.class"), "not a class");
        assertThatThrownBy(() -> new ControllerLoader(List.of(classes)).pacMan("Entry"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("Entry");
    }

    private static final String DECIDES =
            " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) { return null; }"
                    + " public String toString() { return text; } }";

    private static final String HEAD =
            " extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {" + " private final String text; ";

    private Object made(Path classes, String call) {
        return new ControllerLoader(List.of(classes)).pacMan(call).create();
    }

    @Test
    void constructorsWithArguments_areCalled() throws IOException {
        Path classes = compiled(
                "public class Takes" + HEAD
                        + "public Takes(pacman.controllers.Controller<?> other, double weight)"
                        + " { text = other.getClass().getSimpleName() + weight; }"
                        + "public Takes(int number) { text = \"int \" + number; }"
                        + "public Takes(Long number) { text = \"long \" + number; }"
                        + "public Takes(boolean flag) { text = \"flag \" + flag; }"
                        + "public Takes(String word) { text = \"word \" + word; }"
                        + "public Takes(pacman.game.Constants.GHOST ghost, char letter) { text = ghost.name() + letter; }"
                        + "public Takes(Base base) { text = \"own \" + base; }"
                        + "public Takes() { text = \"nothing\"; }"
                        + DECIDES,
                "public class Base" + HEAD + "public Base(int size) { text = \"base \" + size; }" + DECIDES);
        assertThat(made(classes, "Takes(Legacy, 0.5)")).hasToString("Legacy0.5");
        assertThat(made(classes, "Takes( pacman.controllers.examples.StarterGhosts ,2)"))
                .hasToString("StarterGhosts2.0");
        assertThat(made(classes, "Takes(7)")).hasToString("int 7");
        assertThat(made(classes, "Takes(70000000000)")).hasToString("long 70000000000");
        assertThat(made(classes, "Takes(true)")).hasToString("flag true");
        assertThat(made(classes, "Takes(weights.txt)")).hasToString("word weights.txt");
        assertThat(made(classes, "Takes('a, (b')")).hasToString("word a, (b");
        assertThat(made(classes, "Takes(SUE,x)")).hasToString("SUEx");
        assertThat(made(classes, "Takes(Base(3))")).hasToString("own base 3");
        assertThat(made(classes, "Takes()")).hasToString("nothing");
        assertThat(new ControllerLoader(List.of(classes))
                        .pacMan("Takes(Base( 3 ))")
                        .name())
                .isEqualTo("Takes(Base( 3 ))");
        Controller<MOVE> first =
                new ControllerLoader(List.of(classes)).pacMan("Takes(Base(3))").create();
        assertThat(first.getClass().getClassLoader()).isNotEqualTo(Controller.class.getClassLoader());
        assertThatThrownBy(() -> made(classes, "Takes(1,2,3)"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("has no constructor for (1, 2, 3); it has Takes()")
                .hasMessageContaining("Takes(Controller, double)");
        for (String call : List.of("Takes(1", "Takes)", "Takes('a)", "(1)", "Takes(1))")) {
            assertThatThrownBy(() -> made(classes, call)).isInstanceOf(UserError.class);
        }
    }

    @Test
    void skeletonOfOurs_neverReplacesAClassThatTheClassPathLacks() throws IOException {
        Path empty = Files.createDirectories(folder.resolve("empty"));
        ControllerLoader loader = new ControllerLoader(List.of(empty));
        for (String name : List.of("pacman.entries.pacman.MyPacMan", "MyPacMan")) {
            assertThatThrownBy(() -> loader.pacMan(name))
                    .isInstanceOf(UserError.class)
                    .hasMessageStartingWith("there is no class '" + name + "' in " + empty);
        }
        assertThatThrownBy(() -> loader.ghosts("MyGhosts")).hasMessageContaining("there is no class 'MyGhosts'");
        assertThat(loader.ghosts("Legacy").origin()).isEmpty();
    }

    @Test
    void entriesWithEqualClassNames_useTheirOwnHelpers() throws IOException {
        List<Path> jars = new java.util.ArrayList<>();
        for (String team : List.of("red", "blue")) {
            Path place = Files.createDirectories(folder.resolve(team));
            Path classes = CompiledClasses.compile(
                    place,
                    OUR_CLASSES,
                    "package " + team + "; public class Entry" + HEAD + "public Entry() { text = util.Helper.NAME; }"
                            + DECIDES,
                    "package same; public class Entry" + HEAD + "public Entry() { text = util.Helper.NAME; }" + DECIDES,
                    "package util; public class Helper { public static final String NAME = \"" + team
                            + "\".toString(); }");
            jars.add(CompiledClasses.jar(classes, folder.resolve(team + ".jar")));
        }
        ControllerLoader both = new ControllerLoader(jars);
        assertThat(both.pacMan("red.Entry").create()).hasToString("red");
        assertThat(both.pacMan("blue.Entry").create()).hasToString("blue");
        assertThat(both.pacMan("blue.Entry").origin()).isEqualTo(jars.get(1).toString());
        assertThatThrownBy(() -> both.pacMan("same.Entry"))
                .isInstanceOf(UserError.class)
                .hasMessage("'same.Entry' is in " + jars.get(0) + " and in " + jars.get(1)
                        + "; give each side a class path of its own, pacmanClasspath= and ghostsClasspath=");
        assertThat(new ControllerLoader(List.of(jars.get(1)))
                        .pacMan("same.Entry")
                        .create())
                .hasToString("blue");
    }

    @Test
    void entryThatEndsTheProgram_failsInstead_andKeepsItsPlace() throws IOException {
        for (String end : List.of("System.exit(0)", "Runtime.getRuntime().halt(0)", "Runtime.getRuntime().exit(3)")) {
            Path classes = CompiledClasses.compile(
                    Files.createTempDirectory(folder, "end"),
                    OUR_CLASSES,
                    "public class Leaves extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                            + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) { " + end
                            + "; return null; } }");
            Controller<MOVE> entry =
                    new ControllerLoader(List.of(classes)).pacMan("Leaves").create();
            assertThatThrownBy(() -> entry.getMove(new Game(0), 0))
                    .isInstanceOf(ControllerExit.class)
                    .hasMessageContaining(end.replace("Runtime.getRuntime()", "Runtime"));
            assertThat(entry.getClass().getProtectionDomain().getCodeSource().getLocation())
                    .isEqualTo(classes.toUri().toURL());
        }
    }

    @Test
    void memberThatTheCompetitionNeverHad_isSaidToBeOne() throws IOException {
        Path other = CompiledClasses.compile(
                Files.createTempDirectory(folder, "api"),
                OUR_CLASSES,
                "package pacman.game.info; public class Extra { public static int size() { return 1; } }");
        Path classes = CompiledClasses.compile(
                folder,
                OUR_CLASSES + java.io.File.pathSeparator + other,
                "public class Early extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + " private int size = pacman.game.info.Extra.size();"
                        + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) { return null; } }");
        assertThatThrownBy(() -> made(classes, "Early"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("release 6.2 of the competition has no such class");
        assertThat(MissingMember.explanation(new NoSuchMethodError("'int pacman.game.Game.getThing()'")))
                .contains("has no such member");
        assertThat(MissingMember.explanation(new NoSuchFieldError("THING"))).contains("has no such member");
        assertThat(MissingMember.explanation(new NoSuchMethodError("'int my.Library.size()'")))
                .isEmpty();
        assertThat(MissingMember.explanation(new NoClassDefFoundError("pacman/entries/pacman/Mine")))
                .isEmpty();
        assertThat(MissingMember.explanation(new IllegalStateException("pacman.game")))
                .isEmpty();
    }
}
