package pacman.game;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import pacman.game.Constants.MOVE;
import pacman.maze.MazeTables;

/**
 * Measures the time from process start to the first queries in all four mazes: drawings, graphs, distances, paths and
 * the competition's interface. Each call is in a new Java process.
 */
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Warmup(iterations = 0)
@Measurement(iterations = 1)
@Fork(10)
@State(Scope.Thread)
public class StartupBenchmark {

    @Benchmark
    public int fourMazes() {
        int sum = 0;
        for (int maze = 0; maze < Constants.NUM_MAZES; maze++) {
            Game game = new Game(0, maze);
            MazeTables tables = game.mazeTables();
            sum += game.getShortestPath(0, tables.graph().pacManStart(), MOVE.NEUTRAL).length;
        }
        return sum;
    }
}
