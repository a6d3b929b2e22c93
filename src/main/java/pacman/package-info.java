/**
 * Games between two controllers: played without a time limit or in real time, shown, recorded and replayed.
 *
 * <p>{@link pacman.Executor} plays single games and batches. A controller is a subclass of
 * {@link pacman.controllers.Controller}; the game itself is in {@link pacman.game}.
 *
 * <p>Source: docs/specification/controllers.md, section 6.
 */
package pacman;
