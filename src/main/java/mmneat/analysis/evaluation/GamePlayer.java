package mmneat.analysis.evaluation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import mmneat.evolution.Evaluation;
import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.ModuleUse;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.mspacman.objectives.GameObjective;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Game;

/** Plays single games of a network and records their results. Not thread-safe. */
final class GamePlayer implements EvaluationObserver {

    /** Indices into {@link GameObjective#PUBLISHED}. */
    private static final int GHOSTS = 0;

    private static final int PILLS = 1;

    /** Index into the other scores of the task. */
    private static final int SCORE = 0;

    private final MsPacManTask task;
    private final Genotype genotype;
    private @Nullable GameEnd end;
    private int maze;
    private int levels;

    @SuppressWarnings("NullAway.Init")
    private ModuleUse use;

    GamePlayer(MsPacManTaskSettings settings, Genotype genotype) {
        // Tables of games have the same columns whatever the network was selected for.
        task = new MsPacManTask(settings.forSingleGames().withObjectives(GameObjective.PUBLISHED));
        this.genotype = genotype;
    }

    GameResult play(int number, long seed) {
        end = null;
        use = new ModuleUse(genotype.modules());
        levels = 0;
        Evaluation evaluation = task.evaluate(genotype, new ResumableRandom(seed), this);
        List<long[]> counts = new ArrayList<>();
        for (ModuleUse.When when : ModuleUse.When.values()) {
            counts.add(Arrays.stream(use.ofChosenDirection(when)).asLongStream().toArray());
        }
        return new GameResult(
                number,
                seed,
                evaluation.otherScores()[SCORE],
                evaluation.objectives()[GHOSTS],
                evaluation.objectives()[PILLS],
                levels,
                evaluation.outcomes().steps(),
                Objects.requireNonNull(end, "the game is over"),
                maze,
                counts);
    }

    @Override
    public void gameStarted(TrialGame setting, Game game) {
        if (end == null) {
            maze = game.getMazeIndex();
        }
    }

    @Override
    public void stepPlayed(Game game, DirectionEvaluator player) {
        if (end == null && !game.gameOver()) {
            maze = game.getMazeIndex();
        }
    }

    @Override
    public void levelFinished(int level, int finishedMaze) {
        levels += end == null ? 1 : 0;
    }

    @Override
    public void gameOver(TrialGame setting, Game game, GameEnd reason, DirectionEvaluator player) {
        use.add(player.moduleUse());
        if (end == null) {
            end = reason;
        }
    }
}
