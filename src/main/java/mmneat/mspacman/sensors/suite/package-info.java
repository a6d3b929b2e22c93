/**
 * The program's sensors, one small class each, and the computation of all of them together.
 *
 * <p>{@link mmneat.mspacman.sensors.suite.SensorSuite} puts the sensors that {@link
 * mmneat.mspacman.sensors.SensorSettings} choose into the order of the network's inputs, and {@link
 * mmneat.mspacman.sensors.suite.NetworkInputs} computes their values in a game.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 4; docs/sensors.md.
 */
@NullMarked
package mmneat.mspacman.sensors.suite;

import org.jspecify.annotations.NullMarked;
