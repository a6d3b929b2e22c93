/**
 * The random number generator: the sequence of {@code java.util.Random}, with a readable state and without locks.
 *
 * <p>Its state can be saved, so that a run that is resumed draws the same numbers as a run without interruption.
 */
@NullMarked
package mmneat.random;

import org.jspecify.annotations.NullMarked;
