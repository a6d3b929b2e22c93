package pacman.game;

/**
 * The constants of the Ms.&nbsp;Pac-Man vs Ghosts competition (release 6.2) that controllers use.
 *
 * <p>They are compile-time constants with the competition's values. Values that rules can change (lives, edible time,
 * ...) are read from {@link GameRules}, never from here. Times are in game steps of 40 ms, distances in nodes.
 *
 * <p>Source: docs/specification/simulator.md, section 2.1; docs/specification/controllers.md, section 1.
 */
public final class Constants {

    /** Points for a pill. */
    public static final int PILL = 10;
    /** Points for a power pill. */
    public static final int POWER_PILL = 50;
    /** Points for the first ghost eaten after a power pill; doubled for each further one. */
    public static final int GHOST_EAT_SCORE = 200;
    /** Steps for which ghosts are edible in the first level. */
    public static final int EDIBLE_TIME = 200;
    /** Factor on the edible time from level to level. */
    public static final float EDIBLE_TIME_REDUCTION = 0.9f;
    /** Factor on the lair times from level to level. */
    public static final float LAIR_REDUCTION = 0.9f;
    /**
     * Number of levels after which the reductions start again: edible time and lair times of levels 0, 6, 12, ... have
     * their full values.
     */
    public static final int LEVEL_RESET_REDUCTION = 6;
    /** Steps that an eaten ghost stays in the lair in the first level. */
    public static final int COMMON_LAIR_TIME = 40;
    /** Steps after which the competition starts the next level. */
    public static final int LEVEL_LIMIT = 4000;
    /** Probability per step that all ghosts reverse. */
    public static final float GHOST_REVERSAL = 0.0015f;
    /** Steps after which a game ends, under all rules. */
    public static final int MAX_TIME = 24000;
    /** Points for each life left when the game ends by {@link #MAX_TIME}. */
    public static final int AWARD_LIFE_LEFT = 800;
    /** Score at which an extra life is given. */
    public static final int EXTRA_LIFE_SCORE = 10000;
    /** Path distance up to which Ms.&nbsp;Pac-Man and a ghost meet. */
    public static final int EAT_DISTANCE = 2;

    public static final int NUM_GHOSTS = 4;
    public static final int NUM_MAZES = 4;
    /** Milliseconds of real time per step. */
    public static final int DELAY = 40;
    /** Lives at the start of a competition game. */
    public static final int NUM_LIVES = 3;
    /** Edible ghosts move in one of this many steps. */
    public static final int GHOST_SPEED_REDUCTION = 2;
    /** Edible time below which the view makes ghosts blink. */
    public static final int EDIBLE_ALERT = 30;
    /** Milliseconds between two checks of controllers that are still computing. */
    public static final int INTERVAL_WAIT = 1;
    /** Start-up milliseconds allowed by the competition server; not enforced here. */
    public static final int WAIT_LIMIT = 5000;
    /** Megabytes allowed by the competition server; not enforced here. */
    public static final int MEMORY_LIMIT = 512;
    /** Megabytes of file input and output allowed by the competition server; not enforced here. */
    public static final int IO_LIMIT = 10;

    /** The original's folder of maze files; our mazes are drawings inside the jar. */
    public static final String pathMazes = "data/pacman/mazes";
    /** The original's folder of distance files; our distances are computed. */
    public static final String pathDistances = "data/pacman/distances";

    public static final String[] nodeNames = {"a", "b", "c", "d"};
    public static final String[] distNames = {"da", "db", "dc", "dd"};

    /** Screen pixels per maze pixel. */
    public static final int MAG = 2;
    /** Width of the view in maze pixels. */
    public static final int GV_WIDTH = 114;
    /** Height of the view in maze pixels. */
    public static final int GV_HEIGHT = 130;

    /** The original's folder of images; our view draws its own. Entries may set it; it is not used here. */
    public static String pathImages = "data/pacman/images";

    /** The original's pictures of the mazes. Entries may set them; they are not used here. */
    public static String[] mazeNames = {"maze-a.png", "maze-b.png", "maze-c.png", "maze-d.png"};

    private Constants() {}

    /** The four directions, in the order of every "for each direction", and no direction. */
    public enum MOVE {
        /** Towards smaller y. */
        UP,
        /** Towards larger x. */
        RIGHT,
        /** Towards larger y. */
        DOWN,
        /** Towards smaller x. */
        LEFT,
        /** No direction: as a request, none; as a last move, none was made. */
        NEUTRAL;

        private static final MOVE[] OPPOSITES = {DOWN, LEFT, UP, RIGHT, NEUTRAL};

        /** Returns the opposite direction; NEUTRAL for NEUTRAL. */
        public MOVE opposite() {
            return OPPOSITES[ordinal()];
        }
    }

    /** The ghosts, in the order of every "for each ghost". */
    public enum GHOST {
        /** Ghost 0; first to leave the lair. */
        BLINKY(40),
        /** Ghost 1. */
        PINKY(60),
        /** Ghost 2. */
        INKY(80),
        /** Ghost 3; last to leave the lair. */
        SUE(100);

        /** Steps in the lair at the start of the first level. */
        public final int initialLairTime;

        GHOST(int initialLairTime) {
            this.initialLairTime = initialLairTime;
        }
    }

    /** The measures of distance: along the corridors, or in pixels ignoring walls. */
    public enum DM {
        /** Steps of the shortest path, on which turning back is allowed; -1 to or from the lair. */
        PATH,
        /** Straight distance in pixels; walls and tunnels are ignored. */
        EUCLID,
        /** Horizontal plus vertical distance in pixels; walls and tunnels are ignored. */
        MANHATTAN
    }
}
