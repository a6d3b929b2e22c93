package mmneat.mspacman.modules;

import java.util.List;
import mmneat.mspacman.sensors.Observation;

/**
 * The division of the multitask method MT in the isolated version: module 0 if a pill or power pill is left (the pill
 * game), else 1 (the ghost games).
 */
public record AnyPills() implements ModuleDivision {

    private static final List<String> SITUATIONS = List.of("pills left", "no pills");

    @Override
    public int modules() {
        return 2;
    }

    @Override
    public int module(Observation observation) {
        return observation.pillsLeft() > 0 || observation.powerPillsLeft() > 0 ? 0 : 1;
    }

    @Override
    public String observation(int module) {
        return SITUATIONS.get(module);
    }
}
