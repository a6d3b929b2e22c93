package mmneat.mspacman.modules;

import java.util.List;
import mmneat.mspacman.sensors.Observation;

/** A division: module 0 while power pills or edible ghosts remain, else 1. Not part of the published experiments. */
public record GhostsThenPills() implements ModuleDivision {

    private static final List<String> SITUATIONS = List.of("power pills or edible ghosts", "pills");

    @Override
    public int modules() {
        return 2;
    }

    @Override
    public int module(Observation observation) {
        return observation.powerPillsLeft() > 0 || observation.highestEdibleTime() > 0 ? 0 : 1;
    }

    @Override
    public String observation(int module) {
        return SITUATIONS.get(module);
    }
}
