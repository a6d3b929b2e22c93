package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import mmneat.CompiledClasses;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.analysis.results.RunFixture;
import mmneat.neat.ModuleLayout;
import mmneat.neat.io.GenotypeJson;
import mmneat.neat.variation.InitialNetworks;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import pacman.Recording;
import pacman.game.Game;
import pacman.game.GameRules;
import pacman.game.GhostLocations;

/** The commands play and replay, as a user types them. */
class PlayCommandTest extends CommandTest {

    @TempDir
    private Path folder;

    private String scoreLine() {
        return out.toString().lines().toList().get(1);
    }

    @Test
    void games_areSummedUp_andTheSameSeedGivesTheSameGames() {
        String[] words = {"play", "pacman=StarterPacMan", "ghosts:Legacy", "games=20", "seed=1"};
        assertThat(execute(words)).isZero();
        assertThat(out.toString().lines()).hasSize(3);
        assertThat(out.toString())
                .startsWith("StarterPacMan against Legacy, 20 games, seed 1, rules competition")
                .containsPattern("score: mean [\\d.]+, standard deviation [\\d.]+, minimum \\d+, maximum \\d+")
                .containsPattern("steps: \\d+, \\d+ per second");
        String first = scoreLine();
        execute(words);
        assertThat(scoreLine()).isEqualTo(first);
        words[4] = "seed=2";
        execute(words);
        assertThat(scoreLine()).isNotEqualTo(first);
    }

    @Test
    void oneGame_hasNoStandardDeviation() {
        assertThat(execute("play")).isZero();
        assertThat(out.toString()).contains("1 game, seed 0").contains("standard deviation -,");
    }

    @Test
    void isolatedGhosts_startFromOurRecording_unlessAnotherIsNamed() {
        assertThat(execute("play", "games=5", "rules=isolatedGhosts")).isZero();
        assertThat(out.toString()).contains("rules isolatedGhosts");
    }

    @Test
    void isolatedGhosts_playAllLevelsInTheMazeThatIsNamed_ifItWasRecorded() throws IOException {
        Path recording = folder.resolve("recording.txt");
        assertThat(execute("play", "rules=isolatedGhosts", "maze=c", "record=" + recording))
                .isZero();
        GameRules rules = GameRules.isolatedGhosts(0, GhostLocations.shipped());
        Game game = new Game(0, rules.withMazes(mazes -> mazes.withOnlyMaze(2)));
        TreeSet<Integer> levels = new TreeSet<>();
        for (String state : Recording.load(recording).states()) {
            game.setGameState(state);
            assertThat(game.getMazeIndex()).isEqualTo(2);
            levels.add(game.getCurrentLevel());
        }
        assertThat(levels).contains(0, 1, 2, 3);
        Path drawing = Files.writeString(folder.resolve("mine.txt"), "#");
        assertMistake(
                "must be a, b, c or d with rules=isolatedGhosts", "play", "rules=isolatedGhosts", "maze=" + drawing);
    }

    @Test
    void rulesAndMaze_changeTheGame() throws IOException {
        execute("play", "games=5");
        String competition = scoreLine();
        assertThat(execute("play", "games=5", "rules=blended")).isZero();
        assertThat(out.toString()).contains("rules blended");
        assertThat(scoreLine()).isNotEqualTo(competition);
        assertThat(execute("play", "games=5", "maze=c")).isZero();
        String mazeC = scoreLine();
        assertThat(mazeC).isNotEqualTo(competition);
        Path drawing = folder.resolve("own.txt");
        try (var source = PlayCommandTest.class.getResourceAsStream("/mazes/c.txt")) {
            Files.copy(source, drawing);
        }
        assertThat(execute("play", "games=5", "maze=" + drawing)).isZero();
        assertThat(scoreLine()).isEqualTo(mazeC);
        for (String rules : new String[] {"interleaved", "isolatedPills", "mpmVsGhosts", "fourMaze", "mmneat"}) {
            assertThat(execute("play", "pacman=RandomPacMan", "rules=" + rules)).isZero();
        }
    }

