package mmneat.mspacman.sensors.suite;

import java.util.ArrayList;
import java.util.List;
import mmneat.mspacman.sensors.Observation;
import mmneat.mspacman.sensors.Sensor;
import mmneat.mspacman.sensors.SensorGroup;
import mmneat.mspacman.sensors.SensorSettings;

/**
 * The sensors of a network in the order of its inputs. Immutable; threads share it, each
 * with its own {@link NetworkInputs}.
 */
public final class SensorSuite {

    private static final List<GhostOrder> KINDS = List.of(GhostOrder.NEAREST_THREAT, GhostOrder.NEAREST_EDIBLE);

    private final List<Sensor> sensors;
    private final SensorSettings settings;

    private SensorSuite(List<Sensor> sensors, SensorSettings settings) {
        this.sensors = List.copyOf(sensors);
        this.settings = settings;
    }

    /** The sensors that the settings ask for. */
    public static SensorSuite of(SensorSettings settings) {
        List<Sensor> sensors = new ArrayList<>();
        sensors.add(new Bias());
        sensors.add(new NearestPillDistance());
        sensors.add(new NearestPowerPillDistance());
        for (int rank = 0; rank < settings.junctionsToSense(); rank++) {
            sensors.add(new JunctionDistance(rank));
        }
        for (int ghost = 0; ghost < Observation.GHOSTS && settings.has(SensorGroup.NUMBERED_GHOSTS); ghost++) {
            sensors.add(new GhostDistance(GhostOrder.BY_NUMBER, ghost));
            addIf(settings.has(SensorGroup.APPROACHING), new GhostApproaching(GhostOrder.BY_NUMBER, ghost), sensors);
        }
        for (int n = 0; n < Observation.GHOSTS && settings.has(SensorGroup.NEAREST_GHOSTS); n++) {
            addNthGhost(n, settings, sensors);
        }
        for (int n = 0; n < Observation.GHOSTS && settings.has(SensorGroup.NEAREST_OF_EACH_KIND); n++) {
            addNthGhostOfEachKind(n, settings, sensors);
        }
        sensors.add(new MostPillsAhead(settings.smallStepSimDepth()));
        sensors.add(new MostJunctionsAhead(settings.smallStepSimDepth()));
        sensors.add(new ProportionPowerPills());
        sensors.add(new ProportionPills());
        boolean proportions = settings.has(SensorGroup.EDIBLE_PROPORTIONS);
        addIf(proportions, new ProportionEdibleGhosts(), sensors);
        addIf(proportions, new ProportionEdibleTime(settings.edibleTime()), sensors);
        sensors.add(new AnyGhostsEdible());
        sensors.add(new AllThreatsPresent());
        sensors.add(new CloseToPowerPill(settings.closePowerPillDistance()));
        addIf(settings.has(SensorGroup.OPTIONS_AFTER_JUNCTION), new OptionsAfterJunction(), sensors);
        sensors.addAll(settings.own());
        return new SensorSuite(sensors, settings);
    }

    private static void addNthGhost(int n, SensorSettings settings, List<Sensor> sensors) {
        sensors.add(new GhostDistance(GhostOrder.NEAREST, n));
        addIf(settings.has(SensorGroup.APPROACHING), new GhostApproaching(GhostOrder.NEAREST, n), sensors);
        addIf(settings.has(SensorGroup.TRAPPED), new GhostTrapped(GhostOrder.NEAREST, n), sensors);
        addIf(
                settings.has(SensorGroup.TIME_VERSUS_DISTANCE),
                new GhostTimeVersusDistance(n, settings.edibleTime()),
                sensors);
        addIf(settings.has(SensorGroup.EDIBLE), new GhostEdible(n), sensors);
    }

    private static void addNthGhostOfEachKind(int n, SensorSettings settings, List<Sensor> sensors) {
        for (GhostOrder kind : KINDS) {
            sensors.add(new GhostDistance(kind, n));
        }
        for (GhostOrder kind : KINDS) {
            addIf(settings.has(SensorGroup.APPROACHING), new GhostApproaching(kind, n), sensors);
        }
        for (GhostOrder kind : KINDS) {
            addIf(settings.has(SensorGroup.TRAPPED), new GhostTrapped(kind, n), sensors);
        }
    }

    private static void addIf(boolean wanted, Sensor sensor, List<Sensor> sensors) {
        if (wanted) {
            sensors.add(sensor);
        }
    }

    /** The sensors, in the order of the network's inputs. */
    public List<Sensor> sensors() {
        return sensors;
    }

    /** Number of sensors. */
    public int size() {
        return sensors.size();
    }

    /** The settings from which these sensors were made. */
    public SensorSettings settings() {
        return settings;
    }

    /**
     * Labels of the inputs. The label of a sensor that depends on the direction ends with the direction's number.
     *
     * @param direction the direction that is sensed, 0 to 3; -1 in the headers of logs, which are written before a
     *     direction is sensed
     */
    public List<String> labels(int direction) {
        return sensors.stream()
                .map(sensor -> sensor.isDirectional() ? sensor.label() + " in dir " + direction : sensor.label())
                .toList();
    }

    /** Creates an object that computes the values of these sensors in a game; one thread uses it. */
    public NetworkInputs newInputs() {
        return new NetworkInputs(this);
    }
}
