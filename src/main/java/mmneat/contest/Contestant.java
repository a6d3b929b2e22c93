package mmneat.contest;

import java.util.function.Supplier;
import pacman.controllers.Controller;

/**
 * One side of a contest.
 *
 * @param <T> {@code MOVE} for Ms. Pac-Man, {@code EnumMap<GHOST, MOVE>} for the ghosts
 * @param name for reports
 * @param origin the jar or folder that the controller's class comes from; empty if it comes with this program
 * @param controllers makes a controller for each game
 */
public record Contestant<T>(String name, String origin, Supplier<? extends Controller<T>> controllers) {}
