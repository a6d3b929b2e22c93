/**
 * The Ms.&nbsp;Pac-Man task: the blended, interleaved and isolated versions, and the controller that activates a
 * network once per direction.
 */
package mmneat.mspacman;
