package mmneat.experiment.store;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledForJreRange;
import org.junit.jupiter.api.condition.JRE;

/** With every version of Java, doubles are written as by the Java of the original's time. */
class DoubleTextTest {

    /** Many of the recorded texts have one digit more than those of Java 19 and later. */
    @Test
    void everyRecordedDouble_hasItsText() throws IOException {
        try (BufferedReader lines = new BufferedReader(new InputStreamReader(
                DoubleTextTest.class.getResourceAsStream("doubles-before-java-19.tsv"), StandardCharsets.US_ASCII))) {
            List<String> recorded = lines.lines().toList();
            assertThat(recorded).hasSizeGreaterThan(200);
            for (String line : recorded) {
                String[] fields = line.split("\t");
                double value = Double.longBitsToDouble(Long.parseUnsignedLong(fields[0], 16));
                assertThat(DoubleText.of(value)).as(fields[0]).isEqualTo(fields[1]);
            }
        }
    }

    @Test
    @EnabledForJreRange(max = JRE.JAVA_18)
    void anyDouble_hasTheTextOfAnOldJava() {
        ResumableRandom random = new ResumableRandom(11);
        for (int i = 0; i < 40_000; i++) {
            requireText(Double.longBitsToDouble(random.nextLong()));
            requireText(random.nextInt(100_000) / (double) (1 + random.nextInt(50)));
            requireText((random.nextInt(2000) - 1000) / 10.0);
            requireText(random.nextGaussian());
            requireText((double) (random.nextLong() >> random.nextInt(63)));
            requireText(Math.scalb(1 + random.nextInt(4) / 4.0, random.nextInt(2098) - 1074));
        }
    }

    @Test
    void anyDouble_isReadBackUnchanged() {
        ResumableRandom random = new ResumableRandom(12);
        for (int i = 0; i < 20_000; i++) {
            double value = Double.longBitsToDouble(random.nextLong());
            assertThat(Double.valueOf(DoubleText.of(value))).isEqualTo(Double.valueOf(value));
        }
    }

    private static void requireText(double value) {
        String expected = Double.toString(value);
        if (!DoubleText.of(value).equals(expected)) {
            assertThat(DoubleText.of(value)).as("%h", value).isEqualTo(expected);
        }
    }
}
