package mmneat.mspacman.modules;

import mmneat.mspacman.sensors.Observation;

/** A division: the module number is the index of the maze, 0 to 3. Not part of the published experiments. */
public record EachMaze() implements ModuleDivision {

    @Override
    public int modules() {
        return 4;
    }

    @Override
    public int module(Observation observation) {
        return observation.mazeIndex();
    }

    @Override
    public String observation(int module) {
        return "maze " + (char) ('A' + module);
    }
}
