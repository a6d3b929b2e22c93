package mmneat.mspacman;

import java.io.IOException;
import java.io.StringReader;
import java.util.ArrayList;
import java.util.List;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.neat.GenePool;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.variation.InitialNetworks;
import mmneat.neat.variation.MutationRates;
import mmneat.neat.variation.Reproduction;
import mmneat.neat.variation.VariationSettings;
import mmneat.random.ResumableRandom;
import pacman.game.GhostLocations;
import pacman.maze.MazeGraph;
import pacman.maze.Mazes;

/** Networks and tasks for measuring whole evaluations. */
final class EvaluationWorkload {

    private static final ModuleLayout TWO_MODULES = new ModuleLayout(4, 2, 1, false);

    private EvaluationWorkload() {}

    static MsPacManTask task(TaskVersion version) {
        return new MsPacManTask(settings(version));
    }

    /** The task with separate sensors for threats and for edible ghosts. */
    static MsPacManTask splitTask(TaskVersion version) {
        return new MsPacManTask(
                settings(version).withNetworks(networks -> networks.withSensors(SensorSettings.split())));
    }

    private static MsPacManTaskSettings settings(TaskVersion version) {
        return switch (version) {
            case BLENDED -> MsPacManTaskSettings.blended();
            case INTERLEAVED -> MsPacManTaskSettings.interleaved();
            case ISOLATED -> MsPacManTaskSettings.isolated(anyGhostLocations());
        };
    }

    /** Creates networks of two modules by a number of mutations, as in an early generation. */
    static List<Genotype> mutated(int inputs, int count, int mutations) {
        ResumableRandom random = new ResumableRandom(1);
        List<Genotype> networks = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Genotype network = new InitialNetworks(inputs, TWO_MODULES).create(i, random);
            Reproduction reproduction =
                    new Reproduction(new VariationSettings(MutationRates.PUBLISHED), GenePool.foundedOn(network));
            for (int m = 0; m < mutations; m++) {
                network = reproduction.fromOne(network, random).genotype();
            }
            networks.add(network);
        }
        return networks;
    }

    /** Networks of the size of a champion: 25 hidden neurons and at least 180 links. */
    static List<Genotype> grown(int inputs, int count) {
        ResumableRandom random = new ResumableRandom(2);
        MutationRates growing = MutationRates.PUBLISHED;
        List<Genotype> networks = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Genotype network = new InitialNetworks(inputs, TWO_MODULES).create(i, random);
            Reproduction reproduction = new Reproduction(new VariationSettings(growing), GenePool.foundedOn(network));
            while (network.hidden() < 25 || activeLinks(network) < 180) {
                Genotype next = reproduction.fromOne(network, random).genotype();
                network = next.hidden() <= 25 ? next : network;
            }
            networks.add(network);
        }
        return networks;
    }

    private static long activeLinks(Genotype network) {
        return network.links().stream().filter(LinkGene::active).count();
    }

    /** Returns random ghost locations, because a recording would be data of an experiment. */
    private static GhostLocations anyGhostLocations() {
        ResumableRandom random = new ResumableRandom(3);
        StringBuilder text = new StringBuilder();
        for (int maze = 0; maze < 4; maze++) {
            MazeGraph graph = Mazes.standard().get(maze).graph();
            for (int line = 0; line < 4 * GhostLocations.SITUATIONS; line++) {
                text.append(maze).append('\t').append(line % 4);
                for (int ghost = 0; ghost < 4; ghost++) {
                    text.append('\t').append(random.nextInt(graph.lair()));
                }
                text.append('\n');
            }
        }
        try {
            return GhostLocations.read("random locations", new StringReader(text.toString()));
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
