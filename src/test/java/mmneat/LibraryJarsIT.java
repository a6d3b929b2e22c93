package mmneat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarFile;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Each library jar is enough to compile against and to run with, holds its own packages alone, and has sources. */
class LibraryJarsIT {

    private static final Path TARGET = Path.of(System.getProperty("mmneat.jar")).getParent();

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({"simulator, SimulatorUser", "neat, NeatUser", "nsga2, Nsga2User"})
    void libraryJar_isEnoughAlone(String library, String user) throws Exception {
        String source;
        try (InputStream text = LibraryJarsIT.class.getResourceAsStream("/libraries/" + user + ".java")) {
            source = new String(text.readAllBytes(), StandardCharsets.UTF_8);
        }
        Path jar = TARGET.resolve("mmneat-" + library + ".jar");
        Path classes = CompiledClasses.compile(folder, jar.toString(), source);
        ProgramRun run = ProgramRun.java(folder, "-cp", jar + File.pathSeparator + classes, user);
        assertThat(run.errors()).isEmpty();
        assertThat(run.output().strip()).isEqualTo("true");
    }

    @ParameterizedTest
    @CsvSource({"simulator, pacman/", "neat, mmneat/neat/", "nsga2, mmneat/nsga2/"})
    void libraryJar_holdsItsPackagesAndTheGenerator_andHasSources(String library, String own) throws Exception {
        List<String> classes = entries("mmneat-" + library + ".jar", ".class");
        assertThat(classes).isNotEmpty().allMatch(name -> name.startsWith(own) || name.startsWith("mmneat/random/"));
        List<String> sources = entries("mmneat-" + library + "-sources.jar", ".java");
        assertThat(sources).contains("mmneat/random/ResumableRandom.java");
        for (String name : classes) {
            if (!name.contains("$")) {
                String outer = name.replace(".class", ".java");
                assertThat(sources).contains(outer);
            }
        }
    }

    private static List<String> entries(String jar, String ending) throws Exception {
        try (JarFile file = new JarFile(TARGET.resolve(jar).toFile())) {
            return file.stream()
                    .map(entry -> entry.getName())
                    .filter(name -> name.endsWith(ending))
                    .toList();
        }
    }
}
