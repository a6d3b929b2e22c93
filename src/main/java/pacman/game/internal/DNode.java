package pacman.game.internal;

/**
 * A node in {@link PathsCache#nodes}. In the competition's interface that array is public, but the type of its elements
 * is not, so an entry can only use it as an array of objects.
 */
record DNode(int nodeId, boolean isJunction) {}
