package mmneat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.InputStream;
import java.lang.module.ModuleFinder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The library jars: each runs with the jars that its POM names, contains only its own packages, and has sources. */
class LibraryJarsIT {

    private static final Path TARGET = Path.of(System.getProperty("mmneat.jar")).getParent();

    /** The jars that a project uses together, on one class path or one module path. */
    private static final List<String> PUBLISHED =
            List.of("random", "simulator-alone", "neat", "nsga2", "evolution", "application");

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({
        "SimulatorUser, simulator",
        "SimulatorUser, simulator-alone random",
        "NeatUser, neat random",
        "Nsga2User, nsga2 random",
        "EvolutionUser, evolution neat nsga2 random"
    })
    void libraries_areEnough(String user, String libraries) throws Exception {
        String source;
        try (InputStream text = LibraryJarsIT.class.getResourceAsStream("/libraries/" + user + ".java")) {
            source = new String(text.readAllBytes(), StandardCharsets.UTF_8);
        }
        String path = Arrays.stream(libraries.split(" "))
                .map(library -> jar(library).toString())
                .collect(Collectors.joining(File.pathSeparator));
        Path classes = CompiledClasses.compile(folder, path, source);
        ProgramRun run = ProgramRun.java(folder, "-cp", path + File.pathSeparator + classes, user);
        assertThat(run.errors()).isEmpty();
        assertThat(run.output().strip()).isEqualTo("true");
    }

    @ParameterizedTest
    @CsvSource({
        "random, random, mmneat/random/",
        "simulator-alone, simulator, pacman/",
        "neat, neat, mmneat/neat/",
        "nsga2, nsga2, mmneat/nsga2/",
        "evolution, evolution, mmneat/evolution/"
    })
    void libraryJar_holdsItsPackagesAlone_andHasSources(String library, String sourcesOf, String own) throws Exception {
        List<String> classes = entries(jar(library), ".class");
        assertThat(classes).isNotEmpty().allMatch(name -> name.startsWith(own));
        List<String> sources = entries(jar(sourcesOf + "-sources"), ".java");
        for (String name : classes) {
            if (!name.contains("$")) {
                String outer = name.replace(".class", ".java");
                assertThat(sources).contains(outer);
            }
        }
    }

    @Test
    void publishedJars_shareNoPackage_andAreModules() throws Exception {
        Map<String, String> jars = new HashMap<>();
        for (String library : PUBLISHED) {
            Set<String> packages = entries(jar(library), ".class").stream()
                    .map(name -> name.substring(0, name.lastIndexOf('/')))
                    .collect(Collectors.toSet());
            for (String name : packages) {
                assertThat(jars.put(name, library)).as(name).isNull();
            }
            assertThat(entries(jar(library), "META-INF/LICENSE")).hasSize(1);
        }
        assertThat(jars).containsKeys("mmneat/random", "pacman/game", "mmneat/cli");
        Path[] paths = PUBLISHED.stream().map(LibraryJarsIT::jar).toArray(Path[]::new);
        assertThat(ModuleFinder.of(paths).findAll().stream()
                        .map(module -> module.descriptor().name()))
                .containsExactlyInAnyOrder(
                        "mmneat.random",
                        "mmneat.simulator",
                        "mmneat.neat",
                        "mmneat.nsga2",
                        "mmneat.evolution",
                        "mmneat");
    }

    private static Path jar(String library) {
        return TARGET.resolve("mmneat-" + library + ".jar");
    }

    private static List<String> entries(Path jar, String ending) throws Exception {
        try (JarFile file = new JarFile(jar.toFile())) {
            return file.stream()
                    .map(entry -> entry.getName())
                    .filter(name -> name.endsWith(ending))
                    .toList();
        }
    }
}