    @Test
    void recording_canBeReplayed() throws IOException {
        Path file = folder.resolve("game.txt");
        assertThat(execute("play", "seed=3", "record=" + file)).isZero();
        String steps = out.toString().lines().toList().get(2).replaceAll("steps: (\\d+),.*", "$1");
        assertThat(Files.readAllLines(file)).hasSize(Integer.parseInt(steps));
        assertThat(execute("replay", file.toString(), "view=false")).isZero();
        assertThat(out.toString()).startsWith(steps + " states: score ");
        assertThat(execute("replay", file.toString())).isZero();
        assertThat(errors.toString()).contains("there is no display", "out=game.html");
        Path page = folder.resolve("game.html");
        assertThat(execute("replay", file.toString(), "out=" + page)).isZero();
        assertThat(errors.toString()).isEmpty();
        assertThat(page).content().startsWith("<!DOCTYPE html>").contains("\"steps\":" + steps);
        assertMistake("must end in .html", "replay", file.toString(), "out=" + folder.resolve("game.gif"));
        assertMistake("delay=3 has no effect here", "replay", file.toString(), "out=" + page, "delay=3");
    }

    @Test
    void viewWithoutADisplay_isReported_andTheGameIsPlayed() {
        assertThat(execute("play", "view=true")).isZero();
        assertThat(errors.toString().lines())
                .containsExactly("mmneat: there is no display, so the games are not shown");
    }

    @Test
    void entryThatThrows_isNamed_withTimeAndStackTrace() throws IOException {
        Path classes = CompiledClasses.compile(
                folder,
                System.getProperty("java.class.path"),
                "package my; public class Entry extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) {"
                        + "   if (game.getTotalTime() == 5) { throw new IllegalStateException(\"no idea\"); }"
                        + "   return null; } }");
        assertThat(execute("play", "classpath=" + classes, "pacman=my.Entry")).isEqualTo(2);
        assertThat(errors.toString())
                .contains("mmneat: my.Entry threw an exception in game 1 at time 5")
                .contains("IllegalStateException: no idea")
                .contains("my.Entry.getMove(Entry.java")
                .contains("mmneat: my.Entry failed: java.lang.IllegalStateException: no idea");
    }

    @Test
    void entryWhoseExceptionMisbehaves_isNamedInOneLine() throws IOException {
        Path classes = CompiledClasses.compile(
                folder,
                System.getProperty("java.class.path"),
                "package my; public class Entry extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + " static int games;"
                        + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) {"
                        + "   if (games++ == 0) { throw new IllegalStateException(\"no\\nidea\\u001b[31m\"); }"
                        + "   throw new IllegalStateException() {"
                        + "     public String getMessage() { throw new IllegalStateException(); }"
                        + "     public String toString() {"
                        + "     throw new IllegalStateException(); } }; } }");
        assertThat(execute("play", "classpath=" + classes, "pacman=my.Entry", "games=2", "onFailure=score0"))
                .isZero();
        assertThat(out.toString()).contains("IllegalStateException: no?idea?[31m");
        assertThat(out.toString().lines().filter(line -> line.startsWith("idea")))
                .isEmpty();
        assertThat(errors.toString()).contains("my.Entry$1").doesNotContain("\u001b");
    }

    @Test
    void userErrors_areOneLine() throws IOException {
        assertMistake("unknown name 'pacmn' (did you mean 'pacman'?)", "play", "pacmn=StarterPacMan");
        assertMistake("there is no controller 'Starter'", "play", "pacman=Starter");
        assertMistake("must return moves for Ms. Pac-Man", "play", "pacman=Legacy");
        assertMistake("games=0: must be a whole number, at least 1", "play", "games=0");
        assertMistake("games=99999999999: must be a whole number from 1 to 2147483647", "play", "games=99999999999");
        assertMistake(
                "seed=99999999999999999999: must be a whole number from -9223372036854775808 to 9223372036854775807",
                "play",
                "seed=99999999999999999999");
        assertMistake("rules=hard: must be one of", "play", "rules=hard");
        assertMistake("maze=none.txt: cannot be read: there is no such file", "play", "maze=none.txt");
        assertMistake(
                "ghostLocations=none.txt: cannot be read", "play", "rules=isolatedGhosts", "ghostLocations=none.txt");
        assertMistake("only one game can be recorded", "play", "record=" + folder.resolve("x"), "games=2");
        assertMistake(": this is a folder; name a file in it", "play", "record=" + folder);
        assertMistake("'games' has no value; write games=...", "play", "games");
        assertMistake("needs view=true", "play", "pacman=Human");
        assertMistake("needs a display, and there is none", "play", "pacman=Human", "view=true");
        assertMistake("there is no file or folder", "play", "classpath=none.jar", "pacman=my.Entry");
        assertMistake("write replay FILE", "replay");
        assertMistake("none.txt: cannot be read: there is no such file", "replay", "none.txt");
        Path text = Files.writeString(folder.resolve("text.txt"), "hello\n");
        assertMistake("not a recording", "replay", text.toString());
        Path broken = folder.resolve("broken.txt");
        Files.writeString(broken, "x,".repeat(34) + "x\n");
        assertMistake("broken.txt: ", "replay", broken.toString(), "view=false");
        Path maze = Files.writeString(folder.resolve("maze.txt"), "????\n");
        assertMistake("maze.txt", "play", "maze=" + maze);
    }

