package mmneat.mspacman.modules;

import java.util.List;
import mmneat.mspacman.sensors.Situation;

/** Module 0 if a pill or power pill is left, else 1: the pill task and the ghost task. The division of MT (isolated). */
public record AnyPills() implements ModuleDivision {

    private static final List<String> SITUATIONS = List.of("pills left", "no pills");

    @Override
    public int modules() {
        return 2;
    }

    @Override
    public int module(Situation situation) {
        return situation.pillsLeft() > 0 || situation.powerPillsLeft() > 0 ? 0 : 1;
    }

    @Override
    public String situation(int module) {
        return SITUATIONS.get(module);
    }
}
