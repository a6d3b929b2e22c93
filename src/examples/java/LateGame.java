import mmneat.cli.Main;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.sensors.Observation;

/** A division of the game: the second module plays when no power pill is left. */
public class LateGame implements ModuleDivision {
    public int modules() {
        return 2;
    }

    public int module(Observation observation) {
        return observation.powerPillsLeft() > 0 ? 0 : 1;
    }

    public String observation(int module) {
        return module == 0 ? "power pills left" : "no power pill left";
    }

    public static void main(String[] arguments) {
        String words = "task=blended method=MT2 pacmanMultitaskScheme=LateGame mu=10 maxGens=3 trials=2";
        Main.main((words + " base=results/late-game").split(" "));
    }
}
