package mmneat.mspacman.modules;

import java.util.List;
import mmneat.mspacman.sensors.Observation;

/** A division: module 0 if no ghost is a threat, else 1. Not part of the published experiments. */
public record AnyGhostThreat() implements ModuleDivision {

    private static final List<String> SITUATIONS = List.of("no threats", "a threat");

    @Override
    public int modules() {
        return 2;
    }

    @Override
    public int module(Observation observation) {
        return observation.threats() == 0 ? 0 : 1;
    }

    @Override
    public String observation(int module) {
        return SITUATIONS.get(module);
    }
}
