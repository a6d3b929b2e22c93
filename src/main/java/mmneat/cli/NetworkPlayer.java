package mmneat.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.experiment.FileTrouble;
import mmneat.experiment.UserError;
import mmneat.mspacman.NetworkPacMan;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.modules.ModuleDivisions;
import mmneat.neat.Genotype;
import mmneat.neat.io.GenotypeFiles;
import mmneat.neat.io.GenotypeFormatException;
import pacman.controllers.Controller;
import pacman.game.Constants.MOVE;

/** Ms. Pac-Man's controller from a file with an evolved network, or from a network that comes with the program. */
final class NetworkPlayer {

    /** A champion that comes with the program is named by this and its version. */
    static final String SHIPPED = "champion:";

    private NetworkPlayer() {}

    /** Whether a name means a network and not a class. */
    static boolean isNetwork(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        return lower.startsWith(SHIPPED) || lower.endsWith(".json") || lower.endsWith(".xml");
    }

    private static Genotype genotype(String name) throws IOException {
        if (!name.toLowerCase(Locale.ROOT).startsWith(SHIPPED)) {
            return GenotypeFiles.read(Path.of(name));
        }
        String version = name.substring(SHIPPED.length());
        if (!ShippedChampions.versions().contains(version)) {
            throw Words.badValue(
                    "pacman", name, SHIPPED + " and one of " + String.join(", ", ShippedChampions.versions()));
        }
        return ShippedChampions.read(version).genotype();
    }

    /**
     * Makes controllers with the network of a file, or with one that comes with the program.
     *
     * @param division of a multitask network, if the user says one
     * @throws UserError if the file holds no network, or one that does not play Ms. Pac-Man
     */
    static Supplier<Controller<MOVE>> read(String file, Optional<String> division, long seed) {
        try {
            Genotype genotype = genotype(file);
            ModuleDivision ofTask = division.map(ModuleDivisions::named).orElse(null);
            Supplier<Controller<MOVE>> players = () -> NetworkPacMan.published(genotype, ofTask, seed);
            // A network that does not fit is found before the first game.
            players.get();
            return players;
        } catch (GenotypeFormatException e) {
            throw new UserError("pacman: " + e.getMessage(), e);
        } catch (IOException e) {
            throw new UserError("pacman: cannot read " + file + ": " + FileTrouble.reason(e), e);
        } catch (IllegalArgumentException e) {
            throw new UserError("pacman=" + file + ": " + e.getMessage(), e);
        }
    }
}
