package mmneat.analysis.evaluation;

import java.util.Optional;
import mmneat.analysis.results.MethodName;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.modules.ModuleDivisions;
import mmneat.neat.Genotype;
import pacman.game.GhostLocations;

/** Finds out how a champion senses and plays: its version of the task, its division of modules, the rules wanted. */
public final class PlayerSettings {

    private static final int BLENDED_INPUTS = 30;

    private PlayerSettings() {}

    /**
     * The settings for a champion, one trial per evaluation.
     *
     * @param version blended, interleaved or isolated; if empty, that of the champion's run or what its inputs say
     * @param locations where ghosts stand in the isolated version
     * @throws UserError if the network does not suit the version
     */
    public static MsPacManTaskSettings of(
            Champion champion, Optional<String> version, Rules rules, Optional<GhostLocations> locations) {
        Genotype genotype = champion.genotype();
        String name = version.orElseGet(() -> version(champion));
        MsPacManTaskSettings published =
                switch (name) {
                    case "blended" -> MsPacManTaskSettings.blended();
                    case "interleaved" -> MsPacManTaskSettings.interleaved();
                    default ->
                        MsPacManTaskSettings.isolated(
                                locations.orElseThrow(
                                        () -> new UserError(
                                                "the isolated version needs recorded ghost locations; name the file with ghosts=FILE")));
                };
        int sensors = new mmneat.mspacman.MsPacManTask(published).inputs();
        if (sensors != genotype.inputs()) {
            throw new UserError(champion.file() + ": the network has " + genotype.inputs() + " inputs, but the " + name
                    + " version has " + sensors + " sensors; give the version with task=blended, for example");
        }
        MsPacManTaskSettings divided = genotype.layout().standardMultitask()
                ? published.withDivision(ModuleDivisions.named(division(champion, name)))
                : published;
        return new MsPacManTaskSettings(
                divided.version(),
                1,
                rules.from(divided.rules()),
                divided.sensors(),
                divided.division(),
                divided.arbitration(),
                divided.ghosts(),
                divided.deterministic());
    }

    /** The version that a champion was evolved in. */
    public static String version(Champion champion) {
        String version = MethodName.version(champion.parameters());
        if (!version.isEmpty()) {
            return version;
        }
        return champion.genotype().inputs() == BLENDED_INPUTS ? "blended" : "interleaved";
    }

    private static String division(Champion champion, String version) {
        String saved = champion.parameters().get("pacmanMultitaskScheme");
        if (saved != null && !saved.isEmpty()) {
            return saved;
        }
        return switch (version) {
            case "isolated" -> "AnyPills";
            default -> champion.genotype().modules() == 2 ? "AnyGhostEdible" : "GhostThreatEdibleOrBoth";
        };
    }
}
