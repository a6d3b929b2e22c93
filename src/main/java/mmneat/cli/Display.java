package mmneat.cli;

import java.awt.AWTError;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;

/** The screen, for the few commands that open a window; pictures are drawn without one. */
final class Display {

    private static final String HEADLESS = "java.awt.headless";

    private Display() {}

    /**
     * Makes sure that drawing never looks for a screen: one that is named and cannot be reached, as that of a connection that is
     * gone, would end the program.
     */
    static void drawWithoutScreen() {
        System.setProperty(HEADLESS, "true");
    }

    /** Whether a window can be opened. */
    static boolean isThere() {
        try {
            return !GraphicsEnvironment.isHeadless()
                    && GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices().length > 0;
        } catch (AWTError | HeadlessException | NoClassDefFoundError e) {
            // One that cannot be reached; the second time it is asked for, its class is missing.
            return false;
        }
    }
}
