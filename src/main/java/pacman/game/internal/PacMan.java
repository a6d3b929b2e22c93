package pacman.game.internal;

import pacman.game.Constants.MOVE;

/** Ms. Pac-Man, as competition entries keep her in simulations of their own; the engine has her state in fields. */
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
