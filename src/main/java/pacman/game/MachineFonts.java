package pacman.game;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;

/**
 * The check whether Java can draw text on this machine. Slim containers often have no fonts or lack the libraries for
 * them.
 */
public final class MachineFonts {

    /** The part of a message that says why a picture or its text is missing, and what helps. */
    public static final String MISSING =
            "no fonts on this machine; install fontconfig and a font, such as Debian's fonts-dejavu-core";

    private static final boolean AVAILABLE = textCanBeDrawn();

    private MachineFonts() {}

    /** Whether text can be drawn into a picture. The result is computed once. */
    public static boolean areAvailable() {
        return AVAILABLE;
    }

    private static boolean textCanBeDrawn() {
        try {
            Graphics2D graphics = new BufferedImage(16, 16, BufferedImage.TYPE_INT_RGB).createGraphics();
            graphics.drawString("x", 0, graphics.getFontMetrics().getAscent());
            graphics.dispose();
            return true;
        } catch (OutOfMemoryError | StackOverflowError e) {
            throw e;
        } catch (RuntimeException | Error e) {
            // Fonts, their configuration or a library is missing: Java throws an error of another type for each.
            return false;
        }
    }
}
