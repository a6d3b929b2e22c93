package mmneat.experiment.parameters;

import java.util.List;
import mmneat.experiment.NearestName;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;
import mmneat.mspacman.CheckedParts;
import mmneat.mspacman.TaskVersion;
import mmneat.mspacman.TrialGame;
import mmneat.mspacman.objectives.GameObjective;
import mmneat.mspacman.objectives.NamedObjectives;
import mmneat.mspacman.objectives.Objective;
import pacman.game.GameRules;

/**
 * Converter of the parameter {@code objectives} to the objectives of the Ms.&nbsp;Pac-Man task. Each word of the list
 * is the name of a score that the game itself records ({@link NamedObjectives#names} lists them), or the name of a
 * class of the user's own, of which an object is made.
 */
final class ObjectiveParameter {

    private static final String NAME = "objectives";

    private ObjectiveParameter() {}

    /** Whether a name is that of a recorded score, not of a class. */
    static boolean isRecorded(String name) {
        return new NamedObjectives(GameRules.blended(), 1).named(name).isPresent();
    }

    /**
     * The objectives that a value names.
     *
     * @param value names separated by commas; blank: the published ones
     * @throws UserError if a name is neither a recorded score nor a usable class
     */
    static List<GameObjective> read(String value, OwnClasses classes, TaskVersion version, GameRules rules) {
        List<String> names = OwnClasses.names(NAME, value);
        if (names.isEmpty()) {
            return GameObjective.PUBLISHED;
        }
        NamedObjectives recorded =
                new NamedObjectives(rules, TrialGame.of(version, rules).size());
        return names.stream()
                .map(name -> recorded.named(name).orElseGet(() -> own(name, recorded, classes)))
                .toList();
    }

    private static GameObjective own(String name, NamedObjectives recorded, OwnClasses classes) {
        if (!name.contains(".") && !classes.has(name)) {
            throw new UserError(NAME + "=" + name + ": must be one of " + String.join(", ", recorded.names())
                    + ", or a class of your own" + NearestName.suggestion(name, recorded.names()));
        }
        Objective objective = classes.make(NAME, name, Objective.class);
        String asked = NAME + "=" + name + ": name()";
        String label = OwnClasses.ask(asked, objective::name);
        double worst = OwnClasses.ask(NAME + "=" + name + ": worst()", objective::worst);
        if (label.isBlank() || !Double.isFinite(worst)) {
            throw new UserError(NAME + "=" + name + ": name() must not be empty, and worst() must be finite");
        }
        PlainText.require(asked, label);
        return GameObjective.of(CheckedParts.of(objective));
    }
}
