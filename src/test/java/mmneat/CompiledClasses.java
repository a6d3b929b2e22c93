package mmneat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;

/** Compiles small sources for tests against a given class path, into a folder or jar. */
public final class CompiledClasses {

    private static final Pattern COMMENT = Pattern.compile("/\\*.*?\\*/", Pattern.DOTALL);
    private static final Pattern PACKAGE = Pattern.compile("package ([\\w.]+);");
    private static final Pattern TYPE = Pattern.compile("(?:class|enum|interface) (\\w+)");

    private CompiledClasses() {}

    /**
     * Compiles sources.
     *
     * @param folder folder for the sources and the classes
     * @param classPath class path of the sources
     * @param sources each one compilation unit
     * @return the folder of the classes
     */
    public static Path compile(Path folder, String classPath, String... sources) throws IOException {
        Path classes = Files.createDirectories(folder.resolve("classes"));
        List<String> arguments = new ArrayList<>(
                List.of("-classpath", classPath, "-d", classes.toString(), "-proc:none", "--release", "17"));
        for (String source : sources) {
            Path file = folder.resolve("sources").resolve(fileName(source));
            Files.createDirectories(file.getParent());
            Files.writeString(file, source);
            arguments.add(file.toString());
        }
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        ByteArrayOutputStream errors = new ByteArrayOutputStream();
        int code = compiler.run(null, null, errors, arguments.toArray(String[]::new));
        assertThat(code).as(errors.toString()).isZero();
        return classes;
    }

    /** Packs a folder of classes. */
    public static Path jar(Path classes, Path jar) throws IOException {
        try (JarOutputStream out = new JarOutputStream(Files.newOutputStream(jar));
                Stream<Path> files = Files.walk(classes)) {
            for (Path file : files.filter(Files::isRegularFile).toList()) {
                out.putNextEntry(
                        new JarEntry(classes.relativize(file).toString().replace('\\', '/')));
                Files.copy(file, out);
                out.closeEntry();
            }
        }
        return jar;
    }

    private static String fileName(String source) {
        Matcher name = PACKAGE.matcher(source);
        String folder = name.find() ? name.group(1).replace('.', '/') + "/" : "";
        Matcher type = TYPE.matcher(COMMENT.matcher(source).replaceAll(""));
        assertThat(type.find()).as("a type in the source").isTrue();
        return folder + type.group(1) + ".java";
    }
}
