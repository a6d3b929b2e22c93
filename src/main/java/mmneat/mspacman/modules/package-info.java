/**
 * Human-specified divisions of the task among the output modules of a network. A division of your own implements {@link
 * mmneat.mspacman.modules.ModuleDivision}. MT, MT2 and MT3 are the multitask methods of the paper, with two, two and
 * three modules; {@link mmneat.neat} lists all methods.
 */
@NullMarked
package mmneat.mspacman.modules;

import org.jspecify.annotations.NullMarked;
