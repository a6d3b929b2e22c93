package mmneat.evolution;

import java.util.concurrent.ThreadFactory;

/** Makes threads that do not keep the program alive. */
public final class DaemonThreads {

    private DaemonThreads() {}

    /** Makes threads of one name. */
    public static ThreadFactory named(String name) {
        return task -> {
            Thread thread = new Thread(task, name);
            thread.setDaemon(true);
            return thread;
        };
    }
}
