package mmneat.cli.output;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;

/** Access to the screen, for the few commands that open a window. Pictures are drawn without a screen. */
public final class Display {

    private static final String HEADLESS = "java.awt.headless";

    private Display() {}

    /**
     * Makes Java draw without a screen. Otherwise a configured screen that cannot be reached, for example after a lost
     * connection, would end the program.
     */
    public static void drawWithoutScreen() {
        System.setProperty(HEADLESS, "true");
    }

    /** Whether a window can be opened. */
    public static boolean isThere() {
        try {
            return !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (AWTError | HeadlessException | NoClassDefFoundError e) {
            // The screen cannot be reached. On a second attempt Java reports a missing class instead.
            return false;
        }
    }
}
