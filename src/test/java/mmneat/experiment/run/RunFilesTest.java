package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Stream;
import mmneat.evolution.Evolution;
import mmneat.evolution.EvolutionObserver;
import mmneat.evolution.EvolutionSettings;
import mmneat.evolution.EvolutionState;
import mmneat.evolution.Generation;
import mmneat.evolution.SchafferTask;
import mmneat.evolution.SequentialEvaluator;
import mmneat.evolution.Task;
import mmneat.experiment.original.RunFiles;
import mmneat.experiment.store.RunFolder;
import mmneat.neat.ModuleLayout;
import mmneat.neat.io.GenotypeXml;
import mmneat.neat.variation.InitialNetworks;
import mmneat.neat.variation.MutationRates;
import mmneat.neat.variation.VariationSettings;
import mmneat.nsga2.Crowding;
import mmneat.nsga2.ParentSelection;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The files that a run writes: their names, and their contents compared with recorded checksums. */
class RunFilesTest {

    private static final String PREFIX = "Schaffer0_";
    private static final int GENERATIONS = 3;
    private static final int MU = 4;

    @TempDir
    Path directory;

    @Test
    void smallRun_writesTheRecordedFiles() throws IOException, URISyntaxException {
        evolve(EnumSet.allOf(RunFiles.Choice.class));
        Path recorded = Path.of(RunFilesTest.class.getResource("schaffer-run").toURI());
        try (Stream<Path> files = Files.walk(recorded)) {
            List<Path> expected = files.filter(Files::isRegularFile).toList();
            assertThat(expected).hasSizeGreaterThan(25);
            for (Path file : expected) {
                assertThat(directory.resolve(recorded.relativize(file).toString()))
                        .hasSameBinaryContentAs(file);
            }
        }
    }

    @Test
    void oldNetworks_areDeleted_ifOnlyTheNewestAreWanted() throws IOException {
        evolve(Set.of(RunFiles.Choice.NETWORKS, RunFiles.Choice.MODULE_COUNTS, RunFiles.Choice.NEWEST_NETWORKS_ONLY));
        assertThat(folders()).containsExactly("bestObjectives", "bestPacMan", "gen3");
        List<Path> networks = list(directory.resolve("gen3"));
        assertThat(networks).hasSize(MU);
        for (Path network : networks) {
            assertThat(GenotypeXml.read(Files.readString(network)).inputs()).isEqualTo(1);
        }
    }

    @Test
    void oldNetworks_areKept_ifAllAreWanted() throws IOException {
        evolve(Set.of(RunFiles.Choice.NETWORKS, RunFiles.Choice.MODULE_COUNTS));
        assertThat(folders()).containsExactly("bestObjectives", "bestPacMan", "gen1", "gen2", "gen3", "initial");
        assertThat(list(directory.resolve("initial")))
                .extracting(file -> file.getFileName().toString())
                .containsExactly(
                        PREFIX + "initial_0.xml",
                        PREFIX + "initial_1.xml",
                        PREFIX + "initial_2.xml",
                        PREFIX + "initial_3.xml");
    }

    @Test
    void fileOfShadows_isWrittenOnlyIfThereAreAny() throws IOException {
        Set<RunFiles.Choice> networks =
                Set.of(RunFiles.Choice.NETWORKS, RunFiles.Choice.MODULE_COUNTS, RunFiles.Choice.NEWEST_NETWORKS_ONLY);
        // Only networks of one module get shadows.
        evolve(networks, ModuleLayout.withPreferenceNeurons(2, 1));
        assertThat(directory.resolve("combiningCrossoverMapping.txt")).doesNotExist();
        evolve(networks);
        assertThat(directory.resolve("combiningCrossoverMapping.txt")).isNotEmptyFile();
    }

    @Test
    void withoutNetworks_onlyLogsAreWritten_andViceVersa() throws IOException {
        evolve(Set.of(RunFiles.Choice.LOGS, RunFiles.Choice.NEWEST_NETWORKS_ONLY));
        assertThat(folders()).isEmpty();
        assertThat(list(directory))
                .isNotEmpty()
                .extracting(file -> file.getFileName().toString())
                .allMatch(name -> name.startsWith(PREFIX))
                .noneMatch(name -> name.contains("ModeUsage"));
    }

    @Test
    void nothingWanted_nothingWritten() throws IOException {
        evolve(Set.of(RunFiles.Choice.MODULE_COUNTS, RunFiles.Choice.NEWEST_NETWORKS_ONLY));
        assertThat(list(directory)).isEmpty();
    }

    private void evolve(Set<RunFiles.Choice> choice) {
        evolve(choice, new ModuleLayout(2, 1, 1, false));
    }

    private void evolve(Set<RunFiles.Choice> choice, ModuleLayout layout) {
        Task task = new SchafferTask();
        EvolutionSettings settings = new EvolutionSettings(
                5,
                OptionalInt.empty(),
                MU,
                GENERATIONS,
                2,
                new InitialNetworks(task.inputs(), layout),
                new ParentSelection(true, 0.5, Crowding.WHOLE_POPULATION),
                new VariationSettings(MutationRates.PUBLISHED.withModuleDuplication(0.3)));
        RunFolder folder = new RunFolder(directory, PREFIX);
        RunFiles files = new RunFiles(folder, task, choice);
        EvolutionState initial = EvolutionState.initial(settings);
        files.begin(initial);
        EvolutionObserver observer = new EvolutionObserver() {
            @Override
            public void generationCompleted(Generation generation, EvolutionState next) {
                files.generationCompleted(generation, next);
                if (next.generation() == GENERATIONS) {
                    files.writeNewestNetworks(next);
                }
            }

            @Override
            public void completed(Generation finalParents) {
                files.completed(finalParents);
            }
        };
        new Evolution(settings, initial, new SequentialEvaluator(task), observer).run();
        folder.flush();
    }

    private List<String> folders() throws IOException {
        return list(directory).stream()
                .filter(Files::isDirectory)
                .map(folder -> folder.getFileName().toString())
                .toList();
    }

    private static List<Path> list(Path folder) throws IOException {
        try (Stream<Path> entries = Files.list(folder)) {
            return entries.sorted().toList();
        }
    }
}
