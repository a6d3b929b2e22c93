package mmneat.mspacman;

import pacman.game.Game;

/**
 * Is told what happens in an evaluation, in order: for reports, recordings and pictures. Games and counts that are passed on
 * are the live ones: to be read only, and only during the call.
 */
public interface EvaluationObserver {

    /** A trial begins; trials are numbered from 0. */
    default void trialStarted(int trial) {}

    /** A game of the trial begins. */
    default void gameStarted(TrialGame setting, Game game) {}

    /** A step was played. */
    default void stepPlayed(Game game, DirectionEvaluator player) {}

    /**
     * A level was finished.
     *
     * @param level from 0
     * @param maze index of its maze
     */
    default void levelFinished(int level, int maze) {}

    /**
     * A game is over.
     *
     * @param end why
     * @param player whose network uses are counted for this game
     */
    default void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {}

    /** A trial is over; these are its scores, before they are aggregated over the trials. */
    default void trialOver(int trial, double[] objectives, double[] otherScores) {}
}
