package mmneat.mspacman;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import pacman.game.GameRules;
import pacman.game.GameSwitch;

/**
 * One game of a trial.
 *
 * <p>Source: docs/specification/mspacman-task.md, sections 2.5 and 7.3; docs/specification/simulator.md, section 7.
 *
 * @param name short name for reports and recordings; empty if a trial is a single game
 * @param rules of the game
 * @param countsGhosts whether the game counts for the ghost reward, the first of the two published objectives ({@link
 *     mmneat.mspacman.objectives.GameScore#GHOST_REWARD}): false in the pill game of the isolated version. All other
 *     scores count in every game
 */
public record TrialGame(String name, GameRules rules, boolean countsGhosts) {

    /** Power pills at which the ghost-eating games start, one game each. */
    private static final int CORNERS = 4;

    /** Switches of a full game that the ghost-eating games do not have. */
    private static final Set<GameSwitch> OFF_IN_GHOST_GAMES = Set.of(
            GameSwitch.END_ONLY_ON_TIME_LIMIT,
            GameSwitch.END_AFTER_POWER_PILLS_EATEN,
            GameSwitch.RANDOM_LAIR_EXIT,
            GameSwitch.REMOVE_PILLS_NEAR_POWER_PILLS);

    /** The games of a trial, in the order in which they are played. */
    public static List<TrialGame> of(TaskVersion version, GameRules rules) {
        if (version != TaskVersion.ISOLATED) {
            return List.of(new TrialGame("", rules, true));
        }
        GameRules imprisoned = rules.with(Set.of(GameSwitch.IMPRISONED_WHILE_EDIBLE));
        List<TrialGame> games = new ArrayList<>();
        games.add(new TrialGame("PillTask", imprisoned.with(Set.of(GameSwitch.WITHOUT_POWER_PILLS)), false));
        for (int i = 0; i < CORNERS; i++) {
            int corner = i;
            games.add(new TrialGame(
                    "GhostTask" + corner,
                    imprisoned
                            .without(OFF_IN_GHOST_GAMES)
                            .with(GameSwitch.GHOST_TASK)
                            .withMazes(mazes -> mazes.withStartingPowerPill(corner)),
                    true));
        }
        return List.copyOf(games);
    }
}
