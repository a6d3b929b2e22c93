package mmneat.mspacman.modules;

import mmneat.mspacman.sensors.Situation;

/** The module with the maze's index, of four mazes. Not part of the published experiments. */
public record EachMaze() implements ModuleDivision {

    @Override
    public int modules() {
        return 4;
    }

    @Override
    public int module(Situation situation) {
        return situation.mazeIndex();
    }

    @Override
    public String situation(int module) {
        return "maze " + (char) ('A' + module);
    }
}
