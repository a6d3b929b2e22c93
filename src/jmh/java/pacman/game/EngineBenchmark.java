package pacman.game;

import java.util.concurrent.TimeUnit;
import mmneat.random.ResumableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.RandomPacMan;
import pacman.game.Constants.DM;
import pacman.game.Constants.MOVE;

/**
 * Measures steps, copies and path queries of the engine. Run with {@code -prof gc}: stepping and path lengths allocate
 * nothing.
 */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 5, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(5)
@State(Scope.Thread)
public class EngineBenchmark {

    /** Number of steps of one call; when a game ends, the next one starts. */
    private static final int STEPS = 10_000;

    private static final int QUERIES = 1 << 16;

    private final ResumableRandom seeds = new ResumableRandom(1);
    private final ResumableRandom scratch = new ResumableRandom(2);
    private final Legacy legacy = new Legacy();
    private final RandomPacMan pacMan = new RandomPacMan();
    private final Game game = new Game(0);
    private final int[] from = new int[QUERIES];
    private final int[] to = new int[QUERIES];
    private final MOVE[] lastMove = new MOVE[QUERIES];

    @Setup
    public void drawQueries() {
        ResumableRandom random = new ResumableRandom(3);
        for (int query = 0; query < QUERIES; query++) {
            from[query] = random.nextInt(game.getNumberOfNodes() - 1);
            to[query] = random.nextInt(game.getNumberOfNodes() - 1);
            MOVE[] moves = game.getPossibleMoves(from[query]);
            lastMove[query] = moves[random.nextInt(moves.length)].opposite();
        }
    }

    /** Random Ms. Pac-Man against Legacy in one game object that is restarted: only decisions and steps. */
    @Benchmark
    @OperationsPerInvocation(STEPS)
    public int steps(StartedGame started) {
        Game game = started.game;
        for (int step = 0; step < STEPS; step++) {
            if (game.gameOver()) {
                game.restart(seeds.nextLong());
            }
            game.continueAsCopy(scratch);
            MOVE move = pacMan.decide(game, scratch);
            game.continueAsCopy(scratch);
            game.advanceGame(move, legacy.decideMoves(game, scratch));
        }
        return game.getScore();
    }

    /** As {@link #steps}, with the two copies per step of the competition's loop. */
    @Benchmark
    @OperationsPerInvocation(STEPS)
    public int stepsWithTwoCopies(StartedGame started) {
        Game game = started.game;
        for (int step = 0; step < STEPS; step++) {
            if (game.gameOver()) {
                game.restart(seeds.nextLong());
            }
            game.advanceGame(pacMan.getMove(game.copy(), -1), legacy.getMove(game.copy(), -1));
        }
        return game.getScore();
    }

    /** A game in the middle of its first level. */
    @State(Scope.Thread)
    public static class StartedGame {
        /**
         * The random numbers that its copies draw. Those of independent copies cost two seeds per step, and the games
         * differ.
         */
        @Param({"ARE_INDEPENDENT", "CONTINUE_THE_GAME"})
        public GameRules.Copies copies;

        private Game game;

        @Setup
        public void play() {
            game = new Game(1, GameRules.competition().withCopies(copies));
            for (int step = 0; step < 300; step++) {
                game.advanceGame(MOVE.LEFT, null);
            }
        }
    }

    /** Copies of a game. */
    @Benchmark
    public Game copies(StartedGame started) {
        return started.game.copy();
    }

    /** Lengths of paths that do not turn back. */
    @Benchmark
    @OperationsPerInvocation(QUERIES)
    public int directedPathLengths() {
        int sum = 0;
        for (int query = 0; query < QUERIES; query++) {
            sum += game.getShortestPathDistance(from[query], to[query], lastMove[query]);
        }
        return sum;
    }

    /** Moves towards a target by path distance without turning back. */
    @Benchmark
    @OperationsPerInvocation(QUERIES)
    public int nextMoves() {
        int sum = 0;
        for (int query = 0; query < QUERIES; query++) {
            sum += game.getNextMoveTowardsTarget(from[query], to[query], lastMove[query], DM.PATH)
                    .ordinal();
        }
        return sum;
    }
}
