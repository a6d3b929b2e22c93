package mmneat.mspacman;

/** Why a game was over. */
public enum GameEnd {
    /** The last level was finished. */
    ALL_LEVELS_BEATEN,
    /** Ms. Pac-Man was caught in her last life. */
    LOST_ALL_LIVES,
    /** She asked for the end because the level took too long. */
    LEVEL_TIME_LIMIT,
    /** The time for the whole game was over. */
    GAME_TIME_LIMIT,
    /** A power pill was eaten at the wrong time, or its edible time ran out, where rules punish that. */
    PUNISHED
}
