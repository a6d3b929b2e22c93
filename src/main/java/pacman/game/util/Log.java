package pacman.game.util;

import java.util.Date;

/**
 * The log of an entry: one object shared by all its parts, which {@link #getLog} returns. Part of the competition's
 * programming interface.
 *
 * <p>Messages are collected in memory; {@link #saveLog} writes them through {@link IO}. No line ends are added.
 */
public class Log {

    /** The interface requires one shared log. It is the only state of the simulator that controllers share. */
    private static final Log LOG = new Log();

    private final StringBuffer text = new StringBuffer();
    private volatile String file = "log.txt";
    private volatile boolean timeStamp;
    private volatile boolean console;

    private Log() {}

    /** Returns the one log of the program. */
    public static Log getLog() {
        return LOG;
    }

    /** Echoes further messages to standard output. */
    public void enableConsolePrinting() {
        console = true;
    }

    /** Stops the echo of further messages to standard output; it is off at first. */
    public void disableConsolePrinting() {
        console = false;
    }

    /** Sets the file's name below {@link IO#DIRECTORY}; "log.txt" if it is never set. */
    public void setFile(String fileName) {
        file = fileName;
    }

    /** Prefixes further messages with the date. */
    public void enableTimeStamp() {
        timeStamp = true;
    }

    /** Leaves out the date in further messages, as at first. */
    public void disableTimeStamp() {
        timeStamp = false;
    }

    /**
     * Adds a message.
     *
     * @param context the object that logs; its class name precedes the message
     */
    public void log(Object context, String message) {
        String date = timeStamp ? new Date() + "; " : "";
        String entry = "[" + date + context.getClass() + "]\t" + message;
        text.append(entry);
        if (console) {
            System.out.println(entry);
        }
    }

    /** Deletes all messages. */
    public void clear() {
        text.setLength(0);
    }

    /**
     * Writes all messages to the file.
     *
     * @param append whether to append to an existing file
     */
    public void saveLog(boolean append) {
        IO.saveFile(file, text.toString(), append);
    }
}
