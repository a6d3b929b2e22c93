package pacman.game;

/**
 * Rules that are switched on one game object at a time, as the tasks of MM-NEAT do.
 *
 * <p>Source: docs/specification/simulator.md, section 7.
 *
 * @param exitLairEdible ghosts leave the lair edible
 * @param endOnlyOnTimeLimit eating everything does not end a level
 * @param randomLairExit ghosts leave the lair at a random junction
 * @param lairExitDatabase ghosts leave the lair where a recording says ({@link GameRules#ghostLocations})
 * @param simultaneousLairExit when one ghost leaves the lair all do
 * @param ghostsStartOutsideLair ghosts leave the lair in the first step of a level
 * @param onlyOneLairExitAllowed a ghost that would leave the lair later in a level starts the next level instead
 * @param endAfterGhostEatingChances a level ends when no power pill is left and no ghost is edible
 * @param removePillsNearPowerPills the corridors of power pills hold no pills
 * @param withoutPills there are no pills
 * @param withoutPowerPills there are no power pills
 * @param endAfterPowerPillsEaten a level ends when no power pill is left
 */
public record GameSwitches(
        boolean exitLairEdible,
        boolean endOnlyOnTimeLimit,
        boolean randomLairExit,
        boolean lairExitDatabase,
        boolean simultaneousLairExit,
        boolean ghostsStartOutsideLair,
        boolean onlyOneLairExitAllowed,
        boolean endAfterGhostEatingChances,
        boolean removePillsNearPowerPills,
        boolean withoutPills,
        boolean withoutPowerPills,
        boolean endAfterPowerPillsEaten) {

    /** Everything off. */
    public static final GameSwitches NONE =
            new GameSwitches(false, false, false, false, false, false, false, false, false, false, false, false);

    /** The pill-eating game of the isolated task. */
    public static final GameSwitches PILL_TASK =
            new GameSwitches(false, false, false, false, false, false, false, false, true, false, true, false);

    /** The ghost-eating game of the isolated task. */
    public static final GameSwitches GHOST_TASK =
            new GameSwitches(true, false, false, true, true, true, true, true, false, true, true, false);
}
