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
     * Returns the next game. By MM-NEAT's conventions a game draws some numbers from a second generator: the places
     * where ghosts leave the lair, missing pills, and one number at the end of each edible time. In MM-NEAT that is the
     * generator of the whole evolution. Here each game gets its own, so that games do not affect each other.
     */
    public Game next() {
        return rules.conventions() == GameRules.Conventions.MM_NEAT
                ? new Game(seeds.nextLong(), rules, new ResumableRandom(seeds.nextLong()))
                : new Game(seeds.nextLong(), rules);
    }
}
