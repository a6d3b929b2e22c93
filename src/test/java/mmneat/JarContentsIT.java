package mmneat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarFile;
import java.util.zip.ZipEntry;
import org.junit.jupiter.api.Test;

/** The runnable jar is small and contains the licences of everything in it. */
class JarContentsIT {

    private static final Path JAR = Path.of(System.getProperty("mmneat.jar"));
    private static final long LARGEST = 6_000_000;

    @Test
    void jar_isBelowSixMegabytes() throws IOException {
        assertThat(Files.size(JAR)).isLessThan(LARGEST);
    }

    @Test
    void jar_listsEveryLibrary_withItsLicence() throws IOException {
        try (JarFile jar = new JarFile(JAR.toFile())) {
            assertThat(text(jar, "META-INF/LICENSE")).startsWith("MIT License");
            String thirdParty = text(jar, "META-INF/THIRD-PARTY.txt");
            List<String> libraries = jar.stream()
                    .map(ZipEntry::getName)
                    .filter(name -> name.startsWith("META-INF/maven/") && name.endsWith("/pom.properties"))
                    .map(name -> name.split("/")[3])
                    .filter(name -> !name.equals("mmneat"))
                    .toList();
            assertThat(libraries).contains("jackson-core", "commons-math3").allSatisfy(library -> assertThat(thirdParty)
                    .containsPattern("(?m)^" + library + " "));
            // ASM and picocli do not contain their coordinates.
            assertThat(thirdParty).contains("picocli", "asm-tree");
            for (String line :
                    thirdParty.lines().filter(l -> l.endsWith(".txt")).toList()) {
                String licence = line.substring(line.lastIndexOf(' ') + 1);
                assertThat(text(jar, "META-INF/licenses/" + licence)).hasSizeGreaterThan(1000);
            }
        }
    }

    @Test
    void jar_holdsNothingUnderTheLgpl_andNoFormatOfDocuments() throws IOException {
        try (JarFile jar = new JarFile(JAR.toFile())) {
            assertThat(jar.stream().map(ZipEntry::getName))
                    .noneMatch(name -> name.contains("vectorgraphics2d") || name.contains("pdfbox"));
        }
    }

    private static String text(JarFile jar, String name) throws IOException {
        ZipEntry entry = jar.getEntry(name);
        assertThat(entry).as(name).isNotNull();
        try (InputStream text = jar.getInputStream(entry)) {
            return new String(text.readAllBytes(), StandardCharsets.UTF_8);
        }
    }
}
