package pacman.game.internal;

/**
 * A junction in {@link PathsCache#junctions}. In the competition's interface that array is public, but the type of its
 * elements is not, so an entry can only use it as an array of objects.
 */
record Junction(int nodeId, int junctionId) {}
