package mmneat.mspacman.modules;

import java.util.List;
import mmneat.mspacman.sensors.Observation;

/**
 * The division of the multitask methods with two modules, MT (interleaved version) and MT2 (blended version): module 1
 * if any ghost is edible, else 0.
 */
public record AnyGhostEdible() implements ModuleDivision {

    private static final List<String> SITUATIONS = List.of("no ghost edible", "a ghost edible");

    @Override
    public int modules() {
        return 2;
    }

    @Override
    public int module(Observation observation) {
        return observation.highestEdibleTime() > 0 ? 1 : 0;
    }

    @Override
    public String observation(int module) {
        return SITUATIONS.get(module);
    }
}
