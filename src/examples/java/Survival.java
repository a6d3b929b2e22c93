import mmneat.cli.Main;
import mmneat.mspacman.objectives.Objective;
import pacman.game.Game;

/** An objective: how many time steps she lives. */
public class Survival implements Objective {
    public double score(Game game) {
        return game.getTotalTime();
    }

    public static void main(String[] arguments) {
        String words = "task=blended objectives=GhostRewardScore,PillScore,Survival mu=10 maxGens=3 trials=2";
        Main.main((words + " base=results/survival").split(" "));
    }
}
