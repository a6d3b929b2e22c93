package pacman.game;

import java.util.stream.IntStream;
import pacman.maze.Mazes;

/**
 * The rules for the mazes of a game and its start. Immutable.
 *
 * <p>Source: docs/specification/simulator.md, sections 2 and 7.
 *
 * @param mazes the mazes of the levels
 * @param initialMaze index of the first level's maze
 * @param onlyMaze index of a maze in which all levels are played, -1 for all mazes in turn
 * @param startingPowerPill number of the power pill on which Ms. Pac-Man starts, -1 for the maze's start
 */
public record MazeRules(Mazes mazes, int initialMaze, int onlyMaze, int startingPowerPill) {

    /** MM-NEAT's defaults: the four mazes of the competition in turn. */
    static final MazeRules MM_NEAT = new MazeRules(Mazes.standard(), 0, -1, -1);

    /** @throws IllegalArgumentException if a value is out of its range */
    public MazeRules {
        if (mazes == null) {
            throw new IllegalArgumentException("mazes are needed");
        }
        GameRules.requireRange("initialMaze", initialMaze, 0, mazes.count() - 1);
        GameRules.requireRange("onlyMaze", onlyMaze, -1, mazes.count() - 1);
        // The mazes of the competition are not loaded for this.
        int fewest = mazes == Mazes.standard()
                ? GhostLocations.POWER_PILLS
                : IntStream.range(0, mazes.count())
                        .map(index -> mazes.get(index).graph().powerPillCount())
                        .min()
                        .getAsInt();
        GameRules.requireRange("startingPowerPill", startingPowerPill, -1, fewest - 1);
    }

    public MazeRules withMazes(Mazes value) {
        return new MazeRules(value, initialMaze, onlyMaze, startingPowerPill);
    }

    public MazeRules withInitialMaze(int value) {
        return new MazeRules(mazes, value, onlyMaze, startingPowerPill);
    }

    public MazeRules withOnlyMaze(int value) {
        return new MazeRules(mazes, initialMaze, value, startingPowerPill);
    }

    public MazeRules withStartingPowerPill(int value) {
        return new MazeRules(mazes, initialMaze, onlyMaze, value);
    }
}