    @Test
    void championOfARun_sensesAsTheRunSays() throws IOException {
        Path run = RunFixture.run(folder, "blended", "2M", 0, 1000);
        Files.writeString(
                run.resolve("parameters.properties"), "specific=true\njunctionsToSense=2\n", StandardOpenOption.APPEND);
        ModuleLayout layout = ModuleLayout.withPreferenceNeurons(2, 1);
        Path network = Files.writeString(
                run.resolve("champion.json"),
                GenotypeJson.write(new InitialNetworks(39, layout).create(0, new ResumableRandom(3))));
        assertThat(execute("play", "pacman=" + run, "games=2")).isZero();
        assertThat(out.toString()).startsWith(run + " against Legacy, 2 games");
        String score = scoreLine();
        assertThat(execute("play", "pacman=" + network, "games=2")).isZero();
        assertThat(scoreLine()).isEqualTo(score);
        Path alone = Files.copy(network, folder.resolve("alone.json"));
        assertMistake("the network has 39 inputs; networks of the published", "play", "pacman=" + alone);
        assertMistake("there is no champion in this folder", "play", "pacman=" + folder);
        Path missing = folder.resolve("2M7");
        assertMistake(missing + ": there is no such file; give a run's folder", "play", "pacman=" + missing);
    }

    @Test
    void publishedChampionOfARun_playsLikeItsFile() throws IOException {
        Path run = RunFixture.run(folder, "blended", "2M", 0, 1000);
        String champion = GenotypeJson.write(ShippedChampions.read("blended").genotype());
        Files.writeString(run.resolve("champion.json"), champion);
        Path alone = Files.writeString(folder.resolve("alone.json"), champion);
        assertThat(execute("play", "pacman=" + run, "rules=blended")).isZero();
        String score = scoreLine();
        assertThat(execute("play", "pacman=" + alone, "rules=blended")).isZero();
        assertThat(scoreLine()).isEqualTo(score);
        assertThat(execute("play", "pacman=champion:blended", "rules=blended")).isZero();
        assertThat(scoreLine()).isEqualTo(score);
    }

    @Test
    void wordsWithoutEffect_areRefused() {
        assertMistake(
                "powerPill=2 has no effect here: it is used only with rules=isolatedGhosts", "play", "powerPill=2");
        assertMistake("ghostLocations=x has no effect here", "play", "rules=blended", "ghostLocations=x");
        assertMistake("division=AnyPills has no effect here: it is for a network", "play", "division=AnyPills");
        assertMistake(
                "division=AnyPills: the network of champion:blended chooses its modules itself",
                "play",
                "pacman=champion:blended",
                "division=AnyPills");
        assertMistake("delay=9 has no effect here", "watch", "champion=blended", "delay=9");
        assertMistake(
                "ghosts=x has no effect here: only the isolated version", "watch", "champion=blended", "ghosts=x");
        assertMistake("ghosts=x has no effect here", "tasks", "task=blended", "ghosts=x");
        assertMistake("ghosts=x: the file is missing or not readable", "tasks", "task=isolated", "ghosts=x");
        assertMistake("ghosts=x: the file is missing or not readable", "watch", "champion=isolated", "ghosts=x");
        assertMistake("seed=3 has no effect here", "evaluate", "champion=blended", "report=true", "seed=3");
    }

