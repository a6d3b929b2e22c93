package mmneat.mspacman;

import java.util.EnumMap;
import java.util.List;
import java.util.concurrent.CancellationException;
import mmneat.evolution.Evaluation;
import mmneat.evolution.Evaluation.Outcomes;
import mmneat.evolution.FailedEvaluationException;
import mmneat.evolution.ScoreStatistic;
import mmneat.evolution.Task;
import mmneat.mspacman.objectives.GameObjective;
import mmneat.mspacman.objectives.GameScore;
import mmneat.mspacman.objectives.RecordedScore;
import mmneat.mspacman.sensors.suite.NetworkInputs;
import mmneat.mspacman.sensors.suite.SensorSuite;
import mmneat.neat.Genotype;
import mmneat.neat.Thrown;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.controllers.DirectGhosts;
import pacman.controllers.NewGhostController;
import pacman.controllers.ReadOnlyController;
import pacman.controllers.examples.LiveReaders;
import pacman.game.Constants;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * The task of the paper: networks play Ms.&nbsp;Pac-Man. An evaluation plays several trials and aggregates their
 * scores.
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 2 and 5.
 */
public final class MsPacManTask implements Task {

    private static final MOVE[] MOVES = MOVE.values();

    private final MsPacManTaskSettings settings;
    private final SensorSuite suite;
    private final NetworkInputs senses;
    private final List<TrialGame> games;
    private final List<GameObjective> objectives;
    private final List<RecordedScore> others;
    private final NewGhostController ghosts;
    private final @Nullable ReadOnlyController<EnumMap<GHOST, MOVE>> readOnlyGhosts;
    /** The ghosts, if they only read and need no map; else null. */
    private final @Nullable DirectGhosts directGhosts;

    /**
     * Scratch generator for ghosts that only read the game, set to the state that their copy's generator would have.
     */
    private final ResumableRandom scratch = new ResumableRandom(0);

    /** Creates a task, which is used by one thread. */
    public MsPacManTask(MsPacManTaskSettings settings) {
        this.settings = settings;
        suite = SensorSuite.of(settings.networks().sensors());
        senses = suite.newInputs();
        games = settings.games().ofTrial();
        others = RecordedScore.ofTheOriginal(settings.games().rules());
        objectives = settings.objectives();
        ghosts = settings.games().ghosts().get();
        readOnlyGhosts = LiveReaders.of(ghosts).orElse(null);
        directGhosts = readOnlyGhosts instanceof DirectGhosts direct ? direct : null;
    }

    /** The settings of an evaluation. */
    public MsPacManTaskSettings settings() {
        return settings;
    }

    @Override
    public List<String> objectiveNames() {
        return objectives.stream().map(GameObjective::name).toList();
    }

    @Override
    public double[] referencePoint() {
        return objectives.stream().mapToDouble(GameObjective::worst).toArray();
    }

    @Override
    public List<String> otherScoreNames() {
        return others.stream().map(other -> other.score().name()).toList();
    }

    @Override
    public List<String> otherScoreLabels() {
        return others.stream().map(RecordedScore::label).toList();
    }

    /** {@inheritDoc} Here it is the mean game score. */
    @Override
    public double championScore(Evaluation evaluation) {
        return evaluation.otherScores()[0];
    }

    /**
     * {@inheritDoc} Here it is the mean game score without its fraction, a quirk of the original: champions are chosen
     * by whole points, but reported with {@link #championScore}. Source: docs/specification/evolution.md, section 5.5.
     */
    @Override
    public double championRank(Evaluation evaluation) {
        return (int) championScore(evaluation);
    }

    @Override
    public List<String> inputLabels() {
        return suite.labels(-1);
    }

    @Override
    public int policyNeuronsPerModule() {
        return 1;
    }

    @Override
    public int trials() {
        return settings.games().trials();
    }

