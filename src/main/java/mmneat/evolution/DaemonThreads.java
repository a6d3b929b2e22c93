package mmneat.evolution;

import java.util.concurrent.ThreadFactory;

/** Factory of daemon threads: threads that do not keep the program alive. */
public final class DaemonThreads {

    private DaemonThreads() {}

    /** Returns a factory whose threads all have this name. */
    public static ThreadFactory named(String name) {
        return task -> {
            Thread thread = new Thread(task, name);
            thread.setDaemon(true);
            return thread;
        };
    }
}
