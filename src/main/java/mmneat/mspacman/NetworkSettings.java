package mmneat.mspacman;

import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.neat.network.ModuleArbitration;
import org.jspecify.annotations.Nullable;

/**
 * The inputs of networks and the choice among their modules. Immutable.
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 3 and 4.
 *
 * @param sensors the sensors, which are the networks' inputs
 * @param division selects the module of each step for multitask networks; null for others
 * @param arbitration how networks choose among their modules
 */
public record NetworkSettings(
        SensorSettings sensors, @Nullable ModuleDivision division, ModuleArbitration arbitration) {

    /** Returns these settings with other sensors. */
    public NetworkSettings withSensors(SensorSettings value) {
        return new NetworkSettings(value, division, arbitration);
    }

    /** Returns these settings for multitask networks. */
    public NetworkSettings withDivision(ModuleDivision value) {
        return new NetworkSettings(sensors, value, arbitration);
    }
}
