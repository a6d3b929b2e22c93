package mmneat.contest;

import java.util.Optional;

/**
 * The failure of a controller in a game.
 *
 * @param game number of the game, from 1
 * @param time game time of the failure in steps; -1 if it is unknown, as in timed games
 * @param controller name of the controller; empty if {@code what} names it
 * @param what what the controller threw or did
 * @param thrown what the controller threw; empty if it threw nothing
 */
public record GameFailure(int game, int time, String controller, String what, Optional<Throwable> thrown) {

    /** Returns the game and the time of the failure. */
    String place() {
        return "in game " + game + (time < 0 ? "" : " at time " + time);
    }

    /** Returns which controller failed and how, in one line without a full stop. */
    public String sentence() {
        return controller.isEmpty() ? what : controller + " failed: " + what;
    }
}
