package mmneat.contest;

import java.util.Arrays;
import java.util.Map;

/**
 * A shutdown hook that reports the result so far if the program ends while games are played. If a controller ended the
 * program by a call of exit, the hook also changes the exit code to 2, so that a program that a controller ended with
 * code 0 does not look successful.
 *
 * <p>{@link mmneat.contest.entry.ExitCalls} already turns calls of exit in the byte code of an entry into errors. The
 * hook is for the calls that are not visible there, for example by reflection.
 */
final class ExitGuard {

    private static final int FAILED = 2;

    private final Thread hook;

    /** @param report reports, during the shutdown, the result so far */
    ExitGuard(Runnable report) {
        hook = new Thread(() -> {
            report.run();
            if (isEndedByAController(Thread.getAllStackTraces())) {
                Runtime.getRuntime().halt(FAILED);
            }
        });
        Runtime.getRuntime().addShutdownHook(hook);
    }

    /**
     * Whether a controller ended the program. Signals end it without a call of exit; closing the window calls exit in
     * the event thread.
     */
    private static boolean isEndedByAController(Map<Thread, StackTraceElement[]> stacks) {
        return stacks.entrySet().stream()
                .filter(stack -> !stack.getKey().getName().startsWith("AWT-"))
                .flatMap(stack -> Arrays.stream(stack.getValue()))
                .anyMatch(frame -> frame.getClassName().equals("java.lang.Runtime")
                        && frame.getMethodName().equals("exit"));
    }

    /** Removes the hook. */
    void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            // The program is already ending, and the hook is running.
            return;
        }
    }
}
