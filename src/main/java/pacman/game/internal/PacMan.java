package pacman.game.internal;

import pacman.game.Constants.MOVE;

/**
 * The state of Ms.&nbsp;Pac-Man as an object of the competition's interface. Entries that simulate the game in code of
 * their own create and change such objects. No game contains one, and changes of a PacMan object have no effect on a
 * game.
 */
public final class PacMan {

    /** Her node. */
    public int currentNodeIndex;
    /** Lives, including the current one. */
    public int numberOfLivesRemaining;
    /** Her last move; NEUTRAL if she stood. */
    public MOVE lastMoveMade;
    /** Whether the extra life of the game was given. */
    public boolean hasReceivedExtraLife;

    public PacMan(int currentNodeIndex, MOVE lastMoveMade, int numberOfLivesRemaining, boolean hasReceivedExtraLife) {
        this.currentNodeIndex = currentNodeIndex;
        this.lastMoveMade = lastMoveMade;
        this.numberOfLivesRemaining = numberOfLivesRemaining;
        this.hasReceivedExtraLife = hasReceivedExtraLife;
    }

    /** Returns an independent object with the same values. */
    public PacMan copy() {
        return new PacMan(currentNodeIndex, lastMoveMade, numberOfLivesRemaining, hasReceivedExtraLife);
    }
}
