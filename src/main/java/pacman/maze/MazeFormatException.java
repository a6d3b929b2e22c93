package pacman.maze;

/** A maze drawing that cannot be played; the message names file, line, column, tile and what to do. */
public final class MazeFormatException extends IllegalArgumentException {

    private static final long serialVersionUID = 1L;

    MazeFormatException(String message) {
        super(message);
    }
}
