/** The scores of a game: the objectives of evolution and the other recorded scores. */
@NullMarked
package mmneat.mspacman.objectives;

import org.jspecify.annotations.NullMarked;
