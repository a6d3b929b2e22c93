package mmneat.contest;

import java.util.function.Supplier;
import pacman.controllers.Controller;

/**
 * One side of a contest, with a factory of its controllers.
 *
 * @param <T> {@code MOVE} for Ms. Pac-Man, {@code EnumMap<GHOST, MOVE>} for the ghosts
 * @param name name in reports
 * @param origin the jar or folder that the controller's class comes from; empty if it belongs to this program
 * @param controllers creates a controller for each game
 */
public record Contestant<T>(String name, String origin, Supplier<? extends Controller<T>> controllers) {}
