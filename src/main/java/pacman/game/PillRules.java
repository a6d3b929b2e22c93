package pacman.game;

/**
 * The rules for the pills of a game and for penalties of power pills. Immutable.
 *
 * <p>Source: docs/specification/simulator.md, sections 2 and 7.
 *
 * @param preEatenPillPortion share of pills that are missing from the start of a level, in [0, 1]
 * @param closeGhostDistance path distance of the nearest threat beyond which a power pill counts as eaten with all
 *     ghosts far away; it only affects the counter {@link Game#getPowerPillsEatenWhenGhostFar}
 * @param powerPillPunishmentRate probability in [0, 1] that the game ends when a ghost's edible time ends
 */
public record PillRules(double preEatenPillPortion, int closeGhostDistance, double powerPillPunishmentRate) {

    /** MM-NEAT's defaults: all pills, and no punishment. */
    static final PillRules MM_NEAT = new PillRules(0, 35, 0);

    /** @throws IllegalArgumentException if a value is out of its range */
    public PillRules {
        GameRules.requireProbability("preEatenPillPortion", preEatenPillPortion);
        GameRules.requireProbability("powerPillPunishmentRate", powerPillPunishmentRate);
    }

    public PillRules withPreEatenPillPortion(double value) {
        return new PillRules(value, closeGhostDistance, powerPillPunishmentRate);
    }

    public PillRules withCloseGhostDistance(int value) {
        return new PillRules(preEatenPillPortion, value, powerPillPunishmentRate);
    }

    public PillRules withPowerPillPunishmentRate(double value) {
        return new PillRules(preEatenPillPortion, closeGhostDistance, value);
    }
}
