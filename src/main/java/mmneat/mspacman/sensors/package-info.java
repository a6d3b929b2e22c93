/**
 * The interface of sensors, the observation that they read, and the settings that choose them.
 *
 * <p>A {@link mmneat.mspacman.sensors.Sensor} computes one input of the network from an {@link
 * mmneat.mspacman.sensors.Observation}: the state of a game in one time step and one direction. An observation answers
 * questions about paths from tables, without searching. {@link mmneat.mspacman.sensors.SensorSettings} choose the
 * sensors of a network; those of the program are in {@link mmneat.mspacman.sensors.suite}.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 4; docs/sensors.md.
 */
@NullMarked
package mmneat.mspacman.sensors;

import org.jspecify.annotations.NullMarked;
