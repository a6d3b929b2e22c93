package mmneat.mspacman.objectives;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import pacman.game.GameRules;

/**
 * The scores that can serve as objectives, by name. The parameter {@code objectives} of the command line chooses
 * objectives by these names.
 */
public final class NamedObjectives {

    /** A short name for the first published objective. */
    private static final String GHOST_SCORE = "GhostScore";

    private static final double POWER_PILLS_OF_A_LEVEL = 4;

    /** Regret counts a ghost when a power pill is eaten, and once more when its edible time ends. */
    private static final double REGRET_OF_A_POWER_PILL = 8;

    /** Source: docs/specification/mspacman-task.md, section 5. */
    private static final double LEAST_LURING = -12800;

    private final Map<String, GameObjective> known = new LinkedHashMap<>();

    /**
     * Collects the objectives for games by given rules. Rules and number of games determine the worst score of each.
     *
     * @param rules rules of the games of a trial
     * @param games number of games of a trial, whose scores are added up
     */
    public NamedObjectives(GameRules rules, int games) {
        Map<String, Integer> seen = new HashMap<>();
        for (RecordedScore recorded : RecordedScore.ofTheOriginal(rules)) {
            int number = seen.merge(recorded.label(), 1, Integer::sum);
            String name = number == 1 ? recorded.label() : recorded.label() + "#" + number;
            known.put(
                    name,
                    new GameObjective(
                            name, recorded.score(), recorded.statistic(), games * worst(recorded.score(), rules)));
        }
        GameObjective.PUBLISHED.forEach(published -> known.put(published.name(), published));
        known.put(GHOST_SCORE, GameObjective.PUBLISHED.get(0));
    }

    private static double worst(GameScore score, GameRules rules) {
        double powerPills = POWER_PILLS_OF_A_LEVEL * rules.levels().maximumLevel();
        if (score == GameScore.GHOST_REGRET) {
            return -REGRET_OF_A_POWER_PILL * powerPills;
        }
        if (score == GameScore.IMPROPERLY_EATEN_POWER_PILLS || score == GameScore.POWER_PILLS_EATEN_WHEN_GHOSTS_FAR) {
            return -powerPills;
        }
        if (score == GameScore.LURING) {
            return LEAST_LURING;
        }
        boolean isSurvival = score.name().equals(GameScore.SURVIVAL_AND_SPEED);
        return isSurvival
                ? -(double) rules.levels().maximumLevel() * rules.levels().levelTimeLimit()
                : 0;
    }

    /** All names. Of several scores with one label, the second is called {@code LABEL#2}, and so on. */
    public List<String> names() {
        return List.copyOf(known.keySet());
    }

    /** The objective with a name; empty if no recorded score has it. */
    public Optional<GameObjective> named(String name) {
        return Optional.ofNullable(known.get(name));
    }
}
