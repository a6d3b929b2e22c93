package mmneat.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import mmneat.experiment.UserError;
import mmneat.mspacman.NetworkPacMan;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.modules.ModuleDivisions;
import mmneat.neat.Genotype;
import mmneat.neat.io.GenotypeFiles;
import mmneat.neat.io.GenotypeFormatException;
import pacman.controllers.Controller;
import pacman.game.Constants.MOVE;

/** Ms. Pac-Man's controller from a file with an evolved network. */
final class NetworkPlayer {

    private NetworkPlayer() {}

    /** Whether a name means a network's file and not a class. */
    static boolean isFile(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        return lower.endsWith(".json") || lower.endsWith(".xml");
    }

    /**
     * Makes controllers with the network of a file.
     *
     * @param division of a multitask network, if the user says one
     * @throws UserError if the file holds no network, or one that does not play Ms. Pac-Man
     */
    static Supplier<Controller<MOVE>> read(String file, Optional<String> division, long seed) {
        try {
            Genotype genotype = GenotypeFiles.read(Path.of(file));
            ModuleDivision ofTask = division.map(ModuleDivisions::named).orElse(null);
            Supplier<Controller<MOVE>> players = () -> NetworkPacMan.published(genotype, ofTask, seed);
            // A network that does not fit is found before the first game.
            players.get();
            return players;
        } catch (GenotypeFormatException e) {
            throw new UserError("pacman: " + e.getMessage(), e);
        } catch (IOException e) {
            throw new UserError("pacman: cannot read " + file + ": " + GameWords.reason(e), e);
        } catch (IllegalArgumentException e) {
            throw new UserError("pacman=" + file + ": " + e.getMessage(), e);
        }
    }
}
