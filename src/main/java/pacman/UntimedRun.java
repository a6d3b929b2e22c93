package pacman;

import java.util.EnumMap;
import java.util.function.Consumer;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.controllers.Controller;
import pacman.controllers.DirectGhosts;
import pacman.controllers.ReadOnlyController;
import pacman.controllers.examples.LiveReaders;
import pacman.game.Constants;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GhostMoves;

/**
 * Plays a game without time limit: controllers are called directly in the calling thread.
 *
 * <p>In each tick Ms. Pac-Man's controller gets a copy of the game, then the ghosts' controller another copy of the
 * same state, then the game advances by both answers. Copying a game takes longer than advancing it. So a controller
 * that only reads the game ({@link LiveReaders}) gets the game itself instead of a copy. Such a controller draws its
 * random numbers from a scratch generator, which belongs to the run. Before each decision the scratch generator is set
 * to the state that the generator of the copy would have: the answers are those that the controller gives for a copy.
 *
 * <p>Source: docs/specification/controllers.md, section 6.2.
 */
final class UntimedRun {

    /**
     * The rule for the argument {@code timeDue} of {@link Controller#getMove(Game, long)}. The run modes of the
     * competition differ in it.
     */
    enum DueTime {
        /** No due time: -1. */
        NONE,
        /** 40 ms from now, the same for both controllers. */
        ONCE_PER_TICK,
        /** 40 ms from the call of the controller. */
        PER_CONTROLLER
    }

    private final Controller<MOVE> pacMan;
    private final Controller<EnumMap<GHOST, MOVE>> ghosts;
    private final @Nullable ReadOnlyController<MOVE> readOnlyPacMan;
    private final @Nullable ReadOnlyController<EnumMap<GHOST, MOVE>> readOnlyGhosts;
    /** The ghosts, if they only read and need no map; else null. */
    private final @Nullable DirectGhosts directGhosts;

    private final DueTime dueTime;
    private final ResumableRandom scratch = new ResumableRandom(0);

    UntimedRun(Controller<MOVE> pacMan, Controller<EnumMap<GHOST, MOVE>> ghosts, DueTime dueTime) {
        this.pacMan = pacMan;
        this.ghosts = ghosts;
        this.dueTime = dueTime;
        readOnlyPacMan = LiveReaders.of(pacMan).orElse(null);
        readOnlyGhosts = LiveReaders.of(ghosts).orElse(null);
        directGhosts = readOnlyGhosts instanceof DirectGhosts direct ? direct : null;
    }

    /**
     * Plays until the game is over.
     *
     * @param afterTick called after each tick with the game
     */
    void play(Game game, Consumer<Game> afterTick) {
        while (!game.gameOver()) {
            tick(game);
            afterTick.accept(game);
        }
    }

    /** Plays until the game is over. */
    void play(Game game) {
        while (!game.gameOver()) {
            tick(game);
        }
    }

    /** Calls both controllers and advances the game. */
    void tick(Game game) {
        long due = due(DueTime.ONCE_PER_TICK);
        MOVE move;
        EnumMap<GHOST, MOVE> moves = null;
        int directMoves = GhostMoves.NONE;
        Controller<?> asked = pacMan;
        try {
            move = answer(pacMan, readOnlyPacMan, game, due);
            asked = ghosts;
            if (directGhosts == null) {
                moves = answer(ghosts, readOnlyGhosts, game, due);
            } else {
                game.continueAsCopy(scratch);
                directMoves = directGhosts.decideMoves(game, scratch);
            }
        } catch (Throwable failure) {
            ControllerFailure.report(failure, asked, game.getTotalTime());
            throw failure;
        }
        if (directGhosts == null) {
            advance(game, move, moves);
        } else {
            game.advanceGame(move, directMoves);
        }
    }

    /** Advances by a map of the ghosts' controller, whose methods and values may be anything. */
    private void advance(Game game, @Nullable MOVE move, @Nullable EnumMap<GHOST, MOVE> moves) {
        int time = game.getTotalTime();
        try {
            game.advanceGame(move, moves);
        } catch (Throwable failure) {
            ControllerFailure.report(failure, ghosts, time);
            throw failure;
        }
    }

    private <T> @Nullable T answer(
            Controller<T> controller, @Nullable ReadOnlyController<T> readOnly, Game game, long due) {
        if (readOnly != null) {
            game.continueAsCopy(scratch);
            return readOnly.decide(game, scratch);
        }
        return controller.getMove(game.copy(), dueTime == DueTime.PER_CONTROLLER ? due(DueTime.PER_CONTROLLER) : due);
    }

    /** Returns the due time. The clock is read only if it is needed. */
    private long due(DueTime moment) {
        return dueTime == moment && (readOnlyPacMan == null || readOnlyGhosts == null)
                ? System.currentTimeMillis() + Constants.DELAY
                : -1;
    }
}
