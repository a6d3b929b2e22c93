package mmneat.analysis.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Distances between the colours of modules, as readers with normal and with dichromatic vision see them. */
class ModuleColoursTest {

    /**
     * CIELAB distance. 2.3 is just noticeable side by side; separate thin lines need about ten times as much.
     */
    private static final double MINIMUM_DISTANCE = 25;

    /** Linear RGB as seen by a dichromat: Machado, Oliveira and Fernandes 2009, severity 1.0. */
    private enum Vision {
        NORMAL(1, 0, 0, 0, 1, 0, 0, 0, 1),
        PROTANOPIA(0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998),
        DEUTERANOPIA(0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881),
        TRITANOPIA(1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900);

        private final double[] matrix;

        Vision(double... matrix) {
            this.matrix = matrix;
        }

        double[] see(Color color) {
            double[] seen = times(
                    matrix, new double[] {linear(color.getRed()), linear(color.getGreen()), linear(color.getBlue())});
            for (int i = 0; i < seen.length; i++) {
                seen[i] = Math.max(0, Math.min(1, seen[i]));
            }
            return lab(seen);
        }
    }

    @ParameterizedTest
    @EnumSource
    void everyTwoColours_differ(Vision vision) {
        for (int a = 0; a < ModuleColours.size(); a++) {
            for (int b = 0; b < a; b++) {
                assertThat(distance(vision.see(ModuleColours.of(a)), vision.see(ModuleColours.of(b))))
                        .as("modules %d and %d", b + 1, a + 1)
                        .isGreaterThan(MINIMUM_DISTANCE);
            }
        }
    }

    private static double distance(double[] a, double[] b) {
        return Math.sqrt(Math.pow(a[0] - b[0], 2) + Math.pow(a[1] - b[1], 2) + Math.pow(a[2] - b[2], 2));
    }

    private static double linear(int channel) {
        double share = channel / 255.0;
        return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
    }

    /** CIELAB of linear sRGB under illuminant D65. */
    private static double[] lab(double[] rgb) {
        double[] toXyz = {
            0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041
        };
        double[] xyz = times(toXyz, rgb);
        double[] white = times(toXyz, new double[] {1, 1, 1});
        double[] f = new double[3];
        for (int i = 0; i < f.length; i++) {
            double share = xyz[i] / white[i];
            f[i] = share > 216.0 / 24389 ? Math.cbrt(share) : (24389.0 / 27 * share + 16) / 116;
        }
        return new double[] {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
    }

    private static double[] times(double[] matrix, double[] vector) {
        double[] product = new double[3];
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 3; column++) {
                product[row] += matrix[3 * row + column] * vector[column];
            }
        }
        return product;
    }
}
