package pacman.game.internal;

import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;

/** A ghost, as competition entries keep one in simulations of their own; the engine has its state in arrays. */
public final class Ghost {

    public int currentNodeIndex;
    /** Steps left to be edible; 0 if it is not. */
    public int edibleTime;
    /** Steps left in the lair; 0 outside. */
    public int lairTime;

    public GHOST type;
    public MOVE lastMoveMade;

    public Ghost(GHOST type, int currentNodeIndex, int edibleTime, int lairTime, MOVE lastMoveMade) {
        this.type = type;
        this.currentNodeIndex = currentNodeIndex;
        this.edibleTime = edibleTime;
        this.lairTime = lairTime;
        this.lastMoveMade = lastMoveMade;
    }

    public Ghost copy() {
        return new Ghost(type, currentNodeIndex, edibleTime, lairTime, lastMoveMade);
    }
}
