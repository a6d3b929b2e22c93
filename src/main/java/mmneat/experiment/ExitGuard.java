package mmneat.experiment;

import java.io.PrintWriter;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.IntStream;

/**
 * A shutdown hook for the time in which foreign code runs (the user's own classes or a contest's entry). If the program
 * ends in that time, the hook reports it. If foreign code ended it by a call of exit, the hook also changes the exit
 * code, so that a program that was ended with code 0 does not look successful.
 *
 * <p>{@code Runtime.halt} runs no hooks and cannot be detected.
 */
public final class ExitGuard {

    /** The exit code of a command that a class of the user's own ended. */
    private static final int FAILED = 1;

    private static final List<String> OF_JAVA = List.of(
            "java.lang.Runtime", "java.lang.System", "java.lang.reflect.", "java.lang.invoke.", "jdk.internal.");

    private final Thread hook;

    /**
     * Starts to guard.
     *
     * @param code the exit code if foreign code calls exit
     * @param report reports the end in the hook's thread; it receives the name of the class that called exit, or
     *     nothing if the program ends for another reason, such as Ctrl-C
     */
    public ExitGuard(int code, Consumer<Optional<String>> report) {
        this(caller -> {
            report.accept(caller);
            if (caller.isPresent()) {
                Runtime.getRuntime().halt(code);
            }
        });
    }

    private ExitGuard(Consumer<Optional<String>> end) {
        hook = new Thread(() -> end.accept(caller(Thread.getAllStackTraces())), "end of the program");
        Runtime.getRuntime().addShutdownHook(hook);
    }

    /**
     * Starts to guard within the time of another guard, which reports calls of exit. Hooks run at the same time, so
     * this one must not end the program before the other has reported.
     *
     * @param report reports the end for another reason, such as Ctrl-C, in the hook's thread
     */
    public static ExitGuard within(Runnable report) {
        return new ExitGuard(caller -> {
            if (caller.isEmpty()) {
                report.run();
            }
        });
    }

    /** Does work of a command that may call foreign code; if that code calls exit, the command fails with one line. */
    public static <T> T guard(PrintWriter errors, Supplier<T> work) {
        ExitGuard guard = new ExitGuard(FAILED, caller -> {
            caller.ifPresent(name -> errors.println("mmneat: " + sentence(name) + " before the command was complete"));
            errors.flush();
        });
        try {
            return work.get();
        } finally {
            guard.remove();
        }
    }

    /** Returns the beginning of a message: which class called exit. */
    public static String sentence(String caller) {
        return PlainText.shown(caller) + " ended the program by a call of exit";
    }

    /**
     * Returns the class that called exit. Signals end the program without a call of exit; closing the window calls exit
     * in the event thread.
     */
    private static Optional<String> caller(Map<Thread, StackTraceElement[]> stacks) {
        return stacks.entrySet().stream()
                .filter(stack -> !stack.getKey().getName().startsWith("AWT-"))
                .flatMap(stack -> caller(stack.getValue()).stream())
                .findFirst();
    }

    private static Optional<String> caller(StackTraceElement[] stack) {
        return IntStream.range(0, stack.length)
                .filter(i -> stack[i].getClassName().equals("java.lang.Runtime")
                        && stack[i].getMethodName().equals("exit"))
                .mapToObj(i -> callerBelow(stack, i))
                .findFirst();
    }

    /** Returns the first class below a call of exit that is not one of Java's, through which exit can be called. */
    private static String callerBelow(StackTraceElement[] stack, int exit) {
        return Arrays.stream(stack, exit, stack.length)
                .map(StackTraceElement::getClassName)
                .filter(name -> OF_JAVA.stream().noneMatch(name::startsWith))
                .findFirst()
                .orElse("a class");
    }

    /**
     * Removes the hook. If the program is already ending, waits until the hook has reported it; otherwise the caller's
     * own end of the program could be mistaken for that of foreign code.
     *
     * @return false if the program is already ending
     */
    public boolean remove() {
        try {
            return Runtime.getRuntime().removeShutdownHook(hook);
        } catch (IllegalStateException ending) {
            try {
                hook.join();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
            return false;
        }
    }
}
