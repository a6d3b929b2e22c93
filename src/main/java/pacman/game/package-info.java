/**
 * The simulator of Ms.&nbsp;Pac-Man vs Ghosts: the game, its rules, its state, and its view.
 *
 * <p>{@link pacman.game.Game} is one game. {@link pacman.game.GameRules} has presets for the competition of 2012 and
 * for the tasks of the paper (Schrum and Miikkulainen 2016). {@link pacman.game.GameView} shows a game. The package
 * {@link pacman} explains the words competition, MM-NEAT, original, paper, quirk and step.
 *
 * <p>A controller receives a <em>copy</em> of the game. Rules decide which random numbers a copy draws ({@link
 * pacman.game.GameRules.Copies}). If copies <em>continue the game</em>, as in MM-NEAT, a copy draws the same numbers as
 * the game will draw: a controller that advances its copy foresees the game. If copies <em>are independent</em>, as in
 * the competition's rules here, each copy shows another possible future.
 *
 * <p>Source: docs/specification/simulator.md.
 */
@NullMarked
package pacman.game;

import org.jspecify.annotations.NullMarked;
