package mmneat.cli.options;

import java.nio.file.Path;
import java.util.Optional;
import mmneat.analysis.evaluation.Champion;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;

/** The option {@code jar=}: the user's permission to load the classes that the folder of a run names. */
public final class JarOption {

    @Option(
            names = "jar",
            paramLabel = "FILE",
            converter = JarFile.class,
            description =
                    "Jar or folder with your own classes that the run was evolved with (docs/extend.md); empty if they"
                            + " are on the class path. Without it, no code that the folder of a run names is loaded.")
    private @Nullable Path jar;

    /** Parser of the value, which may be empty. */
    private static final class JarFile implements ITypeConverter<Path> {
        @Override
        public Path convert(String text) {
            return text.isEmpty() ? Path.of("") : OptionValues.path(text);
        }
    }

    /** Returns the champion, with this jar for the classes of its run. */
    public Champion allow(Champion champion) {
        return champion.withJar(file());
    }

    /** The jar; empty if none is given; the empty path for classes on the class path. */
    public Optional<Path> file() {
        return Optional.ofNullable(jar);
    }
}
