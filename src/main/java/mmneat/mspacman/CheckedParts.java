package mmneat.mspacman;

import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.objectives.Objective;
import mmneat.mspacman.sensors.GradedSensor;
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

    /** The sensor; its value must be finite. A graded sensor stays one, and its grade must be one of its grades. */
    public static Sensor of(Sensor sensor) {
        OwnPart part = OwnPart.of("sensor", sensor);
        return sensor instanceof GradedSensor graded
                ? new CheckedGradedSensor(graded, part)
                : new CheckedSensor(sensor, part);
    }

    /** The division; the module must be one of its modules. */
    public static ModuleDivision of(ModuleDivision division) {
        OwnPart part = OwnPart.of("division", division);
        return new CheckedDivision(division, part.call(division::modules), part);
    }

    /** The objective; its score must be finite. */
    public static Objective of(Objective objective) {
        return new CheckedObjective(objective, OwnPart.of("objective", objective));
    }

    /** The checks that graded and other sensors share. */
    private interface Checked extends Sensor {
        Sensor sensor();

        OwnPart part();

        @Override
        default String label() {
            return part().call(sensor()::label);
        }

        @Override
        default boolean isDirectional() {
            return part().call(sensor()::isDirectional);
        }
    }

    private record CheckedSensor(Sensor sensor, OwnPart part) implements Checked {

        @Override
        public double sense(Observation observation) {
            return part.number(() -> sensor.sense(observation));
        }
    }

    private record CheckedGradedSensor(GradedSensor sensor, OwnPart part) implements Checked, GradedSensor {

        @Override
        public int grades() {
            int grades = part.call(sensor::grades);
            if (grades < 1) {
                throw part.bad("has " + grades + " grades; it must have at least 1");
            }
            return grades;
        }

        @Override
        public double value(int grade) {
            return part.number(() -> sensor.value(grade));
        }

        @Override
        public int grade(Observation observation) {
            int grade = part.call(() -> sensor.grade(observation));
            int grades = grades();
            if (grade < 0 || grade >= grades) {
                throw part.bad("gave grade " + grade + "; it must be 0 to " + (grades - 1));
            }
            return grade;
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
            return part.call(() -> division.observation(module));
        }
    }

    private record CheckedObjective(Objective objective, OwnPart part) implements Objective {

        @Override
        public String name() {
            return part.call(objective::name);
        }

        @Override
        public double score(Game game) {
            return part.number(() -> objective.score(game));
        }

        @Override
        public double worst() {
            return part.number(objective::worst);
        }
    }
}
