package mmneat.contest.entry;

/**
 * Thrown when an entry tries to end the program: {@code System.exit}, {@code Runtime.exit} and {@code Runtime.halt} in
 * its classes become calls of the methods here. It is an Error, so that an entry that catches exceptions does not catch
 * it.
 */
public final class ControllerExit extends Error {

    private static final long serialVersionUID = 1;

    private ControllerExit(String call) {
        super("the controller called " + call + " to end the program");
    }

    /** Replaces {@code System.exit}. */
    public static void exit(int status) {
        throw new ControllerExit("System.exit(" + status + ")");
    }

    /** Replaces {@code Runtime.exit}. */
    public static void exit(Runtime runtime, int status) {
        throw new ControllerExit("Runtime.exit(" + status + ")");
    }

    /** Replaces {@code Runtime.halt}, after which not even shutdown hooks run. */
    public static void halt(Runtime runtime, int status) {
        throw new ControllerExit("Runtime.halt(" + status + ")");
    }
}
