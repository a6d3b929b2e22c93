package mmneat.neat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;

/**
 * An exception that foreign code threw (the user's own classes or a contest's entry), read for messages. It may be of a
 * class whose methods throw, return null or return something else each time, and its causes may form a cycle. No method
 * here fails or runs for ever because of that.
 *
 * @param exception what was thrown; any kind, because byte code can throw checked exceptions everywhere
 */
public record Thrown(Throwable exception) {

    /** Maximum number of causes that are read; an exception may make a new cause each time it is asked. */
    private static final int MOST_CAUSES = 100;

    /** Returns the class and the message in one line; the class alone if the exception's own methods fail. */
    public String line() {
        String name = exception.getClass().getName();
        return OneLine.of(answer(exception::toString, name));
    }

    /** Returns the message; empty if there is none or the exception's own method fails. */
    public String message() {
        return answer(exception::getMessage, "");
    }

    /** Returns where it was thrown, for example {@code " at my.Class.method(Class.java:7)"}; empty if unknown. */
    public String place() {
        StackTraceElement[] trace = answer(exception::getStackTrace, new StackTraceElement[0]);
        return trace.length == 0 || trace[0] == null ? "" : OneLine.of(" at " + trace[0]);
    }

    /** Returns the stack trace, whose lines end with line ends; {@link #line} if it cannot be printed. */
    public String trace() {
        return answer(
                () -> {
                    StringWriter text = new StringWriter();
                    exception.printStackTrace(new PrintWriter(text, true));
                    return text.toString();
                },
                line() + System.lineSeparator());
    }

    /** Returns the exception and its causes, each once, at most {@value #MOST_CAUSES}. */
    public List<Throwable> causes() {
        Set<Throwable> known = Collections.newSetFromMap(new IdentityHashMap<>());
        List<Throwable> causes = new ArrayList<>();
        Throwable next = exception;
        while (next != null && causes.size() < MOST_CAUSES && known.add(next)) {
            causes.add(next);
            next = causeOf(next);
        }
        return causes;
    }

    /**
     * Whether it says something about the Java virtual machine, such as exhausted memory, and not about the code that
     * threw it. Endless recursion is a failure of the code.
     */
    boolean isOfTheMachine() {
        return exception instanceof VirtualMachineError && !(exception instanceof StackOverflowError);
    }

    /** Throws the exception again if it {@linkplain #isOfTheMachine says something about the machine}. */
    public void passOnIfOfTheMachine() {
        if (isOfTheMachine()) {
            throw (VirtualMachineError) exception;
        }
    }

    private static @Nullable Throwable causeOf(Throwable exception) {
        try {
            return exception.getCause();
        } catch (Throwable e) {
            return null;
        }
    }

    private static <T> T answer(Supplier<? extends @Nullable T> method, T otherwise) {
        try {
            T answer = method.get();
            return answer == null ? otherwise : answer;
        } catch (Throwable e) {
            return otherwise;
        }
    }
}
