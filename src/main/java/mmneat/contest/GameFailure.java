package mmneat.contest;

import java.util.Optional;

/**
 * A controller's failure in a game.
 *
 * @param game number of the game, from 1
 * @param time game time in steps at which it failed; -1 if it is not known, as in timed games
 * @param controller name of the controller; empty if {@code what} names it
 * @param what what the controller threw or did
 * @param thrown what the controller threw; empty if it threw nothing
 */
public record GameFailure(int game, int time, String controller, String what, Optional<Throwable> thrown) {

    /** In which game it failed, and at which time of it. */
    String place() {
        return "in game " + game + (time < 0 ? "" : " at time " + time);
    }

    /** Who failed, and how: one line without a full stop. */
    public String sentence() {
        return controller.isEmpty() ? what : controller + " failed: " + what;
    }
}