    /**
     * The source of a controller that plays as StarterPacMan and also advances a copy until a ghost is no longer
     * edible, which draws from the run's generator.
     */
    private static String lookingAhead() {
        return "package team; public class Ahead extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                + " private final pacman.controllers.examples.StarterPacMan starter ="
                + " new pacman.controllers.examples.StarterPacMan();"
                + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due) {"
                + " int edible = game.getGhostEdibleTime(pacman.game.Constants.GHOST.BLINKY);"
                + " pacman.game.Game copy = game.copy();"
                + " for (int i = 0; edible > 0 && i < 200; i++)"
                + " { copy.rnd.nextInt(); copy.advanceGame(pacman.game.Constants.MOVE.LEFT, null); }"
                + " return starter.getMove(game, due); } }";
    }

    @Test
    void lookingAheadInCopies_changesNoOtherGame() throws IOException {
        Path classes = CompiledClasses.compile(folder, System.getProperty("java.class.path"), lookingAhead());
        for (String rules : List.of("competition", "interleaved", "mmneat")) {
            execute("play", "rules=" + rules, "seed=4", "games=20");
            String plain = scoreLine();
            assertThat(execute("play", "rules=" + rules, "seed=4", "games=20", "classpath=" + classes, "pacman=Ahead"))
                    .isZero();
            assertThat(out.toString()).startsWith("team.Ahead against Legacy");
            assertThat(scoreLine()).as(rules).isEqualTo(plain);
        }
    }

    @Test
    void entryWhoseNameEndsLikeTheHumans_isAnEntry() throws IOException {
        Path classes = CompiledClasses.compile(
                folder,
                System.getProperty("java.class.path"),
                "package team; public class MyHumanController"
                        + " extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due)"
                        + " { return pacman.game.Constants.MOVE.LEFT; } }");
        assertThat(execute("play", "classpath=" + classes, "pacman=MyHumanController"))
                .isZero();
        assertThat(out.toString()).startsWith("team.MyHumanController against Legacy");
    }

    @Test
    void help_listsEveryWord() {
        assertThat(execute("play", "--help")).isZero();
        assertThat(out.toString())
                .contains("pacman=", "ghosts=", "games=", "seed=", "classpath=", "rules=", "maze=", "timed=", "view=")
                .contains("record=");
        assertThat(execute("replay", "--help")).isZero();
        assertThat(out.toString()).contains("replay FILE", "delay=", "view=");
        assertThat(execute("--help")).isZero();
        assertThat(out.toString()).contains("play", "replay");
    }

    @ParameterizedTest
    @ValueSource(strings = {"competition", "mmneat"})
    void damagedRecording_isRefused(String rules) throws IOException {
        Path file = folder.resolve("whole.txt");
        assertThat(execute("play", "view=false", "games=1", "rules=" + rules, "record=" + file))
                .as(errors.toString())
                .isZero();
        List<String> states = Files.readAllLines(file);
        assertThat(execute("replay", file.toString(), "view=false"))
                .as(errors.toString())
                .isZero();
        assertDamaged("states are missing", states, lines -> lines.remove(50));
        assertDamaged(
                "states are missing", states, lines -> lines.subList(0, 20).clear());
        assertDamaged("states are missing", states, lines -> lines.add(60, lines.get(60)));
        assertDamaged("states are missing", states, lines -> java.util.Collections.swap(lines, 70, 71));
        assertDamaged("must be true or false", states, lines -> lines.set(30, lines.get(30) + "x"));
        assertDamaged(
                "must be true or false",
                states,
                lines -> lines.set(30, lines.get(30).replaceFirst("(true|false)(.*)", "maybe$2")));
        assertDamaged(
                "must have 0 or 1 for each pill",
                states,
                lines -> lines.set(30, lines.get(30).replaceFirst("[01]{50}", "2".repeat(50))));
    }

    private void assertDamaged(String message, List<String> states, java.util.function.Consumer<List<String>> damage)
            throws IOException {
        List<String> lines = new ArrayList<>(states);
        damage.accept(lines);
        Path damaged = Files.write(folder.resolve("damaged.txt"), lines);
        assertMistake(message, "replay", damaged.toString(), "view=false");
    }
}
