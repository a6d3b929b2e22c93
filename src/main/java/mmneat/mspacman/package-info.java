/**
 * The Ms.&nbsp;Pac-Man task: the blended, interleaved and isolated versions, and the controller that activates a
 * network once per direction.
 *
 * <p>The game has two parts for Ms.&nbsp;Pac-Man: to eat pills while ghosts threaten her, and to eat ghosts while they
 * are edible. The versions differ in how the parts meet. <em>Blended</em>: both happen at the same time, because ghosts
 * that were eaten return as threats while others are still edible. <em>Interleaved</em>: they alternate, because no
 * ghost leaves the lair while another is edible. <em>Isolated</em>: they are separate games, one with pills but without
 * power pills, and four with edible ghosts only. A <em>full game</em> has pills, power pills and ghosts in all four
 * mazes, as in the blended and interleaved versions.
 *
 * <p>An evaluation has several <em>trials</em> ({@link mmneat.mspacman.GameSettings#trials}). A trial is one
 * full game or, in the isolated version, the five separate games, whose scores are added up.
 *
 * <p>A <em>division</em> ({@link mmneat.mspacman.modules.ModuleDivision}) tells a multitask network which module to use
 * in a time step. {@link mmneat.neat} explains the words original, paper, quirk, module, preference neuron, and the
 * methods (1M, MM(D), MT, hybrid and others); {@link pacman} those of the simulator.
 *
 * <p>Source: Schrum and Miikkulainen 2016, sections 3 to 5; docs/specification/mspacman-task.md.
 */
@NullMarked
package mmneat.mspacman;

import org.jspecify.annotations.NullMarked;
