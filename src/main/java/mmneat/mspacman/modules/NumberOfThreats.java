package mmneat.mspacman.modules;

import java.util.List;
import mmneat.mspacman.sensors.Observation;

/**
 * A division: module 0 if a ghost is edible, else 1 if fewer than four are threats, 2 if all four are. Not part of the
 * published experiments.
 */
public record NumberOfThreats() implements ModuleDivision {

    private static final List<String> SITUATIONS = List.of("a ghost edible", "fewer than 4 threats", "4 threats");

    @Override
    public int modules() {
        return 3;
    }

    @Override
    public int module(Observation observation) {
        if (observation.highestEdibleTime() > 0) {
            return 0;
        }
        return observation.threats() < Observation.GHOSTS ? 1 : 2;
    }

    @Override
    public String observation(int module) {
        return SITUATIONS.get(module);
    }
}
