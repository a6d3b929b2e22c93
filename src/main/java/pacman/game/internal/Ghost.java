package pacman.game.internal;

import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;

/**
 * The state of one ghost as an object of the competition's interface. Entries that simulate the game in code of their
 * own create and change such objects. No game contains one: {@link pacman.game.Game} keeps the state of its ghosts in
 * arrays, and changes of a Ghost object have no effect on a game.
 */
public final class Ghost {

    /** The ghost's node. */
    public int currentNodeIndex;
    /** Steps for which the ghost stays edible; 0 if it is not edible. */
    public int edibleTime;
    /** Steps for which the ghost stays in the lair; 0 outside. */
    public int lairTime;

    /** Which of the four ghosts this is. */
    public GHOST type;
    /** The ghost's last move; NEUTRAL if there was none. */
    public MOVE lastMoveMade;

    public Ghost(GHOST type, int currentNodeIndex, int edibleTime, int lairTime, MOVE lastMoveMade) {
        this.type = type;
        this.currentNodeIndex = currentNodeIndex;
        this.edibleTime = edibleTime;
        this.lairTime = lairTime;
        this.lastMoveMade = lastMoveMade;
    }

    /** Returns an independent object with the same values. */
    public Ghost copy() {
        return new Ghost(type, currentNodeIndex, edibleTime, lairTime, lastMoveMade);
    }
}
