package mmneat.contest.entry;

/**
 * Thrown where an entry tries to end the program: {@code System.exit}, {@code Runtime.exit} and {@code Runtime.halt} in its
 * classes become calls of the methods here. An error, so that an entry that catches its own exceptions does not catch it.
 */
public final class ControllerExit extends Error {

    private static final long serialVersionUID = 1;

    private ControllerExit(String call) {
        super("the controller called " + call + " to end the program");
    }

    /** Stands for {@code System.exit}. */
    public static void exit(int status) {
        throw new ControllerExit("System.exit(" + status + ")");
    }

    /** Stands for {@code Runtime.exit}. */
    public static void exit(Runtime runtime, int status) {
        throw new ControllerExit("Runtime.exit(" + status + ")");
    }

    /** Stands for {@code Runtime.halt}, after which not even a shutdown hook could say what happened. */
    public static void halt(Runtime runtime, int status) {
        throw new ControllerExit("Runtime.halt(" + status + ")");
    }
}
