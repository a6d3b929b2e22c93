package mmneat.mspacman;

import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.objectives.Objective;
import mmneat.mspacman.sensors.Observation;
import mmneat.mspacman.sensors.Sensor;
import mmneat.neat.OwnPart;
import pacman.game.Game;

/**
 * Sensors, divisions and objectives of the user's own, checked at each call: what they throw, and values that are not
 * allowed, become a {@link mmneat.neat.BadPartException} that names the class.
 */
public final class CheckedParts {

    private CheckedParts() {}

    /** The sensor; its value must be finite. */
    public static Sensor of(Sensor sensor) {
        return new CheckedSensor(sensor, OwnPart.of("sensor", sensor));
    }

    /** The division; the module must be one of its modules. */
    public static ModuleDivision of(ModuleDivision division) {
        return new CheckedDivision(division, division.modules(), OwnPart.of("division", division));
    }

    /** The objective; its score must be finite. */
    public static Objective of(Objective objective) {
        return new CheckedObjective(objective, OwnPart.of("objective", objective));
    }

    private record CheckedSensor(Sensor sensor, OwnPart part) implements Sensor {

        @Override
        public String label() {
            return sensor.label();
        }

        @Override
        public boolean isDirectional() {
            return sensor.isDirectional();
        }

        @Override
        public double sense(Observation observation) {
            return part.number(() -> sensor.sense(observation));
        }
    }

    private record CheckedDivision(ModuleDivision division, int modules, OwnPart part) implements ModuleDivision {

        @Override
        public int module(Observation observation) {
            int module = part.call(() -> division.module(observation));
            if (module < 0 || module >= modules) {
                throw part.bad("gave module " + module + "; it must be 0 to " + (modules - 1));
            }
            return module;
        }

        @Override
        public String observation(int module) {
            return division.observation(module);
        }
    }

    private record CheckedObjective(Objective objective, OwnPart part) implements Objective {

        @Override
        public String name() {
            return objective.name();
        }

        @Override
        public double score(Game game) {
            return part.number(() -> objective.score(game));
        }

        @Override
        public double worst() {
            return objective.worst();
        }
    }
}
