package pacman.game.internal;

/** A junction in the path cache. The competition publishes the array, but not the type. */
record Junction(int nodeId, int junctionId) {}
