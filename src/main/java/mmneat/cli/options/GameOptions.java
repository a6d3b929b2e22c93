package mmneat.cli.options;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import mmneat.experiment.FileErrors;
import mmneat.experiment.TextFiles;
import mmneat.experiment.UserError;
import org.jspecify.annotations.Nullable;
import pacman.game.GameRules;
import pacman.game.GhostLocations;
import pacman.maze.MazeTables;
import pacman.maze.Mazes;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/**
 * The options that choose the game of the commands {@code play} and {@code replay}: the rules of the simulator ({@code
 * rules=}, for example {@code competition} or {@code blended}), the maze, and the start of an isolated ghost game. The
 * commands that evaluate champions have {@link RulesOption} instead, with other names: it changes the rules of the
 * champion's own task.
 */
public final class GameOptions {

    private static final String DEFAULT_RULES = "competition";

    private static final String ISOLATED_GHOSTS = "isolatedGhosts";

    private static final List<String> MAZES = List.of("a", "b", "c", "d");

    private static final class RuleNames extends ArrayList<String> {
        RuleNames() {
            super(List.of(
                    DEFAULT_RULES,
                    "blended",
                    "interleaved",
                    "isolatedPills",
                    ISOLATED_GHOSTS,
                    "mpmVsGhosts",
                    "fourMaze",
                    "mmneat"));
        }
    }

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(
            names = "rules",
            paramLabel = "RULES",
            completionCandidates = RuleNames.class,
            description = "One of ${COMPLETION-CANDIDATES} (default: those of the recording, or " + DEFAULT_RULES
                    + ": release 6.2 of the competition of 2012).")
    private @Nullable String rules;

    @Option(
            names = "maze",
            paramLabel = "FILE",
            description = "Maze of all levels: a, b, c or d, or the file of a drawing.")
    private @Nullable Path maze;

    @Option(
            names = "ghostLocations",
            paramLabel = "FILE",
            description = "Recorded ghost locations for rules=" + ISOLATED_GHOSTS
                    + " (default: those that come with the program).")
    private @Nullable Path ghostLocations;

    @Option(
            names = "powerPill",
            paramLabel = "CORNER",
            defaultValue = "0",
            description = "Corner for rules=" + ISOLATED_GHOSTS + ", 0 to 3 (default: ${DEFAULT-VALUE}).")
    @Range(min = 0, max = 3)
    private int powerPill;

    /** Returns the rules that the options choose, based on {@code otherwise} if {@code rules=} is not given. */
    public GameRules rules(GameRules otherwise) {
        for (String name : List.of("powerPill", "ghostLocations")) {
            OptionValues.requireEffect(
                    command, name, name().equals(ISOLATED_GHOSTS), "it is used only with rules=" + ISOLATED_GHOSTS);
        }
        GameRules chosen = rules == null ? otherwise : named(rules);
        Path own = maze;
        if (own == null) {
            return chosen;
        }
        if (chosen.ghosts().ghostLocations() != null) {
            return chosen.withMazes(mazes -> mazes.withOnlyMaze(recordedMaze(own.toString())));
        }
        return chosen.withMazes(mazes -> mazes.withMazes(mazes(own)));
    }

    /**
     * Returns the number of a recorded maze. Recorded ghost locations belong to their mazes, which keep their numbers.
     */
    private static int recordedMaze(String name) {
        int index = MAZES.indexOf(name.toLowerCase(Locale.ROOT));
        if (index < 0) {
            throw OptionValues.badValue(
                    "maze",
                    name,
                    "a, b, c or d with rules=" + ISOLATED_GHOSTS + ": ghost locations are recorded in these");
        }
        return index;
    }

    /** The name of the rules, for reports. */
    public String name() {
        return rules == null ? DEFAULT_RULES : rules;
    }

    /** Whether all levels are played in a maze that the user chose. */
    public boolean hasMaze() {
        return maze != null;
    }

    private GameRules named(String name) {
        return switch (name) {
            case DEFAULT_RULES -> GameRules.competition();
            case "blended" -> GameRules.blended();
            case "interleaved" -> GameRules.interleaved();
            case "isolatedPills" -> GameRules.isolatedPills();
            case ISOLATED_GHOSTS -> GameRules.isolatedGhosts(powerPill, ghostLocations());
            case "mpmVsGhosts" -> GameRules.mpmVsGhosts();
            case "fourMaze" -> GameRules.fourMaze();
            case "mmneat" -> GameRules.mmneat();
            default -> throw new IllegalStateException("rules without a preset: " + name);
        };
    }

    private GhostLocations ghostLocations() {
        if (ghostLocations == null) {
            return GhostLocations.shipped();
        }
        Path file = ghostLocations;
        try {
            return GhostLocations.read(file.toString(), TextFiles.reader(file));
        } catch (IOException e) {
            throw FileErrors.unreadable("ghostLocations=" + file, e);
        } catch (IllegalArgumentException e) {
            throw new UserError("ghostLocations: " + e.getMessage(), e);
        }
    }

    private static Mazes mazes(Path file) {
        String letter = file.toString().toLowerCase(Locale.ROOT);
        if (MAZES.contains(letter)) {
            return Mazes.of(List.of(Mazes.standard().get(MAZES.indexOf(letter))));
        }
        try {
            return Mazes.of(List.of(MazeTables.read(file)));
        } catch (IOException e) {
            throw FileErrors.unreadable("maze=" + file, e);
        } catch (IllegalArgumentException e) {
            throw new UserError(e.getMessage(), e);
        }
    }
}
