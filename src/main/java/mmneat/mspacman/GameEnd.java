package mmneat.mspacman;

/** The reason for the end of a game. */
public enum GameEnd {
    /** The last level was finished. */
    ALL_LEVELS_BEATEN,
    /** Ms.&nbsp;Pac-Man was caught in her last life. */
    LOST_ALL_LIVES,
    /** The player requested the end because the level took too long. */
    LEVEL_TIME_LIMIT,
    /** The time limit of the whole game was reached. */
    GAME_TIME_LIMIT,
    /** A power pill was eaten at the wrong time, or its edible time ended, under rules that punish this. */
    PUNISHED
}
