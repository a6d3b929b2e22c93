/** The scores of a game: the objectives of evolution and the other recorded scores. */
package mmneat.mspacman.objectives;
