package mmneat.analysis.recording;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import pacman.game.Constants;
import pacman.game.Game;

/**
 * Records where the ghosts are when a champion eats a power pill while all four are outside the lair and none is
 * edible: the situations from which the ghost-eating games of the isolated version start.
 *
 * <p>Call {@link #playGame} with {@link #scarcestMaze} until {@link #isComplete}, then get the recording by {@link
 * #text}. A weak champion may never reach some power pill, so limit the number of {@link #games}; {@link #missing} then
 * tells which situations are missing.
 *
 * <p>The same champion, settings and seed give the same recording. {@link pacman.game.GhostLocations} reads its text.
 *
 * <p>Source: the paper's description of the isolated task; docs/specification/simulator.md, section 7 (database);
 * docs/specification/evolution.md, section 5.1 (PowerPillToGhostLocationMapping log).
 */
public final class GhostLocationRecorder {

    private static final int POWER_PILLS = 4;
    private static final int GHOSTS = Constants.NUM_GHOSTS;

    private final MsPacManTaskSettings settings;
    private final Genotype champion;
    private final ResumableRandom random;
    private final int wanted;
    private final Notes notes = new Notes();

    /** Lines of text for each power pill, at index maze 4 + power pill. */
    private final List<List<String>> lines = new ArrayList<>();

    private int games;

    /**
     * A recorder that has recorded nothing yet.
     *
     * @param settings the settings of the games, of the blended or interleaved version. The object is not changed; each
     *     game uses a copy with its own first maze
     * @param champion the network that plays
     * @param wanted situations for each power pill of each maze, at least 1
     * @param seed of the generator of all games
     */
    public GhostLocationRecorder(MsPacManTaskSettings settings, Genotype champion, int wanted, long seed) {
        if (wanted < 1) {
            throw new IllegalArgumentException("number of observations must be at least 1, is " + wanted);
        }
        this.settings = settings.withTrials(1);
        this.champion = champion;
        this.wanted = wanted;
        random = new ResumableRandom(seed);
        for (int key = 0; key < Constants.NUM_MAZES * POWER_PILLS; key++) {
            lines.add(new ArrayList<>());
        }
    }

    /**
     * Plays one game and keeps its situations, except for power pills that already have the wanted number.
     *
     * @param firstMaze maze in which it starts, 0 to 3
     */
    public void playGame(int firstMaze) {
        MsPacManTaskSettings started = settings.withGames(
                all -> all.withRules(rules -> rules.withMazes(mazes -> mazes.withInitialMaze(firstMaze))));
        new MsPacManTask(started).evaluate(champion, random, notes);
        games++;
    }

    /**
     * The maze with the power pill that has the fewest situations: where a game should start to find what is missing.
     */
    public int scarcestMaze() {
        return scarcest() / POWER_PILLS;
    }

    private int scarcest() {
        int scarcest = 0;
        for (int key = 1; key < lines.size(); key++) {
            scarcest = lines.get(key).size() < lines.get(scarcest).size() ? key : scarcest;
        }
        return scarcest;
    }

    /** The power pill that has the fewest situations, in words. */
    public String scarcestPowerPill() {
        return inWords(scarcest());
    }

    /** Whether every power pill has as many situations as wanted. */
    public boolean isComplete() {
        return lines.stream().allMatch(situations -> situations.size() == wanted);
    }

    /** Number of situations in the recording so far. */
    public int recorded() {
        return lines.stream().mapToInt(List::size).sum();
    }

    /** Number of situations that are wanted in all. */
    public int wantedInAll() {
        return lines.size() * wanted;
    }

    /** Number of games that were played. */
    public int games() {
        return games;
    }

    /**
     * The power pills that have too few situations, for example "maze 2 power pill 0 (34 of 100)"; empty if complete.
     */
    public String missing() {
        return IntStream.range(0, lines.size())
                .filter(key -> lines.get(key).size() < wanted)
                .mapToObj(this::inWords)
                .collect(Collectors.joining(", "));
    }

    private String inWords(int key) {
        return "maze " + key / POWER_PILLS + " power pill " + key % POWER_PILLS + " ("
                + lines.get(key).size() + " of " + wanted + ")";
    }

    /** The recording in the original's format, by maze and power pill, each in the order in which it was recorded. */
    public String text() {
        return lines.stream().flatMap(List::stream).collect(Collectors.joining("\n", "", "\n"));
    }

    /**
     * The observer that records the situations. In a time step Ms.&nbsp;Pac-Man moves first. When she eats a power
     * pill, the ghosts are still at their places after the previous step, so these places are remembered and recorded.
     */
    private final class Notes implements EvaluationObserver {

        private final int[] ghosts = new int[GHOSTS];
        private boolean areAllThreats;
        private int level;

        @Override
        public void gameStarted(TrialGame setting, Game game) {
            remember(game);
        }

        @Override
        public void stepPlayed(Game game, DirectionEvaluator player) {
            boolean isSameMaze = game.getCurrentLevel() == level;
            if (areAllThreats && isSameMaze && game.wasPowerPillEaten()) {
                note(game.getMazeIndex(), game.getPowerPillIndex(game.getPacmanCurrentNodeIndex()));
            }
            remember(game);
        }

        private void remember(Game game) {
            level = game.getCurrentLevel();
            areAllThreats = true;
            for (int ghost = 0; ghost < GHOSTS; ghost++) {
                ghosts[ghost] = game.ghostNode(ghost);
                areAllThreats &= game.ghostEdibleTime(ghost) == 0 && game.ghostLairTime(ghost) == 0;
            }
        }

        private void note(int maze, int powerPill) {
            List<String> situations = lines.get(maze * POWER_PILLS + powerPill);
            if (situations.size() < wanted) {
                situations.add(maze + "\t" + powerPill + "\t" + ghosts[0] + "\t" + ghosts[1] + "\t" + ghosts[2] + "\t"
                        + ghosts[3]);
            }
        }
    }
}
