package pacman.game.internal;

/** A node in the path cache. The competition publishes the array, but not the type. */
record DNode(int nodeId, boolean isJunction) {}
