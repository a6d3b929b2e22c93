package mmneat.mspacman.modules;

import mmneat.mspacman.sensors.Observation;

/** The module with the maze's index, of four mazes. Not part of the published experiments. */
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
