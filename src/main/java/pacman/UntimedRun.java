package pacman;

import java.util.EnumMap;
import java.util.Set;
import java.util.function.Consumer;
import mmneat.random.ResumableRandom;
import pacman.controllers.Controller;
import pacman.controllers.DirectGhosts;
import pacman.controllers.ReadOnlyController;
import pacman.controllers.examples.AggressiveGhosts;
import pacman.controllers.examples.BetterLegacy;
import pacman.controllers.examples.ChaseFleeGhosts;
import pacman.controllers.examples.DeterministicLegacy;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.Legacy2TheReckoning;
import pacman.controllers.examples.NearestPillPacMan;
import pacman.controllers.examples.RandomGhosts;
import pacman.controllers.examples.RandomNonRevPacMan;
import pacman.controllers.examples.RandomPacMan;
import pacman.controllers.examples.StarterGhosts;
import pacman.controllers.examples.StarterPacMan;
import pacman.controllers.examples.VeryRandomLegacy;
import pacman.game.Constants;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GhostMoves;

/**
 * A game in which the controllers are asked directly, in the calling thread, however long they take.
 *
 * <p>Per tick Ms. Pac-Man's controller gets a copy of the game, then the ghosts' controller another of the same state,
 * then the game advances by both answers. Source: docs/specification/controllers.md, section 6.2.
 */
final class UntimedRun {

    /** What a controller is told about the time by which its answer is wanted. */
    enum DueTime {
        /** -1. */
        NONE,
        /** 40 ms from now, the same for both controllers. */
        ONCE_PER_TICK,
        /** 40 ms from the moment at which the controller is asked. */
        PER_CONTROLLER
    }

    /*
     * Copying the game takes longer than advancing it. Controllers of ours that only read need no copy: they look at the
     * live game, and draw from a scratch generator that is set to where the game's stands. Exactly these classes, since
     * a subclass may do more than read.
     */
    private static final Set<Class<?>> READ_ONLY = Set.of(
            AggressiveGhosts.class,
            BetterLegacy.class,
            ChaseFleeGhosts.class,
            DeterministicLegacy.class,
            Legacy.class,
            Legacy2TheReckoning.class,
            NearestPillPacMan.class,
            RandomGhosts.class,
            RandomNonRevPacMan.class,
            RandomPacMan.class,
            StarterGhosts.class,
            StarterPacMan.class,
            VeryRandomLegacy.class);

    private final Controller<MOVE> pacMan;
    private final Controller<EnumMap<GHOST, MOVE>> ghosts;
    private final ReadOnlyController<MOVE> readOnlyPacMan;
    private final ReadOnlyController<EnumMap<GHOST, MOVE>> readOnlyGhosts;
    /** The team among {@link #READ_ONLY} that needs no map either; null if it is another. */
    private final DirectGhosts directGhosts;

    private final DueTime dueTime;
    private final ResumableRandom scratch = new ResumableRandom(0);

    UntimedRun(Controller<MOVE> pacMan, Controller<EnumMap<GHOST, MOVE>> ghosts, DueTime dueTime) {
        this.pacMan = pacMan;
        this.ghosts = ghosts;
        this.dueTime = dueTime;
        readOnlyPacMan = readOnly(pacMan);
        readOnlyGhosts = readOnly(ghosts);
        directGhosts = readOnlyGhosts instanceof DirectGhosts direct ? direct : null;
    }

    @SuppressWarnings("unchecked") // Each class of the set answers getMove and decide with the same type.
    private static <T> ReadOnlyController<T> readOnly(Controller<T> controller) {
        return READ_ONLY.contains(controller.getClass()) ? (ReadOnlyController<T>) controller : null;
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

    /** Asks both controllers and advances the game. */
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
                scratch.continueAs(game.rnd);
                directMoves = directGhosts.decideMoves(game, scratch);
            }
        } catch (Throwable failure) {
            ControllerFailure.report(failure, asked, game.getTotalTime());
            throw failure;
        }
        if (directGhosts == null) {
            game.advanceGame(move, moves);
        } else {
            game.advanceGame(move, directMoves);
        }
    }

    private <T> T answer(Controller<T> controller, ReadOnlyController<T> readOnly, Game game, long due) {
        if (readOnly != null) {
            scratch.continueAs(game.rnd);
            return readOnly.decide(game, scratch);
        }
        return controller.getMove(game.copy(), dueTime == DueTime.PER_CONTROLLER ? due(DueTime.PER_CONTROLLER) : due);
    }

    /** The wall clock is read only if somebody is told the time. */
    private long due(DueTime moment) {
        return dueTime == moment && (readOnlyPacMan == null || readOnlyGhosts == null)
                ? System.currentTimeMillis() + Constants.DELAY
                : -1;
    }
}
