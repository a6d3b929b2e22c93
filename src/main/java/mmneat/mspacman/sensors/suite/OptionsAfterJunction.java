package mmneat.mspacman.sensors.suite;

import mmneat.mspacman.sensors.GradedSensor;
import mmneat.mspacman.sensors.Observation;

/**
 * "Options From Next Junction": the number of moves at the next junction in this direction that lead safely to a
 * further junction, divided by 4. A junction is safe if Ms. Pac-Man reaches it before any ghost stops her; if the next
 * junction is not safe, the value is 0. The move back does not count. One of 0, 0.25, 0.5, 0.75.
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 4.10 and 4.11.
 */
record OptionsAfterJunction() implements GradedSensor {

    @Override
    public String label() {
        return "Options After Junction";
    }

    @Override
    public int grade(Observation observation) {
        return observation.safeOptionsAfterJunction();
    }

    @Override
    public int grades() {
        return 5;
    }

    @Override
    public double value(int grade) {
        return grade / 4.0;
    }
}
