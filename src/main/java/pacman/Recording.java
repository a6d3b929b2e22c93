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
 * A recorded game: the state string after each tick. A file has one state string per line. Source:
 * docs/specification/controllers.md, sections 6.4 and 6.5.
 *
 * @param states at least one state string, all of the same number of fields
 */
public record Recording(List<String> states) {

    private static final int COMPETITION_FIELDS = 35;
    private static final int MM_NEAT_FIELDS = 56;

    /**
     * Number of additional fields at the start of MM-NEAT's states; the last {@link #SWITCHES} of them are switches.
     */
    private static final int COUNTERS = 20;

    private static final int SWITCHES = 4;

    /** Indices of fields in the competition's form. */
    private static final int TIME = 1;

    private static final int SCORE = 2;
    private static final int LEVEL = 4;
    private static final int EXTRA_LIFE = 8;

    /** Number of fields at the end that record what was eaten in the last step. */
    private static final int SWITCHES_AT_END = 7;

    /** @throws IllegalArgumentException if there is no state, or one has the wrong number of fields */
    public Recording {
        states = List.copyOf(states);
        if (states.isEmpty()) {
            throw new IllegalArgumentException("the recording is empty");
        }
        int fields = fields(states.get(0));
        if (fields != COMPETITION_FIELDS && fields != MM_NEAT_FIELDS) {
            throw new IllegalArgumentException("not a recording: lines of a recording have " + COMPETITION_FIELDS
                    + " or " + MM_NEAT_FIELDS + " fields, but the first line has " + fields);
        }
        for (int i = 0; i < states.size(); i++) {
            if (fields(states.get(i)) != fields) {
                throw new IllegalArgumentException("state " + (i + 1) + " has " + fields(states.get(i))
                        + " fields, those before it " + fields + "; the file is damaged");
            }
        }
    }

    /**
     * Checks that the states follow each other as those of one game do. Each state must be one time step after the
     * state before it, in the same level or the next, and with the same score or more. Fields that are switches must be
     * true or false, and pills must be 0 or 1. The last state may be equal to the one before it: this happens when a
     * controller ended the game.
     *
     * @throws IllegalArgumentException if a state breaks a rule; the message names the first one
     */
    public void requireContinuous() {
        String[] before = null;
        for (int i = 0; i < states.size(); i++) {
            String[] state = states.get(i).split(",", -1);
            String place = "state " + (i + 1) + ": ";
            requireSwitches(place, state);
            boolean isRepeatedEnd =
                    i > 0 && i == states.size() - 1 && states.get(i).equals(states.get(i - 1));
            if (before == null) {
                requireBeginning(place, state);
            } else if (!isRepeatedEnd) {
                requireFollows(place, before, state);
            }
            before = state;
        }
    }

    private static void requireBeginning(String place, String[] state) {
        int first = state.length == COMPETITION_FIELDS ? 0 : COUNTERS;
        if (number(place, state, first + TIME) > 1) {
            throw new IllegalArgumentException(place + "the recording begins at time " + state[first + TIME]
                    + ", so states are missing; the file is damaged");
        }
    }

    private static void requireFollows(String place, String[] before, String[] state) {
        int first = state.length == COMPETITION_FIELDS ? 0 : COUNTERS;
        long passed = number(place, state, first + TIME) - number(place, before, first + TIME);
        if (passed != 1) {
            throw new IllegalArgumentException(place + "time " + state[first + TIME] + " follows time "
                    + before[first + TIME] + ", so states are missing or in the wrong order; the file is damaged");
        }
        long levels = number(place, state, first + LEVEL) - number(place, before, first + LEVEL);
        if (levels < 0 || levels > 1) {
            throw new IllegalArgumentException(place + "level " + state[first + LEVEL] + " follows level "
                    + before[first + LEVEL] + "; the file is damaged");
        }
        if (number(place, state, first + SCORE) < number(place, before, first + SCORE)) {
            throw new IllegalArgumentException(place + "score " + state[first + SCORE] + " follows score "
                    + before[first + SCORE] + "; the file is damaged");
        }
    }

    private static long number(String place, String[] state, int field) {
        try {
            return Integer.parseInt(state[field]);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(
                    place + "field " + (field + 1) + " must be a whole number, is '" + state[field] + "'", e);
        }
    }

    private static void requireSwitches(String place, String[] state) {
        boolean isLong = state.length == MM_NEAT_FIELDS;
        for (int field = 0; field < state.length; field++) {
            boolean isSwitch = isLong && field >= COUNTERS - SWITCHES && field < COUNTERS
                    || field == (isLong ? COUNTERS + EXTRA_LIFE + 1 : EXTRA_LIFE)
                    || field >= state.length - SWITCHES_AT_END;
            if (isSwitch && !state[field].equals("true") && !state[field].equals("false")) {
                throw new IllegalArgumentException(
                        place + "field " + (field + 1) + " must be true or false, is '" + state[field] + "'");
            }
            boolean arePills =
                    field == state.length - SWITCHES_AT_END - 2 || field == state.length - SWITCHES_AT_END - 3;
            if (arePills && !state[field].matches("[01]*")) {
                throw new IllegalArgumentException(place + "field " + (field + 1) + " must have 0 or 1 for each pill");
            }
        }
    }

    private static int fields(String state) {
        return state.split(",", -1).length;
    }

    /**
     * Reads a recording from the non-empty lines of a file.
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

    /**
     * Returns a preset with the format of the state strings: {@link GameRules#competition} for 35 fields, {@link
     * GameRules#mmneat} for 56. It serves to show the recording ({@link Executor#replayGame}); it need not equal the
     * rules by which the game was played, which a recording does not contain.
     */
    public GameRules rules() {
        return fields(states.get(0)) == COMPETITION_FIELDS ? GameRules.competition() : GameRules.mmneat();
    }

    /** Collects the states of a game during play. */
    public static final class Recorder {

        private final List<String> states = new ArrayList<>();

        /** Adds the state after a tick. */
        public void add(Game game) {
            states.add(game.getGameState());
        }

        /** Returns the states joined by {@code \n}. */
        public String text() {
            return String.join("\n", states);
        }
    }
}
