package pacman.maze;

import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;

/**
 * The mazes of a game in the order of its levels; after the last the first follows again. Immutable; mazes load lazily.
 */
public final class Mazes {

    private static final String[] LETTERS = {"a", "b", "c", "d"};
    private static final Mazes STANDARD = new Mazes(LETTERS.length);

    private final AtomicReferenceArray<MazeTables> tables;

    private Mazes(int count) {
        tables = new AtomicReferenceArray<>(count);
    }

    /** The four mazes of the competition. */
    public static Mazes standard() {
        return STANDARD;
    }

    /**
     * Mazes read from drawings of your own.
     *
     * @throws IllegalArgumentException if there is none
     */
    public static Mazes of(List<MazeTables> mazes) {
        if (mazes.isEmpty()) {
            throw new IllegalArgumentException("a game needs at least one maze");
        }
        Mazes own = new Mazes(mazes.size());
        for (int index = 0; index < mazes.size(); index++) {
            own.tables.set(index, mazes.get(index));
        }
        return own;
    }

    /** Number of mazes. */
    public int count() {
        return tables.length();
    }

    /** A maze by its index, from 0. */
    public MazeTables get(int index) {
        MazeTables known = tables.get(index);
        return known != null ? known : load(index);
    }

    private synchronized MazeTables load(int index) {
        MazeTables known = tables.get(index);
        if (known == null) {
            known = MazeTables.standard(LETTERS[index]);
            tables.set(index, known);
        }
        return known;
    }
}
