/**
 * The sensors of networks: one small class per sensor, over tables that answer questions about paths without
 * searching.
 *
 * <p>A {@link mmneat.mspacman.sensors.Sensor} computes one input of the network from an {@link
 * mmneat.mspacman.sensors.Observation}, the state of a game in one time step and one direction. {@link
 * mmneat.mspacman.sensors.SensorSettings} choose the sensors of a network, {@link mmneat.mspacman.sensors.SensorSuite}
 * holds them in order, and {@link mmneat.mspacman.sensors.NetworkInputs} computes their values.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 4; docs/sensors.md.
 */
@NullMarked
package mmneat.mspacman.sensors;

import org.jspecify.annotations.NullMarked;
