package mmneat.experiment.parameters;

import java.util.EnumMap;
import java.util.function.Supplier;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;
import mmneat.mspacman.OwnGhostTeam;
import mmneat.neat.BadPartException;
import pacman.controllers.Controller;
import pacman.controllers.NewGhostController;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;

/**
 * Factory of the ghosts' controllers if the parameter {@code ghostTeam} names a class of the user's own: any controller
 * of the ghosts, for example a contest's entry.
 */
final class OwnGhosts {

    private static final String NAME = "ghostTeam";

    private OwnGhosts() {}

    /** @throws UserError if the class is not a controller of the ghosts or cannot be created */
    static Supplier<NewGhostController> factory(String className, OwnClasses classes) {
        requireGhosts(className, classes.find(NAME, className, Controller.class));
        team(className, classes);
        return () -> new OwnGhostTeam(() -> laterTeam(className, classes));
    }

    /** The return type of the most special {@code getMove} tells whose moves a controller decides on. */
    private static void requireGhosts(String className, Class<?> type) {
        try {
            Class<?> moves = type.getMethod("getMove", Game.class, long.class).getReturnType();
            if (moves == MOVE.class) {
                throw new UserError(NAME + "=" + className + ": is a controller of Ms. Pac-Man, not of the ghosts");
            }
        } catch (NoSuchMethodException | LinkageError e) {
            throw new UserError(NAME + "=" + className + ": the class cannot be loaded: " + PlainText.shown(e), e);
        }
    }

    /** Creates a team during a run, where the part of the user's own is named, not the parameter. */
    private static Controller<EnumMap<GHOST, MOVE>> laterTeam(String className, OwnClasses classes) {
        try {
            return team(className, classes);
        } catch (UserError e) {
            throw new BadPartException(
                    "ghost team " + className, "cannot be created: " + PlainText.shown(e.getCause()));
        }
    }

    @SuppressWarnings("unchecked") // requireGhosts refuses controllers of Ms. Pac-Man.
    private static Controller<EnumMap<GHOST, MOVE>> team(String className, OwnClasses classes) {
        return classes.make(NAME, className, Controller.class);
    }
}
