package pacman.game.internal;

/** A junction in the path cache. In the competition's interface the array is public, but the type is not. */
record Junction(int nodeId, int junctionId) {}
