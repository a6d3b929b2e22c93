import mmneat.cli.Main;
import mmneat.mspacman.sensors.Observation;
import mmneat.mspacman.sensors.Sensor;

/** A sensor, the same in all directions: 1 at the exit of the ghosts' lair, 0 from 100 steps on. */
public class NearExit implements Sensor {
    public String label() {
        return "Near Lair Exit";
    }

    public boolean isDirectional() {
        return false;
    }

    public double sense(Observation observation) {
        int exit = observation.game().getGhostInitialNodeIndex();
        int distance = observation.game().getShortestPathDistance(observation.pacManNode(), exit);
        return Math.max(0, 1 - distance / 100.0);
    }

    public static void main(String[] arguments) {
        Main.main("task=blended ownSensors=NearExit mu=10 maxGens=5 trials=3 base=results/near-exit".split(" "));
    }
}
