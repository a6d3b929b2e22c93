package pacman;

import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import pacman.game.Game;
import pacman.game.GameRules;

/**
 * A game as its states, one per tick: the state string after that tick. In a file each stands on a line of its own.
 * Source: docs/specification/controllers.md, sections 6.4 and 6.5.
 *
 * @param states at least one state string, all of the same number of fields
 */
public record Recording(List<String> states) {

    private static final int COMPETITION_FIELDS = 35;
    private static final int MM_NEAT_FIELDS = 56;

    /** @throws IllegalArgumentException if there is no state, or one has not as many fields as a game's state has */
    public Recording {
        states = List.copyOf(states);
        if (states.isEmpty()) {
            throw new IllegalArgumentException("the recording is empty");
        }
        int fields = fields(states.get(0));
        if (fields != COMPETITION_FIELDS && fields != MM_NEAT_FIELDS) {
            throw new IllegalArgumentException("not a recording: a line of one has " + COMPETITION_FIELDS + " or "
                    + MM_NEAT_FIELDS + " fields, its first line has " + fields);
        }
        for (int i = 0; i < states.size(); i++) {
            if (fields(states.get(i)) != fields) {
                throw new IllegalArgumentException("state " + (i + 1) + " has " + fields(states.get(i))
                        + " fields, those before it " + fields + "; the file is damaged");
            }
        }
    }

    private static int fields(String state) {
        return state.split(",", -1).length;
    }

    /**
     * Reads the lines of a file that are not empty.
     *
     * @throws IllegalArgumentException if they are not a recording
     */
    public static Recording load(Path file) throws IOException {
        try (var lines = Files.lines(file, StandardCharsets.UTF_8)) {
            return new Recording(
                    lines.map(String::strip).filter(line -> !line.isEmpty()).toList());
        } catch (java.io.UncheckedIOException e) {
            if (e.getCause() instanceof CharacterCodingException) {
                throw new IllegalArgumentException("not a recording: it is not a text file", e);
            }
            throw e.getCause();
        }
    }

    /** The rules whose state strings these are: the competition's or MM-NEAT's. */
    public GameRules rules() {
        return fields(states.get(0)) == COMPETITION_FIELDS ? GameRules.competition() : GameRules.mmneat();
    }

    /** Gathers the states of a game that is being played. */
    public static final class Recorder {

        private final List<String> states = new ArrayList<>();

        /** Adds the state after a tick. */
        public void add(Game game) {
            states.add(game.getGameState());
        }

        /** The states, joined by {@code \n}. */
        public String text() {
            return String.join("\n", states);
        }
    }
}
