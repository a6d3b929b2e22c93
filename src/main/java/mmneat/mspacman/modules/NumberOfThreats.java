package mmneat.mspacman.modules;

import java.util.List;
import mmneat.mspacman.sensors.Situation;

/**
 * Module 0 if a ghost is edible, else 1 if fewer than four are threats, 2 if all four are. Not part of the published
 * experiments.
 */
public record NumberOfThreats() implements ModuleDivision {

    private static final List<String> SITUATIONS = List.of("a ghost edible", "fewer than 4 threats", "4 threats");

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

    @Override
    public String situation(int module) {
        return SITUATIONS.get(module);
    }
}
