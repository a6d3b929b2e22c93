package pacman.game.internal;

import pacman.game.Constants.MOVE;

/** Ms.&nbsp;Pac-Man for the simulations of competition entries. The engine keeps her state in fields. */
public final class PacMan {

    public int currentNodeIndex;
    public int numberOfLivesRemaining;
    public MOVE lastMoveMade;
    public boolean hasReceivedExtraLife;

    public PacMan(int currentNodeIndex, MOVE lastMoveMade, int numberOfLivesRemaining, boolean hasReceivedExtraLife) {
        this.currentNodeIndex = currentNodeIndex;
        this.lastMoveMade = lastMoveMade;
        this.numberOfLivesRemaining = numberOfLivesRemaining;
        this.hasReceivedExtraLife = hasReceivedExtraLife;
    }

    public PacMan copy() {
        return new PacMan(currentNodeIndex, lastMoveMade, numberOfLivesRemaining, hasReceivedExtraLife);
    }
}
