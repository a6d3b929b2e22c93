/**
 * Games between two controllers: played without a time limit or in real time, shown, recorded and replayed.
 *
 * <p>{@link pacman.Executor} plays single games and batches. A controller is a subclass of
 * {@link pacman.controllers.Controller}; the game itself is in {@link pacman.game}.
 *
 * <p>Words used in all packages of the simulator:
 *
 * <ul>
 *   <li><em>The competition</em> is the Ms.&nbsp;Pac-Man vs Ghosts competition of 2012, and its framework, release 6.2.
 *       An <em>entry</em> is a controller that a participant wrote for it.
 *   <li><em>MM-NEAT</em>, or <em>the original</em>, is the research program of J. Schrum and R. Miikkulainen, version
 *       of February 2016, which contains a changed copy of that framework. This simulator plays by the rules of either,
 *       as {@link pacman.game.GameRules} say.
 *   <li><em>The paper</em> is J. Schrum and R. Miikkulainen, Solving Multiple Isolated, Interleaved, and Blended Tasks
 *       through Modular Neuroevolution, Evolutionary Computation 24(3), 2016. It describes experiments with MM-NEAT.
 *   <li>A <em>step</em>, <em>game step</em>, <em>time step</em> or <em>tick</em> is one call of {@link
 *       pacman.game.Game#advanceGame}; in a timed game it lasts 40 ms.
 *   <li>A <em>quirk</em> is a behaviour of the original that looks like a fault. It is kept, because results must be
 *       equal.
 *   <li>The <em>live game</em> is the game that is being played, in contrast to the copies that controllers receive.
 * </ul>
 *
 * <p>Source: docs/specification/controllers.md, section 6.
 */
@NullMarked
package pacman;

import org.jspecify.annotations.NullMarked;
