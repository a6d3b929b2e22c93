package mmneat.analysis.replay;

/**
 * A maze as the page draws it. Nodes are numbered from 0; the arrays are not copied and must not be changed.
 *
 * @param index which maze of the game, from 0
 * @param x horizontal pixel of each node
 * @param y vertical pixel of each node, growing downwards
 * @param right each node's neighbour to the right, -1 where there is a wall
 * @param down each node's neighbour below, -1 where there is a wall
 * @param pills node of each pill of the full maze
 * @param powerPills node of each power pill of the full maze
 * @param lair node of the lair, or -1 if there is none
 */
public record ReplayMaze(
        int index, int[] x, int[] y, int[] right, int[] down, int[] pills, int[] powerPills, int lair) {}
