package mmneat.cli;

import java.io.IOException;
import java.io.Reader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import mmneat.experiment.FileTrouble;
import mmneat.experiment.UserError;
import pacman.game.GameRules;
import pacman.game.GhostLocations;
import pacman.game.internal.MazeTables;
import pacman.game.internal.Mazes;

/** The words that choose a game: its rules and mazes. */
final class GameWords {

    static final String DEFAULT_RULES = "competition";

    private static final String ISOLATED_GHOSTS = "isolatedGhosts";

    private static final List<String> RULES = List.of(
            DEFAULT_RULES,
            "blended",
            "interleaved",
            "isolatedPills",
            ISOLATED_GHOSTS,
            "mpmVsGhosts",
            "fourMaze",
            "mmneat");

    private static final List<String> MAZES = List.of("a", "b", "c", "d");

    static final List<Word> KNOWN = List.of(
            new Word(
                    "rules",
                    DEFAULT_RULES,
                    "one of " + String.join(", ", RULES) + " (default " + DEFAULT_RULES
                            + ": release 6.2 of the competition of 2012)"),
            new Word("maze", "FILE", "a, b, c or d, or a drawing: all levels are played in this maze"),
            new Word(
                    "ghostLocations",
                    "FILE",
                    "recorded ghost locations for rules=" + ISOLATED_GHOSTS + " (default: ours)"),
            new Word("powerPill", "0", "0 to 3: the corner of rules=" + ISOLATED_GHOSTS + " (default 0)"));

    private GameWords() {}

    /** The rules that the words choose; {@code otherwise} is used if there is no rules= among them. */
    static GameRules rules(Words words, GameRules otherwise) {
        for (String name : List.of("powerPill", "ghostLocations")) {
            words.requireEffect(name, name(words).equals(ISOLATED_GHOSTS), "it goes with rules=" + ISOLATED_GHOSTS);
        }
        GameRules rules = words.has("rules") ? named(name(words), words) : otherwise;
        if (!words.has("maze")) {
            return rules;
        }
        String maze = words.requiredText("maze", "FILE");
        if (rules.ghostLocations() != null) {
            return rules.with().onlyMaze(recordedMaze(maze)).build();
        }
        return rules.with().mazes(mazes(maze)).build();
    }

    /** Recorded ghost locations belong to their mazes, which keep their numbers. */
    private static int recordedMaze(String name) {
        int index = MAZES.indexOf(name.toLowerCase(Locale.ROOT));
        if (index < 0) {
            throw Words.badValue(
                    "maze",
                    name,
                    "a, b, c or d with rules=" + ISOLATED_GHOSTS + ": ghost locations are recorded in these");
        }
        return index;
    }

    /** The name of the rules, for reports. */
    static String name(Words words) {
        return words.choice("rules", DEFAULT_RULES, RULES);
    }

    private static GameRules named(String name, Words words) {
        return switch (name) {
            case DEFAULT_RULES -> GameRules.competition();
            case "blended" -> GameRules.blended();
            case "interleaved" -> GameRules.interleaved();
            case "isolatedPills" -> GameRules.isolatedPills();
            case ISOLATED_GHOSTS ->
                GameRules.isolatedGhosts(words.integer("powerPill", 0, 0, 3), ghostLocations(words));
            case "mpmVsGhosts" -> GameRules.mpmVsGhosts();
            case "fourMaze" -> GameRules.fourMaze();
            case "mmneat" -> GameRules.mmneat();
            default -> throw new IllegalStateException("rules without a preset: " + name);
        };
    }

    private static GhostLocations ghostLocations(Words words) {
        if (!words.has("ghostLocations")) {
            return GhostLocations.shipped();
        }
        Path file = words.path("ghostLocations").orElseThrow();
        try (Reader text = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
            return GhostLocations.read(file.toString(), text);
        } catch (IOException e) {
            throw new UserError("ghostLocations: cannot read " + file + ": " + FileTrouble.reason(e), e);
        } catch (IllegalArgumentException e) {
            throw new UserError("ghostLocations: " + e.getMessage(), e);
        }
    }

    private static Mazes mazes(String name) {
        String letter = name.toLowerCase(Locale.ROOT);
        if (MAZES.contains(letter)) {
            return Mazes.of(List.of(Mazes.standard().get(MAZES.indexOf(letter))));
        }
        Path file = Path.of(name);
        try {
            return Mazes.of(List.of(MazeTables.read(file)));
        } catch (IOException e) {
            throw new UserError("maze: cannot read " + file + ": " + FileTrouble.reason(e), e);
        } catch (IllegalArgumentException e) {
            throw new UserError(e.getMessage(), e);
        }
    }
}
