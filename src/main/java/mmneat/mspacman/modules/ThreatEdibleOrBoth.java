package mmneat.mspacman.modules;

import java.util.List;
import mmneat.mspacman.sensors.Observation;

/**
 * The division of MT3, the multitask method with three modules (blended version): module 1 if all ghosts are threats or
 * in the lair (also if all are in the lair), 0 if all are edible or in the lair, 2 if there are both.
 */
public record ThreatEdibleOrBoth() implements ModuleDivision {

    private static final List<String> SITUATIONS = List.of("all edible", "all threats", "threats and edible");

    @Override
    public int modules() {
        return 3;
    }

    @Override
    public int module(Observation observation) {
        int threats = observation.threats();
        int edible = observation.edibleGhosts();
        if (edible == 0) {
            return 1;
        }
        return threats == 0 ? 0 : 2;
    }

    @Override
    public String observation(int module) {
        return SITUATIONS.get(module);
    }
}
