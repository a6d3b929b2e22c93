package mmneat.contest;

import java.util.Arrays;
import java.util.Map;

/**
 * A shutdown hook that is active while games are played. A controller may end the program in ways that its byte code
 * does not show. Its exit code 0 must not look like a result.
 */
final class ExitGuard {

    private static final int FAILED = 2;

    private final Thread hook;

    /**
     * @param report reports, during the shutdown, the result so far
     */
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
