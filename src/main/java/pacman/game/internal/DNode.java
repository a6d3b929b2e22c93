package pacman.game.internal;

/** A node in the path cache. In the competition's interface the array is public, but the type is not. */
record DNode(int nodeId, boolean isJunction) {}
