package mmneat.mspacman.modules;

import mmneat.mspacman.sensors.Situation;

/** Module 1 if any ghost is edible, else 0. The division of MT (interleaved) and MT2 (blended). */
public record AnyGhostEdible() implements ModuleDivision {

    @Override
    public int modules() {
        return 2;
    }

    @Override
    public int module(Situation situation) {
        return situation.highestEdibleTime() > 0 ? 1 : 0;
    }
}
