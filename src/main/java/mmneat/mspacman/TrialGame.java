package mmneat.mspacman;

import java.util.ArrayList;
import java.util.List;
import pacman.game.GameRules;
import pacman.game.GameSwitches;

/**
 * One of the games that make a trial.
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 2.5 and 7.3; docs/specification/simulator.md, section 7.
 *
 * @param name short name for reports and recordings; empty if a trial is a single game
 * @param rules of the game
 * @param countsGhosts whether the game counts for the first objective
 */
public record TrialGame(String name, GameRules rules, boolean countsGhosts) {

    /** Power pills at which the ghost-eating games start, one game each. */
    private static final int CORNERS = 4;

    /** The games of a trial, in the order in which they are played. */
    public static List<TrialGame> of(TaskVersion version, GameRules rules) {
        if (version != TaskVersion.ISOLATED) {
            return List.of(new TrialGame("", rules, true));
        }
        GameRules imprisoned = rules.with().imprisonedWhileEdible(true).build();
        List<TrialGame> games = new ArrayList<>();
        games.add(new TrialGame(
                "PillTask",
                imprisoned.with().switches(withoutPowerPills(rules.switches())).build(),
                false));
        for (int corner = 0; corner < CORNERS; corner++) {
            games.add(new TrialGame(
                    "GhostTask" + corner,
                    imprisoned
                            .with()
                            .switches(GameSwitches.GHOST_TASK)
                            .startingPowerPill(corner)
                            .build(),
                    true));
        }
        return List.copyOf(games);
    }

    private static GameSwitches withoutPowerPills(GameSwitches on) {
        return new GameSwitches(
                on.exitLairEdible(),
                on.endOnlyOnTimeLimit(),
                on.randomLairExit(),
                on.lairExitDatabase(),
                on.simultaneousLairExit(),
                on.ghostsStartOutsideLair(),
                on.onlyOneLairExitAllowed(),
                on.endAfterGhostEatingChances(),
                on.removePillsNearPowerPills(),
                on.withoutPills(),
                true,
                on.endAfterPowerPillsEaten());
    }
}
