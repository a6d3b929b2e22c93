import pacman.Executor;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.StarterPacMan;
import pacman.game.Game;
import pacman.game.GameRules;

/** Plays a game. */
public class SimulatorUser {
    public static void main(String[] arguments) {
        Game game = new Game(1, GameRules.blended());
        new Executor().runExperiment(new StarterPacMan(), new Legacy(), game);
        System.out.println(game.gameOver());
    }
}
