package mmneat.analysis.evaluation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import mmneat.analysis.results.RunParameters;
import mmneat.experiment.FileErrors;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.OwnActivation;
import mmneat.experiment.parameters.PublishedTask;
import mmneat.experiment.store.OrdinaryFiles;
import mmneat.experiment.store.RunLayout;
import mmneat.neat.Genotype;
import mmneat.neat.io.GenotypeFiles;
import mmneat.neat.io.GenotypeFormatException;

/**
 * A network to evaluate or to watch, with the folder and parameters of the run that evolved it.
 *
 * @param genotype the network
 * @param file the file that it was read from
 * @param runFolder the folder of its run; empty if the file stands alone
 * @param parameters the parameters of its run; empty if the file stands alone
 * @param jar the jar or folder, named by the user, with the classes that the run's parameters mention; if empty, those
 *     classes are not loaded, because the folder of a run may be untrusted
 */
public record Champion(
        Genotype genotype, Path file, Optional<Path> runFolder, Map<String, String> parameters, Optional<Path> jar) {

    /** Creates a champion without a jar. Classes of the user's own that the run's parameters name are not loaded. */
    public Champion(Genotype genotype, Path file, Optional<Path> runFolder, Map<String, String> parameters) {
        this(genotype, file, runFolder, parameters, Optional.empty());
    }

    /**
     * A copy with a jar for the classes that the run's parameters and the network mention. The network's activation
     * functions are loaded.
     *
     * @throws UserError if the jar lacks one of them
     */
    public Champion withJar(Optional<Path> named) {
        Genotype bound = named.map(path -> OwnActivation.bind(genotype, path)).orElse(genotype);
        return new Champion(bound, file, runFolder, parameters, named);
    }

    /**
     * Checks that the network can play: none of its activation functions is a class that the user has not allowed to
     * load.
     *
     * @throws UserError if one is; the message says how to allow it
     */
    public void requireActivation() {
        OwnActivation.requireBound(genotype, file, parameters.getOrDefault("jar", ""));
    }

    /** Whether a folder of a run holds its champion. */
    public static boolean isIn(Path folder) {
        return RunLayout.championIn(folder).isPresent();
    }

    /**
     * Reads the champion from the folder of a run, or a network from a file; both may be the original's.
     *
     * @throws UserError if there is none
     */
    public static Champion read(Path path) {
        if (Files.isDirectory(path)) {
            OrdinaryFiles.requireIn(path);
        }
        Path file = Files.isDirectory(path) ? RunLayout.championIn(path).orElseThrow(() -> noChampion(path)) : path;
        if (!Files.exists(file)) {
            throw new UserError(file + ": there is no such file; give a run's folder or the file of a network");
        }
        try {
            Optional<Path> folder = runFolder(file);
            folder.ifPresent(OrdinaryFiles::requireIn);
            return new Champion(GenotypeFiles.read(file), file, folder, RunParameters.read(folder));
        } catch (GenotypeFormatException e) {
            throw new UserError(e.getMessage(), e);
        } catch (IOException e) {
            throw FileErrors.unreadable(file, e);
        }
    }

    /** The error for a folder without a champion; it names a run if the folder is that of an experiment. */
    private static UserError noChampion(Path folder) {
        return new UserError(folder + ": there is no champion in this folder (" + RunLayout.CHAMPION + " or "
                + RunLayout.ORIGINAL_CHAMPION + "); give the folder of a run"
                + runIn(folder).map(path -> ", for example " + path).orElse(" or the file of a network"));
    }

    /**
     * Returns the first folder of a run with a champion in the folder of an experiment; empty if there is none.
     *
     * @throws UserError if the folder cannot be read
     */
    public static Optional<Path> runIn(Path experiment) {
        try (Stream<Path> folders = Files.list(experiment)) {
            return folders.filter(Files::isDirectory).filter(Champion::isIn).min(Comparator.naturalOrder());
        } catch (IOException e) {
            throw FileErrors.unreadable(experiment, e);
        }
    }

    /**
     * The folder with the parameters: that of the file or the one above it, as a run keeps the networks of generations
     * in subfolders.
     */
    private static Optional<Path> runFolder(Path file) {
        return Stream.iterate(file.toAbsolutePath().getParent(), java.util.Objects::nonNull, Path::getParent)
                .limit(2)
                .filter(folder -> RunLayout.parametersIn(folder).isPresent())
                .findFirst();
    }

    /** The file of the run's parameters. */
    public Optional<Path> parametersFile() {
        return runFolder.flatMap(RunLayout::parametersIn);
    }

    /**
     * A name for messages and headings. It is {@link #name}, except for the champion of a run whose folder is named by
     * method and number, if that can be read in two ways: MT20 is run 20 of MT or run 0 of MT2, H111 is run 1 of H11 or
     * run 11 of H1. Then it is, for example, "H11, run 1".
     */
    public String label() {
        String number = parameters.getOrDefault("runNumber", "");
        return PublishedTask.method(parameters)
                .filter(method -> method.matches("MT|.*\\d") && name().equals(method + number))
                .map(method -> method + ", run " + number)
                .orElseGet(this::name);
    }

    /** A name for file names: the folder or file it was read from. */
    public String name() {
        Path folder = Objects.requireNonNull(file.toAbsolutePath().normalize().getParent());
        String fileName = file.getFileName().toString();
        boolean original = RunLayout.isNamedAsOriginalChampion(file);
        return original || fileName.startsWith(RunLayout.CHAMPION)
                ? String.valueOf(Objects.requireNonNull(original ? folder.getParent() : folder)
                        .getFileName())
                : fileName.replaceFirst("\\.(json|xml)$", "");
    }
}