    @Override
    public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
        return evaluate(genotype, random, null);
    }

    /**
     * Evaluates a genotype and reports its games to an observer, which does not influence the result.
     *
     * @param observer may be null
     * @throws IllegalArgumentException if the genotype's inputs or modules do not fit the task
     */
    public Evaluation evaluate(Genotype genotype, ResumableRandom random, @Nullable EvaluationObserver observer) {
        NetworkSettings networks = settings.networks();
        DirectionEvaluator player =
                new DirectionEvaluator(senses, genotype, networks.arbitration(), networks.division());
        double[][] trialObjectives = new double[objectives.size()][trials()];
        double[][] trialOthers = new double[others.size()][trials()];
        Outcomes outcomes = Outcomes.NONE;
        for (int trial = 0; trial < trials(); trial++) {
            if (observer != null) {
                observer.trialStarted(trial);
            }
            for (TrialGame setting : games) {
                long seed = settings.games().deterministic() ? trial : random.nextLong();
                Game game = new Game(seed, setting.rules(), random);
                GameEnd end = playTrial(trial, setting, game, player, random, observer);
                outcomes = outcomes.plus(outcome(game, end));
                addScores(setting, game, trial, trialObjectives, trialOthers);
            }
            if (observer != null) {
                observer.trialOver(trial, column(trialObjectives, trial), column(trialOthers, trial));
            }
        }
        return new Evaluation(
                aggregate(trialObjectives, i -> objectives.get(i).statistic()),
                aggregate(trialOthers, i -> others.get(i).statistic()),
                player.rememberedModuleUsage(),
                outcomes);
    }

    /** Plays the games of a trial. An exception, for example of a user's sensor, names the trial. */
    private GameEnd playTrial(
            int trial,
            TrialGame setting,
            Game game,
            DirectionEvaluator player,
            ResumableRandom random,
            @Nullable EvaluationObserver observer) {
        try {
            return play(setting, game, player, random, observer);
        } catch (CancellationException e) {
            throw e;
        } catch (Throwable e) {
            new Thrown(e).passOnIfOfTheMachine();
            throw new FailedEvaluationException("trial " + (trial + 1) + " of " + trials(), e);
        }
    }

    private GameEnd play(
            TrialGame setting,
            Game game,
            DirectionEvaluator player,
            ResumableRandom random,
            @Nullable EvaluationObserver observer) {
        player.startGame();
        ghosts.reset();
        if (observer != null) {
            observer.gameStarted(setting, game);
        }
        boolean askedForEnd = false;
        while (!game.gameOver()) {
            int level = game.getCurrentLevel();
            int maze = game.getMazeIndex();
            int direction = player.decide(game, random);
            askedForEnd = direction == DirectionEvaluator.END_GAME;
            advance(game, askedForEnd ? null : MOVES[direction]);
            if (observer != null) {
                observer.stepPlayed(game, player);
                if (game.getCurrentLevel() > level) {
                    observer.levelFinished(level, maze);
                }
            }
        }
        GameEnd end = end(game, askedForEnd);
        if (observer != null) {
            observer.gameOver(setting, game, end, player);
        }
        return end;
    }

    private void advance(Game game, @Nullable MOVE move) {
        if (directGhosts != null) {
            game.continueAsCopy(scratch);
            game.advanceGame(move, directGhosts.decideMoves(game, scratch));
        } else if (readOnlyGhosts != null) {
            game.continueAsCopy(scratch);
            game.advanceGame(move, readOnlyGhosts.decide(game, scratch));
        } else {
            game.advanceGame(move, ghosts.getMove(game.copy(), -1));
        }
    }

    private static GameEnd end(Game game, boolean askedForEnd) {
        if (askedForEnd) {
            return GameEnd.LEVEL_TIME_LIMIT;
        }
        if (game.getPacmanNumberOfLivesRemaining() <= 0) {
            return GameEnd.LOST_ALL_LIVES;
        }
        if (game.getCurrentLevel() >= game.rules().levels().maximumLevel()) {
            return GameEnd.ALL_LEVELS_BEATEN;
        }
        return game.getTotalTime() >= Constants.MAX_TIME ? GameEnd.GAME_TIME_LIMIT : GameEnd.PUNISHED;
    }

    private static Outcomes outcome(Game game, GameEnd end) {
        // A level that ends twice counts twice: the quirk of docs/specification/mspacman-task.md, section 7.3.
        int beaten = Math.max(0, game.getCurrentLevel() - game.rules().levels().maximumLevel() + 1);
        return new Outcomes(
                beaten,
                end == GameEnd.LEVEL_TIME_LIMIT ? 1 : 0,
                game.getPacmanNumberOfLivesRemaining() <= 0 ? 1 : 0,
                game.getTotalTime());
    }

    /**
     * The other scores first, in their order: asking some of them has side effects on the game. So an objective gives
     * the same number as the recorded score of its name, and one of the user's own cannot change what is recorded.
     */
    private void addScores(
            TrialGame setting, Game game, int trial, double[][] trialObjectives, double[][] trialOthers) {
        for (int i = 0; i < others.size(); i++) {
            trialOthers[i][trial] =
                    plus(trialOthers[i][trial], others.get(i).score().of(game), setting);
        }
        for (int i = 0; i < objectives.size(); i++) {
            GameScore score = objectives.get(i).score();
            if (setting.countsGhosts() || score != GameScore.GHOST_REWARD) {
                trialObjectives[i][trial] = plus(trialObjectives[i][trial], score.of(game), setting);
            }
        }
    }

    /** Adds a score. The score of the first game is copied instead of added, so that minus zero is preserved. */
    private double plus(double sum, double score, TrialGame setting) {
        return setting == games.get(0) ? score : sum + score;
    }

    private static double[] column(double[][] scores, int trial) {
        double[] column = new double[scores.length];
        for (int i = 0; i < scores.length; i++) {
            column[i] = scores[i][trial];
        }
        return column;
    }

    private static double[] aggregate(double[][] scores, java.util.function.IntFunction<ScoreStatistic> statistic) {
        double[] aggregated = new double[scores.length];
        for (int i = 0; i < scores.length; i++) {
            aggregated[i] = statistic.apply(i).of(scores[i]);
        }
        return aggregated;
    }
}
