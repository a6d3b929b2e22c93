package consumer;

import java.util.List;
import mmneat.evolution.Evaluation;
import mmneat.evolution.Evolution;
import mmneat.evolution.Individual;
import mmneat.evolution.Task;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkState;
import mmneat.nsga2.Hypervolume;
import mmneat.random.ResumableRandom;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.StarterPacMan;
import pacman.game.Game;

/** Uses the simulator, networks, selection and evolution together. */
public final class Consumer {

    private Consumer() {}

    /** Plays a game of at most so many steps and returns the score. */
    public static int score(long seed, int steps) {
        Game game = new Game(seed);
        StarterPacMan pacMan = new StarterPacMan();
        Legacy ghosts = new Legacy();
        for (int step = 0; step < steps && !game.gameOver(); step++) {
            game.advanceGame(pacMan.getMove(game.copy(), -1), ghosts.getMove(game.copy(), -1));
        }
        return game.getScore();
    }

    /** Evolves networks whose output is as near to a value as possible, and returns the champion's output. */
    public static double evolved(double wanted) {
        Task task = Task.of(List.of("Nearness"), List.of("Bias"), 1, (genotype, random) -> {
            NetworkState network = Network.compile(genotype).newState();
            network.activate(new double[] {1}, random);
            return Evaluation.of(new int[genotype.modules()], -Math.abs(wanted - network.policyOutput(0)));
        });
        Individual champion =
                Evolution.of(task).populationSize(20).generations(40).run().champion(task);
        return wanted + champion.evaluation().objectives()[0];
    }

    /** The hypervolume of random points. */
    public static double hypervolume() {
        ResumableRandom random = new ResumableRandom(1);
        return Hypervolume.of(new double[][] {{random.nextDouble(), random.nextDouble()}}, new double[2]);
    }
}
