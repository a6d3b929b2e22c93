package pacman.game;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.stream.IntStream;
import mmneat.GoldenData;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;

/** Scripted runs of the original engine, compared at checkpoints of the whole state. */
@Tag("conformance")
class EngineRunConformanceTest {

    private static final int LONGEST_RUN = 6000;

    @ParameterizedTest
    @CsvSource({
        "blended, 11, 50, -1",
        "interleaved, 12, 50, -1",
        "isolated-pill, 13, 50, -1",
        "isolated-ghost-0, 14, 1, 0",
        "isolated-ghost-1, 15, 1, 1",
        "isolated-ghost-2, 16, 1, 2",
        "isolated-ghost-3, 17, 1, 3"
    })
    void run_equalsTheOriginals(String name, long seed, int lives, int corner) throws IOException {
        GameRules rules =
                switch (name) {
                    case "blended" -> GameRules.blended();
                    case "interleaved" -> GameRules.interleaved();
                    case "isolated-pill" -> GameRules.isolatedPills();
                    default -> GameRules.isolatedGhosts(corner, TraceConformanceTest.originalGhostLocations());
                };
        assertThat(run(expected(name), seed, lives, rules)).isEqualTo(expected(name));
    }

    static boolean isTheOriginals(String name, long seed, int lives, GameRules rules) throws IOException {
        return run(expected(name), seed, lives, rules).equals(expected(name));
    }

    private static List<String> expected(String name) throws IOException {
        return Files.readAllLines(GoldenData.folder("engine").resolve(name + ".txt"));
    }

    private static List<String> run(List<String> expected, long seed, int lives, GameRules rules) {
        ResumableRandom shared = new ResumableRandom(99);
        Game game = new Game(seed, rules.withLevels(levels -> levels.withLives(lives)), shared);
        List<String> actual = new ArrayList<>();
        int next = 0;
        for (int step = 0; ; step++) {
            if (next < expected.size() && expected.get(next).startsWith(step + "\t")) {
                actual.add(step + "\t" + game.gameOver() + "\t" + game.getGameState());
                next++;
            }
            if (game.gameOver() || step == LONGEST_RUN) {
                break;
            }
            game.advanceGame(pacManMove(game, rules.mazes().startingPowerPill() >= 0), ghostMoves(step));
        }
        actual.add("global\t" + shared.nextLong());
        return actual;
    }

    private static MOVE pacManMove(Game game, boolean chasesGhosts) {
        int[] targets = chasesGhosts
                ? IntStream.range(0, 4)
                        .filter(ghost -> game.ghostEdibleTime(ghost) > 0)
                        .map(game::ghostNode)
                        .toArray()
                : IntStream.concat(
                                IntStream.of(game.getActivePillsIndices()),
                                IntStream.of(game.getActivePowerPillsIndices()))
                        .toArray();
        if (targets.length == 0) {
            return MOVE.NEUTRAL;
        }
        int here = game.getPacmanCurrentNodeIndex();
        int target = game.getClosestNodeIndexFromNodeIndex(here, targets, DM.PATH);
        return game.getNextMoveTowardsTarget(here, target, DM.PATH);
    }

    private static EnumMap<GHOST, MOVE> ghostMoves(int step) {
        if (step % 3 == 0) {
            return null;
        }
        EnumMap<GHOST, MOVE> moves = new EnumMap<>(GHOST.class);
        for (GHOST ghost : GHOST.values()) {
            if ((step + ghost.ordinal()) % 5 != 4) {
                moves.put(ghost, MOVE.values()[(step / 4 + ghost.ordinal()) % 4]);
            }
        }
        return moves;
    }
}
