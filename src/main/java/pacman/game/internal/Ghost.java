package pacman.game.internal;

import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;

/** A ghost for the simulations of competition entries. The engine keeps the state of ghosts in arrays. */
public final class Ghost {

    public int currentNodeIndex;
    /** Steps for which the ghost stays edible; 0 if it is not edible. */
    public int edibleTime;
    /** Steps for which the ghost stays in the lair; 0 outside. */
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
