package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import mmneat.evolution.EvolutionState;
import mmneat.evolution.XorTask;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.store.SavedCheckpoint;
import mmneat.neat.Archetype;
import mmneat.neat.NodeGene;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A run in which the archetype is cleaned several times. The run is stopped and continued after every generation,
 * including those just before and just after a cleaning. Source: docs/specification/evolution.md, section 3.3.
 */
class ArchetypeCleaningRunTest {

    private static final int GENERATIONS = 21;
    private static final int CLEANED_EVERY = 5;

    @TempDir
    Path folder;

    @Test
    void cleanedArchetype_holdsUsedEntries_andARunStoppedAroundCleaningsContinuesExactly() throws Exception {
        run("whole", GENERATIONS);
        Archetype.State before = null;
        int removed = 0;
        int shadowsSeen = 0;
        for (int generation = 1; generation <= GENERATIONS; generation++) {
            run("stopped", generation);
            EvolutionState state = state();
            Archetype.State archetype = state.pool().archetype();
            assertThat(state.generation()).isEqualTo(generation);
            assertThat(innovations(archetype)).doesNotHaveDuplicates().containsAll(used(state));
            if (generation % CLEANED_EVERY == 0) {
                requireClean(archetype, used(state));
                Set<Long> gone = new HashSet<>(innovations(before));
                gone.removeAll(innovations(archetype));
                removed += gone.size();
            } else if (before != null) {
                assertThat(innovations(archetype)).containsSubsequence(innovations(before));
            }
            shadowsSeen += archetype.shadows().size();
            before = archetype;
        }
        assertThat(removed).as("entries that were cleaned away").isPositive();
        assertThat(shadowsSeen).as("shadow entries").isPositive();
        assertThat(ExperimentRunnerTest.content(folder.resolve("stopped/MMD0")))
                .isEqualTo(ExperimentRunnerTest.content(folder.resolve("whole/MMD0")));
    }

    /** Checks that every unused entry is a shadow whose neuron still exists. */
    private static void requireClean(Archetype.State archetype, Set<Long> used) {
        List<Long> present = innovations(archetype);
        Map<Long, Long> neurons = archetype.shadows().entrySet().stream()
                .collect(Collectors.toMap(Map.Entry::getValue, Map.Entry::getKey));
        for (long innovation : present) {
            if (!used.contains(innovation)) {
                assertThat(neurons).containsKey(innovation);
                assertThat(present).contains(neurons.get(innovation));
            }
        }
        assertThat(present).containsAll(archetype.shadows().keySet());
    }

    private static List<Long> innovations(Archetype.State archetype) {
        return archetype.entries().stream().map(NodeGene::innovation).toList();
    }

    private static Set<Long> used(EvolutionState state) {
        return state.population().stream()
                .flatMap(genotype -> genotype.nodes().stream())
                .map(NodeGene::innovation)
                .collect(Collectors.toSet());
    }

    private EvolutionState state() throws Exception {
        return SavedCheckpoint.newest(folder.resolve("stopped/MMD0")).evolution();
    }

    private void run(String base, int generations) throws InterruptedException {
        List<String> words = new ArrayList<>(List.of(
                "task=" + XorTask.class.getName(),
                "method=MMD",
                "mating=true",
                "mu=8",
                "netSpliceRate=0.5",
                "cleanFrequency=" + CLEANED_EVERY,
                "maxGens=" + generations,
                "base=" + folder.resolve(base)));
        ParameterReader reader = new ParameterReader(ParameterCatalogue.load());
        ExperimentPlan plan = ExperimentPlan.of(reader.read(words).parameters());
        assertThat(new ExperimentRunner(plan).run()).allMatch(RunOutcome::isComplete);
    }
}
