package mmneat.analysis.evaluation;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import mmneat.analysis.results.RunParameters;
import mmneat.experiment.FileErrors;
import mmneat.experiment.UserError;
import mmneat.experiment.store.RunLayout;
import mmneat.experiment.store.SymbolicLinks;
import mmneat.neat.Genotype;
import mmneat.neat.io.GenotypeFiles;
import mmneat.neat.io.GenotypeFormatException;

/**
 * A network to evaluate or to watch, and what is known of the run that it is from.
 *
 * @param genotype the network
 * @param file where it was read
 * @param runFolder the folder of its run; empty if the file stands alone
 * @param parameters the parameters of its run; empty if the file stands alone
 * @param jar the jar or folder of classes that the user named for the classes in the run's parameters; empty: those classes are
 *     not loaded, as a run's folder may come from someone else
 */
public record Champion(
        Genotype genotype, Path file, Optional<Path> runFolder, Map<String, String> parameters, Optional<Path> jar) {

    /** A network whose run's own classes may not be loaded. */
    public Champion(Genotype genotype, Path file, Optional<Path> runFolder, Map<String, String> parameters) {
        this(genotype, file, runFolder, parameters, Optional.empty());
    }

    /** The same with a jar for the classes that its run's parameters name. */
    public Champion withJar(Optional<Path> named) {
        return new Champion(genotype, file, runFolder, parameters, named);
    }

    /** Whether a folder of a run holds its champion. */
    public static boolean isIn(Path folder) {
        return RunLayout.championIn(folder).isPresent();
    }

    /**
     * Reads the champion of a run's folder, or a genotype file, ours or the original's.
     *
     * @throws UserError if there is none
     */
    public static Champion read(Path path) {
        if (Files.isDirectory(path)) {
            SymbolicLinks.refuseIn(path);
        }
        Path file = Files.isDirectory(path)
                ? RunLayout.championIn(path)
                        .orElseThrow(() -> new UserError(path + ": there is no champion in this folder ("
                                + RunLayout.CHAMPION + " or " + RunLayout.ORIGINAL_CHAMPION + ")"))
                : path;
        if (!Files.exists(file)) {
            throw new UserError(file + ": there is no such file; give a run's folder or the file of a network");
        }
        try {
            Optional<Path> folder = runFolder(file);
            folder.ifPresent(SymbolicLinks::refuseIn);
            return new Champion(GenotypeFiles.read(file), file, folder, RunParameters.read(folder));
        } catch (GenotypeFormatException e) {
            throw new UserError(e.getMessage(), e);
        } catch (IOException e) {
            throw new UserError(file + ": cannot be read: " + FileErrors.reason(e), e);
        }
    }

    /** The file's folder or the one above it, whichever has parameters; networks of generations stand in folders of a run. */
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

    /** A name for headings: the folder and file it was read from. */
    public String name() {
        Path folder = file.toAbsolutePath().normalize().getParent();
        String fileName = file.getFileName().toString();
        boolean original = RunLayout.isNamedAsOriginalChampion(file);
        return original || fileName.startsWith(RunLayout.CHAMPION)
                ? String.valueOf((original ? folder.getParent() : folder).getFileName())
                : fileName.replaceFirst("\\.(json|xml)$", "");
    }
}
