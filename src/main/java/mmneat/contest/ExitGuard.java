package mmneat.contest;

import java.util.Arrays;
import java.util.Map;

/**
 * Watches over the end of the program while games are played. A controller may end the program in ways that its byte code does
 * not show: the exit code 0 that it chooses must not look like a result.
 */
final class ExitGuard {

    private static final int FAILED = 2;

    private final Thread hook;

    /** @param report says, in the shutdown of the program, what was reached */
    ExitGuard(Runnable report) {
        hook = new Thread(() -> {
            report.run();
            if (isEndedByAController(Thread.getAllStackTraces())) {
                Runtime.getRuntime().halt(FAILED);
            }
        });
        Runtime.getRuntime().addShutdownHook(hook);
    }

    /** Signals end the program without a call of exit; closing the window calls it in the event thread. */
    private static boolean isEndedByAController(Map<Thread, StackTraceElement[]> stacks) {
        return stacks.entrySet().stream()
                .filter(stack -> !stack.getKey().getName().startsWith("AWT-"))
                .flatMap(stack -> Arrays.stream(stack.getValue()))
                .anyMatch(frame -> frame.getClassName().equals("java.lang.Runtime")
                        && frame.getMethodName().equals("exit"));
    }

    /** Ends the watch. */
    void close() {
        try {
            Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException e) {
            // The program ends already, as the last game does: the hook is at work.
            return;
        }
    }
}
