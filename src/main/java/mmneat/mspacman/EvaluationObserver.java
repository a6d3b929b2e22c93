package mmneat.mspacman;

import pacman.game.Game;

/**
 * A receiver of the events of an evaluation, for reports, recordings and pictures. The order of events is: start of a
 * trial; for each game of the trial its start, its steps and finished levels, and its end; end of the trial. Override
 * the methods of the events that matter. Games and players that are passed are live objects: read them only during the
 * call and do not change them.
 */
public interface EvaluationObserver {

    /** Called when a trial starts; trials are numbered from 0. */
    default void trialStarted(int trial) {}

    /** Called when a game of the trial starts. */
    default void gameStarted(TrialGame setting, Game game) {}

    /** Called after each step. */
    default void stepPlayed(Game game, DirectionEvaluator player) {}

    /**
     * Called when a level was finished.
     *
     * @param level from 0
     * @param maze index of its maze
     */
    default void levelFinished(int level, int maze) {}

    /**
     * Called when a game is over.
     *
     * @param end why the game ended
     * @param player the player, with the module usage of this game
     */
    default void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {}

    /** Called when a trial is over, with its scores before aggregation over the trials. */
    default void trialOver(int trial, double[] objectives, double[] otherScores) {}
}
