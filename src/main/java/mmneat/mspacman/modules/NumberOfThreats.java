package mmneat.mspacman.modules;

import mmneat.mspacman.sensors.Situation;

/**
 * Module 0 if a ghost is edible, else 1 if fewer than four are threats, 2 if all four are. Not part of the published
 * experiments.
 */
public record NumberOfThreats() implements ModuleDivision {

    @Override
    public int modules() {
        return 3;
    }

    @Override
    public int module(Situation situation) {
        if (situation.highestEdibleTime() > 0) {
            return 0;
        }
        return situation.threats() < Situation.GHOSTS ? 1 : 2;
    }
}
