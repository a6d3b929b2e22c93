/**
 * The simulator of Ms.&nbsp;Pac-Man vs Ghosts: the game, its rules, its state, and its view.
 *
 * <p>{@link pacman.game.Game} is one game. {@link pacman.game.GameRules} has presets for the competition and for the
 * tasks of the paper. {@link pacman.game.GameView} shows a game.
 *
 * <p>Source: docs/specification/simulator.md.
 */
package pacman.game;
