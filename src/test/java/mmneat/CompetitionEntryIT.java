package mmneat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.FieldVisitor;
import org.objectweb.asm.MethodVisitor;
import org.objectweb.asm.Opcodes;

/**
 * A test entry that uses everything public, compiled against the simulator's jar only: it runs with that jar, and the
 * packaged program plays it.
 */
class CompetitionEntryIT {

    private static final Path JAR = Path.of(System.getProperty("mmneat.jar"));
    private static final Path SIMULATOR = JAR.resolveSibling("mmneat-simulator.jar");

    @TempDir
    private Path folder;

    private Path compiledEntry() throws IOException {
        List<String> sources = new ArrayList<>();
        for (String name : List.of("TouringPacMan", "TouringGhosts", "Tour")) {
            try (InputStream source = CompetitionEntryIT.class.getResourceAsStream("/entry/tour/" + name + ".java")) {
                sources.add(new String(source.readAllBytes(), StandardCharsets.UTF_8));
            }
        }
        return CompiledClasses.compile(folder, SIMULATOR.toString(), sources.toArray(String[]::new));
    }

    @Test
    void entry_runsWithTheSimulatorsJarAlone() throws Exception {
        Path classes = compiledEntry();
        ProgramRun run = ProgramRun.java(folder, "-cp", SIMULATOR + java.io.File.pathSeparator + classes, "tour.Tour");
        assertThat(run.errors()).isEmpty();
        assertThat(run.exitCode()).isZero();
        assertThat(run.output()).endsWith("toured" + System.lineSeparator());
    }

    @Test
    void packagedProgram_playsTheEntry_fromAFolderAndAJar() throws Exception {
        Path classes = compiledEntry();
        Path jar = CompiledClasses.jar(classes, folder.resolve("entry.jar"));
        List<String> scores = new ArrayList<>();
        for (Path place : List.of(classes, jar)) {
            ProgramRun run = ProgramRun.java(
                    folder,
                    "-jar",
                    JAR.toString(),
                    "play",
                    "classpath=" + place,
                    "pacman=TouringPacMan",
                    "ghosts=tour.TouringGhosts",
                    "games=3",
                    "seed=1");
            // A slow machine may print progress.
            assertThat(run.errors()).doesNotContain("mmneat:", "Exception");
            assertThat(run.exitCode()).isZero();
            assertThat(run.output()).startsWith("tour.TouringPacMan against tour.TouringGhosts, 3 games");
            scores.add(run.output().lines().toList().get(1));
        }
        assertThat(scores.get(0)).isEqualTo(scores.get(1));
    }

    @Test
    void entryThatEndsTheProgram_isNotTakenForAResult() throws Exception {
        Path classes = CompiledClasses.compile(
                folder,
                SIMULATOR.toString(),
                "public class Leaves extends pacman.controllers.Controller<pacman.game.Constants.MOVE> {"
                        + " public pacman.game.Constants.MOVE getMove(pacman.game.Game game, long due)"
                        + " { System.exit(0); return null; } }");
        ProgramRun run = ProgramRun.java(
                folder, "-jar", JAR.toString(), "play", "classpath=" + classes, "pacman=Leaves", "games=3");
        assertThat(run.exitCode()).isEqualTo(2);
        assertThat(run.output()).isEmpty();
        assertThat(run.errors()).contains("Leaves failed: ").contains("System.exit(0)");
    }

    @Test
    void entry_touchesEveryPublicMember() throws IOException {
        Set<String> used = new HashSet<>();
        try (Stream<Path> files = Files.walk(compiledEntry())) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                new ClassReader(Files.readAllBytes(file)).accept(uses(used), 0);
            }
        }
        Set<String> listed = listedMembers();
        assertThat(listed).hasSizeGreaterThan(250);
        listed.removeAll(used);
        assertThat(listed).isEmpty();
    }

    /**
     * Returns the members of the manifest as name and number of parameters. Constants are left out, because the
     * compiler copies them.
     */
    private static Set<String> listedMembers() throws IOException {
        Set<String> members = new HashSet<>();
        Pattern call = Pattern.compile(".*?([\\w.$]+)\\((.*)\\);");
        Pattern field = Pattern.compile(".* (\\w+);");
        try (BufferedReader text = new BufferedReader(new InputStreamReader(
                CompetitionEntryIT.class.getResourceAsStream("/pacman/programming-interface.txt"),
                StandardCharsets.UTF_8))) {
            for (String line = text.readLine(); line != null; line = text.readLine()) {
                if (!line.startsWith("  ") || line.contains(" = ")) {
                    continue;
                }
                String member = line.strip();
                var matcher = call.matcher(member);
                if (matcher.matches()) {
                    String parameters = matcher.group(2).replaceAll("<[^>]*(<[^>]*>)?[^>]*>", "");
                    int count = parameters.isBlank() ? 0 : parameters.split(",").length;
                    members.add(simpleName(matcher.group(1)) + "/" + count);
                } else if (field.matcher(member).matches()) {
                    members.add(member.replaceAll(".* (\\w+);", "$1"));
                }
            }
        }
        // Not usable by entries: types of elements are hidden, and a constant array of names.
        members.removeAll(Set.of("nodes", "junctions"));
        return members;
    }

    private static String simpleName(String name) {
        return name.substring(Math.max(name.lastIndexOf('.'), name.lastIndexOf('$')) + 1);
    }

    /** Collects the members that a class calls, reads, writes and implements. */
    private static ClassVisitor uses(Set<String> used) {
        return new ClassVisitor(Opcodes.ASM9) {
            @Override
            public FieldVisitor visitField(int access, String name, String descriptor, String signature, Object value) {
                return null;
            }

            @Override
            public MethodVisitor visitMethod(
                    int access, String name, String descriptor, String signature, String[] exceptions) {
                used.add(name + "/" + parameterCount(descriptor));
                return new MethodVisitor(Opcodes.ASM9) {
                    @Override
                    public void visitMethodInsn(
                            int opcode, String owner, String name, String descriptor, boolean isInterface) {
                        String called = name.equals("<init>") ? simpleName(owner.replace('/', '.')) : name;
                        used.add(called + "/" + parameterCount(descriptor));
                    }

                    @Override
                    public void visitFieldInsn(int opcode, String owner, String name, String descriptor) {
                        used.add(name);
                    }
                };
            }
        };
    }

    private static int parameterCount(String descriptor) {
        return org.objectweb.asm.Type.getArgumentTypes(descriptor).length;
    }
}
