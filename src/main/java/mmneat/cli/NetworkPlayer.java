package mmneat.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.PlayerSettings;
import mmneat.analysis.evaluation.Rules;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.cli.options.JarOption;
import mmneat.cli.options.OptionValues;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.Tasks;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.NetworkPacMan;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.modules.ModuleDivisions;
import org.jspecify.annotations.Nullable;
import pacman.controllers.Controller;
import pacman.game.Constants.MOVE;

/** Loads Ms. Pac-Man's controllers with an evolved network: a run's champion, a file, or a shipped champion. */
final class NetworkPlayer {

    /** Prefix that marks the name of a shipped champion. */
    static final String SHIPPED = "champion:";

    private NetworkPlayer() {}

    /** Whether a name means a network and not a class. */
    static boolean isNetwork(String name) {
        String lower = name.toLowerCase(Locale.ROOT);
        return isShipped(name) || lower.endsWith(".json") || lower.endsWith(".xml") || isFolder(name);
    }

    /** The file or folder that a name means; empty if it means a class or a shipped champion. */
    static Optional<Path> file(String name) {
        return isNetwork(name) && !isShipped(name) ? Optional.of(Path.of(name)) : Optional.empty();
    }

    private static boolean isShipped(String name) {
        return name.toLowerCase(Locale.ROOT).startsWith(SHIPPED);
    }

    /**
     * Whether a name means a folder, which need not exist. A name without a slash may also be a class whose package is
     * a folder in the working folder.
     */
    private static boolean isFolder(String name) {
        Path folder = Path.of(name);
        return folder.getNameCount() > 1
                || Files.isDirectory(folder)
                        && (Champion.isIn(folder) || Champion.runIn(folder).isPresent());
    }

    private static Champion champion(String name) {
        if (!isShipped(name)) {
            return Champion.read(Path.of(name));
        }
        String champion = name.substring(SHIPPED.length());
        if (!ShippedChampions.names().contains(champion)) {
            throw OptionValues.badValue(
                    "pacman", name, SHIPPED + " and one of " + String.join(", ", ShippedChampions.names()));
        }
        return ShippedChampions.read(champion);
    }

    /**
     * Returns a factory of controllers with a network. The parameters of a run determine the sensors and module choice
     * of its networks. Other networks use those of the published networks with the same number of inputs.
     *
     * @param name a run's folder, a file, or {@link #SHIPPED} and the name of a champion
     * @param division the division of a multitask network, if the user gives one
     * @param jar the jar of the classes that the parameters of the network's run name
     * @throws UserError if there is no network, or it does not play Ms. Pac-Man
     */
    static Supplier<Controller<MOVE>> read(String name, Optional<String> division, long seed, JarOption jar) {
        Champion champion = jar.allow(champion(name));
        champion.requireActivation();
        if (division.isPresent() && !champion.genotype().layout().isDivided()) {
            throw new UserError("division=" + division.get() + ": the network of " + name
                    + " chooses its modules itself; only methods MT, MT2 and MT3 and hybrids have a division");
        }
        try {
            ModuleDivision asked = division.map(ModuleDivisions::named).orElse(null);
            Supplier<Controller<MOVE>> players = players(champion, asked, seed);
            // This detects a network that does not fit before the first game.
            players.get();
            return players;
        } catch (IllegalArgumentException e) {
            throw new UserError("pacman=" + name + ": " + e.getMessage(), e);
        }
    }

    private static Supplier<Controller<MOVE>> players(Champion champion, @Nullable ModuleDivision division, long seed) {
        if (champion.parametersFile().isEmpty()) {
            return () -> NetworkPacMan.published(champion.genotype(), division, seed);
        }
        // Full games need no recorded ghost locations.
        MsPacManTaskSettings task =
                PlayerSettings.of(champion, Optional.empty(), Rules.TRAINING, Optional.of(Tasks.SHIPPED_LOCATIONS));
        return () -> NetworkPacMan.of(task, champion.genotype(), division, seed);
    }
}
