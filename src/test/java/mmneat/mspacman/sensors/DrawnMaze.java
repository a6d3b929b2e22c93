package mmneat.mspacman.sensors;

import pacman.maze.MazeTables;

/**
 * An asymmetric maze with features that the competition's mazes lack: junctions and pills close together, loops
 * shorter than a walk, corridors of a single node, power pills on junctions.
 */
public final class DrawnMaze {

    private static final String DRAWING = """
            #......##....o.....##......#
            #o####.##.##.#####.##.####o#
            #.####.##.##.#####.##.####.#
            #..........................#
            ###.##.#####.##.#####.##.###
            ###.##.#####.##.#####.##.###
            ###.##.#####.##.#####.##.###
            ---.##.......##.......##.---
            ###.#####-########-#####.###
            ###.#####-########-#####.###
            ###.---------GG---------.###
            ###.#####-########-#####.###
            ###.#####-########-#####.###
            ###.##----##LL####----##.###
            ###.##-##-########-##-##.###
            ###.##-##-########-##-##.###
            ---.---##----------##---.---
            ###.########-##-########.###
            ###.########-##-########.###
            ###.......---##---.......###
            ###.#####.########.#####.###
            ###.#####.########.#####.###
            #............PP............#
            #..###.#####.##.#####.####.#
            #..###.#####.##.#####.####.#
            #.####.##....##....##.####.#
            #o####.##.########.##.####.#
            #.####.##.########.##.####.#
            #.......................o..#

            corridor row 23.5, columns 1 to 2
            """;

    private DrawnMaze() {}

    public static MazeTables maze() {
        return MazeTables.parse("drawn", DRAWING);
    }

    public static MazeTables withoutPowerPills() {
        return MazeTables.parse("drawn without power pills", DRAWING.replaceAll("o(?=[#.o]*#\n)", "."));
    }
}
