/**
 * The Ms. Pac-Man task: the blended, interleaved and isolated versions, and the controller that asks a network about each
 * direction.
 */
package mmneat.mspacman;
