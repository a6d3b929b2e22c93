/** The random number generator: the sequence of {@code java.util.Random}, with a readable state and without locks. */
package mmneat.random;
