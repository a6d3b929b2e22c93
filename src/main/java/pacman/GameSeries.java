package pacman;

import mmneat.random.ResumableRandom;
import pacman.game.Game;
import pacman.game.GameRules;

/**
 * A sequence of games by the same rules, whose seeds follow from one seed. A controller's actions in one game do not
 * affect other games. A series is used by one thread.
 */
public final class GameSeries {

    private final GameRules rules;
    private final ResumableRandom seeds;

    /** Creates a series. The same rules and seed give the same games. */
    public GameSeries(GameRules rules, long seed) {
        this.rules = rules;
        seeds = new ResumableRandom(seed);
    }

    /**
     * Returns the next game. Under MM-NEAT's conventions a game also draws from a second generator, which its copies
     * may share. So each game gets its own second generator.
     */
    public Game next() {
        return rules.conventions() == GameRules.Conventions.MM_NEAT
                ? new Game(seeds.nextLong(), rules, new ResumableRandom(seeds.nextLong()))
                : new Game(seeds.nextLong(), rules);
    }
}
