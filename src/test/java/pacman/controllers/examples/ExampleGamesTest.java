package pacman.controllers.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import mmneat.GoldenData;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import pacman.Executor;
import pacman.controllers.Controller;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GameRules;
import pacman.game.GhostLocations;

/** Whole games between the examples end like the original's, with and without copies of the game. */
class ExampleGamesTest {

    private static final Map<String, Supplier<Controller<MOVE>>> PACMEN = Map.of(
            "StarterPacMan", StarterPacMan::new,
            "NearestPillPacMan", NearestPillPacMan::new,
            "RandomNonRevPacMan", RandomNonRevPacMan::new,
            "RandomPacMan", RandomPacMan::new);

    private static final Map<String, Supplier<Controller<EnumMap<GHOST, MOVE>>>> TEAMS = Map.of(
            "Legacy", Legacy::new,
            "DeterministicLegacy", DeterministicLegacy::new,
            "BetterLegacy", BetterLegacy::new,
            "VeryRandomLegacy", VeryRandomLegacy::new,
            "ChaseFleeGhosts", ChaseFleeGhosts::new,
            "Legacy2TheReckoning", Legacy2TheReckoning::new,
            "AggressiveGhosts", AggressiveGhosts::new,
            "RandomGhosts", RandomGhosts::new,
            "StarterGhosts", StarterGhosts::new,
            "PansyGhosts", PansyGhosts::new);

    /** A line of the data: the settings of a game and its result. */
    record ExampleGame(
            int lives, long seed, String pacMan, String ghosts, int score, int totalTime, int level, long generator) {

        static ExampleGame parse(String line) {
            String[] fields = line.split("\t");
            return new ExampleGame(
                    Integer.parseInt(fields[0]),
                    Long.parseLong(fields[1]),
                    fields[2],
                    fields[3],
                    Integer.parseInt(fields[4]),
                    Integer.parseInt(fields[5]),
                    Integer.parseInt(fields[6]),
                    Long.parseLong(fields[7]));
        }

        ExampleGame played(boolean withCopies) {
            GameRules rules = GameRules.mmneat().withLevels(levels -> levels.withLives(lives));
            Game game = new Game(seed, rules, new ResumableRandom(0));
            Controller<MOVE> player = PACMEN.get(pacMan).get();
            Controller<EnumMap<GHOST, MOVE>> team = TEAMS.get(ghosts).get();
            if (withCopies) {
                playWithCopies(game, player, team);
            } else {
                new Executor().runExperiment(player, team, game);
            }
            return new ExampleGame(
                    lives,
                    seed,
                    pacMan,
                    ghosts,
                    game.getScore(),
                    game.getTotalTime(),
                    game.getCurrentLevel(),
                    game.rnd.bits());
        }

        /** Plays with the plain loop of the competition. */
        private static void playWithCopies(Game game, Controller<MOVE> player, Controller<EnumMap<GHOST, MOVE>> team) {
            while (!game.gameOver()) {
                game.advanceGame(player.getMove(game.copy(), -1), team.getMove(game.copy(), -1));
            }
        }
    }

    @Tag("conformance")
    @Test
    void originalsGames_endTheSame() throws IOException {
        List<ExampleGame> expected =
                read(Files.readAllLines(GoldenData.folder("controllers").resolve("example-games.tsv")));
        assertThat(expected).hasSize(120);
        assertEndTheSame(expected);
    }

    @Test
    void recordedGames_endTheSame() throws IOException {
        try (InputStream recorded = ExampleGamesTest.class.getResourceAsStream("example-games.tsv")) {
            List<ExampleGame> expected = read(new String(recorded.readAllBytes(), StandardCharsets.UTF_8)
                    .lines()
                    .toList());
            assertThat(expected).hasSize(40);
            assertEndTheSame(expected);
        }
    }

    private static void assertEndTheSame(List<ExampleGame> expected) {
        for (ExampleGame game : expected) {
            assertThat(game.played(false)).isEqualTo(game);
            assertThat(game.played(true)).isEqualTo(game);
        }
    }

    static List<String> teams() {
        return TEAMS.keySet().stream().sorted().toList();
    }

    @ParameterizedTest
    @MethodSource("teams")
    void readOnlyControllers_needNoCopies(String team) {
        for (String pacMan : PACMEN.keySet()) {
            for (long seed = 100; seed < 110; seed++) {
                ExampleGame game = new ExampleGame(3, seed, pacMan, team, 0, 0, 0, 0);
                assertThat(game.played(false)).isEqualTo(game.played(true));
            }
        }
    }

    private static List<ExampleGame> read(List<String> lines) {
        List<ExampleGame> games = new ArrayList<>();
        for (String line : lines) {
            if (!line.startsWith("#") && !line.startsWith("lives")) {
                games.add(ExampleGame.parse(line));
            }
        }
        return games;
    }

    @Test
    void randomNonReversing_goesAnywhere_whereNothingLeadsTheWayItLooks() {
        Game game = new Game(0, GameRules.isolatedGhosts(1, GhostLocations.shipped()));
        RandomNonRevPacMan pacMan = new RandomNonRevPacMan();
        assertThat(game.getPossibleMoves(game.getPacmanCurrentNodeIndex(), game.getPacmanLastMoveMade()))
                .isNull();
        assertThat(game.getPossibleMoves(game.getPacmanCurrentNodeIndex())).contains(pacMan.getMove(game, -1));
    }
}
