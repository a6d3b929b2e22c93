package pacman;

import mmneat.random.ResumableRandom;
import pacman.game.Game;
import pacman.game.GameRules;

/**
 * Games by the same rules, one after the other, whose seeds follow from one seed. What a controller does in one game changes
 * no other. A series belongs to one thread.
 */
public final class GameSeries {

    private final GameRules rules;
    private final ResumableRandom seeds;

    /** A series that gives the same games whenever rules and seed are the same. */
    public GameSeries(GameRules rules, long seed) {
        this.rules = rules;
        seeds = new ResumableRandom(seed);
    }

    /**
     * The next game. By MM-NEAT's conventions a game draws from a second generator too, which its copies may share; so each
     * game gets one of its own.
     */
    public Game next() {
        return rules.conventions() == GameRules.Conventions.MM_NEAT
                ? new Game(seeds.nextLong(), rules, new ResumableRandom(seeds.nextLong()))
                : new Game(seeds.nextLong(), rules);
    }
}
