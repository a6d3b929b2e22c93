/** The generator that all randomness comes from: {@code java.util.Random}'s sequence, resumable and without locks. */
package mmneat.random;
