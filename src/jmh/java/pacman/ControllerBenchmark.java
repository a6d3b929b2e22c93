package pacman;

import java.util.EnumMap;
import java.util.concurrent.TimeUnit;
import mmneat.random.ResumableRandom;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import pacman.controllers.Controller;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.RandomPacMan;
import pacman.controllers.examples.StarterPacMan;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/** Measures steps per second of games between example controllers, played by {@link Executor} and by the plain loop. */
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.SECONDS)
@Warmup(iterations = 5, time = 2)
@Measurement(iterations = 5, time = 2)
@Fork(5)
@State(Scope.Thread)
public class ControllerBenchmark {

    /** Number of steps of one call; when a game ends, the next one starts. */
    private static final int STEPS = 10_000;

    private final ResumableRandom seeds = new ResumableRandom(1);
    private final Controller<EnumMap<GHOST, MOVE>> legacy = new Legacy();
    private final Controller<MOVE> random = new RandomPacMan();
    private final UntimedRun randomAgainstLegacy = new UntimedRun(random, legacy, UntimedRun.DueTime.ONCE_PER_TICK);
    private final UntimedRun starterAgainstLegacy =
            new UntimedRun(new StarterPacMan(), legacy, UntimedRun.DueTime.ONCE_PER_TICK);
    private final Game game = new Game(0);

    /** Random Ms. Pac-Man; built-in controllers need no copies. */
    @Benchmark
    @OperationsPerInvocation(STEPS)
    public int randomPacManAgainstLegacy() {
        for (int step = 0; step < STEPS; step++) {
            renewGame();
            randomAgainstLegacy.tick(game);
        }
        return game.getScore();
    }

    /** Random Ms. Pac-Man; each controller gets its copy in each step, as an outside controller does. */
    @Benchmark
    @OperationsPerInvocation(STEPS)
    public int randomPacManAgainstLegacyWithCopies() {
        for (int step = 0; step < STEPS; step++) {
            renewGame();
            game.advanceGame(random.getMove(game.copy(), -1), legacy.getMove(game.copy(), -1));
        }
        return game.getScore();
    }

    /** StarterPacMan; built-in controllers need no copies. */
    @Benchmark
    @OperationsPerInvocation(STEPS)
    public int starterPacManAgainstLegacy() {
        for (int step = 0; step < STEPS; step++) {
            renewGame();
            starterAgainstLegacy.tick(game);
        }
        return game.getScore();
    }

    private void renewGame() {
        if (game.gameOver()) {
            game.restart(seeds.nextLong());
        }
    }
}
