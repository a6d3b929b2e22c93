package mmneat.mspacman.sensors;

import java.util.ArrayList;
import java.util.List;
import pacman.maze.MazeTables;

/**
 * The sensors of a network in the order of its inputs. Immutable; threads share it, each
 * with its own {@link NetworkInputs}.
 */
public final class SensorSuite {

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
        if (settings.specific()) {
            for (int ghost = 0; ghost < Observation.GHOSTS; ghost++) {
                sensors.add(new SpecificGhostDistance(ghost));
                addIf(settings.incoming(), new SpecificGhostApproaching(ghost), sensors);
            }
        }
        for (int n = 0; n < Observation.GHOSTS; n++) {
            addNthGhost(n, settings, sensors);
        }
        sensors.add(new MostPillsAhead(settings.smallStepSimDepth()));
        sensors.add(new MostJunctionsAhead(settings.smallStepSimDepth()));
        sensors.add(new ProportionPowerPills());
        sensors.add(new ProportionPills());
        addIf(settings.edibleTimes(), new ProportionEdibleGhosts(), sensors);
        addIf(settings.edibleTimes(), new ProportionEdibleTime(settings.edibleTime()), sensors);
        sensors.add(new AnyGhostsEdible());
        sensors.add(new AllThreatsPresent());
        sensors.add(new CloseToPowerPill(settings.closePowerPillDistance()));
        addIf(settings.highLevel(), new OptionsAfterJunction(), sensors);
        sensors.addAll(settings.own());
        return new SensorSuite(sensors, settings);
    }

    private static void addNthGhost(int n, SensorSettings settings, List<Sensor> sensors) {
        sensors.add(new GhostDistance(n));
        addIf(settings.incoming(), new GhostApproaching(n), sensors);
        addIf(settings.trapped(), new GhostTrapped(n), sensors);
        addIf(settings.eTimeVsGDis(), new GhostTimeVersusDistance(n, settings.edibleTime()), sensors);
        addIf(settings.edible(), new GhostEdible(n), sensors);
        if (settings.specificGhostEdibleThreatSplit()) {
            sensors.add(new KindOfGhostDistance(n, false));
            sensors.add(new KindOfGhostDistance(n, true));
            addIf(settings.incoming(), new KindOfGhostApproaching(n, false), sensors);
            addIf(settings.incoming(), new KindOfGhostApproaching(n, true), sensors);
            addIf(settings.trapped(), new KindOfGhostTrapped(n, false), sensors);
            addIf(settings.trapped(), new KindOfGhostTrapped(n, true), sensors);
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

    /** Which sensors were asked for. */
    public SensorSettings settings() {
        return settings;
    }

    /**
     * What the inputs mean.
     *
     * @param direction the direction that is sensed, 0 to 3; -1 before any, as in the headers of logs
     */
    public List<String> labels(int direction) {
        return sensors.stream()
                .map(sensor -> sensor.isDirectional() ? sensor.label() + " in dir " + direction : sensor.label())
                .toList();
    }

    /** Something that senses games with these sensors; one thread uses it. */
    public NetworkInputs newInputs() {
        return new NetworkInputs(this);
    }

    /** The tables of a maze. */
    SensorTables tables(MazeTables maze) {
        return SensorTables.of(maze, settings.smallStepSimDepth(), settings.closePowerPillDistance());
    }
}
