package mmneat.mspacman.objectives;

import pacman.game.Game;

/**
 * An objective of your own for the evolution of Ms. Pac-Man: a score of a finished game, larger is better. Implement
 * {@link #score}; the other methods have defaults.
 *
 * <p>An implementation has a public constructor without arguments and keeps no state: one object serves all threads of
 * a run. The parameter {@code objectives} of the command line names the class with its package, as in {@code
 * objectives=my.Objective,PillScore}. The scores of a trial's games are added up, and the sums are averaged over the
 * trials.
 */
public interface Objective {

    /** The name in the files and tables of a run: by default that of the class, without its package. */
    default String name() {
        return getClass().getSimpleName();
    }

    /**
     * The score of a finished game, larger is better.
     *
     * @param game over; to be read only
     * @return a finite number
     */
    double score(Game game);

    /**
     * The worst score possible in an evaluation, from which hypervolumes are measured: 0 unless overridden. Override it
     * if scores can be negative; a network with a worse score than this adds nothing to the hypervolume. Evolution does
     * not read it.
     */
    default double worst() {
        return 0;
    }
}
