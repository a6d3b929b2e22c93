package mmneat.experiment.original;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.stream.Stream;
import mmneat.evolution.Evaluation;
import mmneat.evolution.EvolutionObserver;
import mmneat.evolution.EvolutionState;
import mmneat.evolution.Generation;
import mmneat.evolution.Individual;
import mmneat.evolution.Task;
import mmneat.experiment.store.RunFolder;
import mmneat.experiment.store.RunLayout;
import mmneat.neat.Genotype;
import mmneat.neat.io.GenotypeXml;

/**
 * The observer that writes the original's files into a run's folder: score files, logs, gnuplot scripts, champions,
 * networks and archetype.
 *
 * <p>All files of a generation are written at its end. An interrupted generation is evolved again, with the same files.
 *
 * <p>The files of networks are an exception if only the newest are wanted ({@link Choice#NEWEST_NETWORKS_ONLY}). The
 * next generation would delete them, so {@link #generationCompleted} does not write them. The caller has them written
 * by {@link #writeNewestNetworks}. Nothing is lost if the program ends before: they can be computed again from the
 * checkpoint.
 *
 * <p>The archetype is the population-wide list of neurons, which fixes their order in every genotype.
 *
 * <p>Source: docs/specification/evolution.md, section 5.
 */
public final class RunFiles implements EvolutionObserver {

    private final RunFolder folder;
    private final Task task;
    private final Set<Choice> choices;

    private final PopulationLog parentsLog;
    private final PopulationLog childLog;
    private final PopulationLog networksLog;
    private final PopulationLog performanceLog;

    /** A group of files to write, or a restriction. The parameter that decides on it is named in parentheses. */
    public enum Choice {
        /** Score files, logs and gnuplot scripts ({@code io}). */
        LOGS,
        /** Networks, archetype and champions ({@code netio}). */
        NETWORKS,
        /** The log of module counts, for networks that may have several modules (no parameter). */
        MODULE_COUNTS,
        /** Only the networks of the newest generation are kept ({@code cleanOldNetworks}). */
        NEWEST_NETWORKS_ONLY
    }

    /** Creates the writer of a run's files. */
    public RunFiles(RunFolder folder, Task task, Set<Choice> choices) {
        this.folder = folder;
        this.task = task;
        this.choices = Set.copyOf(choices);
        List<String> scores = new ArrayList<>(task.objectiveNames());
        scores.addAll(task.otherScoreNames());
        parentsLog = new PopulationLog(RunLayout.PARENTS, scores);
        childLog = new PopulationLog(RunLayout.CHILDREN, scores);
        networksLog = new PopulationLog(RunLayout.NETWORKS, NetworkProperties.labels(task.inputLabels()));
        performanceLog = new PopulationLog(RunLayout.PERFORMANCE, EvaluationCosts.LABELS);
    }

    /** Writes the files of a new run before its first generation: scripts, initial networks, archetype. */
    public void begin(EvolutionState initial) {
        if (choices.contains(Choice.LOGS)) {
            String prefix = folder.prefix();
            for (PopulationLog log : List.of(parentsLog, childLog, networksLog, performanceLog)) {
                folder.write(log.plotFile(prefix), log.plotScript(prefix));
            }
            if (choices.contains(Choice.MODULE_COUNTS)) {
                folder.write(ModuleCountLog.plotFile(prefix), ModuleCountLog.plotScript(prefix));
            }
            if (initial.tug() != null) {
                folder.write(TugLog.plotFile(prefix), TugLog.plotScript(prefix, parentsLog.labels()));
            }
        }
        writeNewestNetworks(initial);
    }

    /**
     * Writes the networks of the population of this state and the archetype. If only the newest networks are wanted,
     * the folders of networks of other generations are deleted; the archetype is one file, which is replaced.
     *
     * <p>If only the newest networks are wanted, the caller must call this after the last generation, and may call it
     * after any other one. Otherwise {@link #generationCompleted} has already written the same files, and a call does
     * no harm.
     *
     * @param next the state after a completed generation: its population are the parents of the next generation,
     *     whether or not that is evolved
     */
    public void writeNewestNetworks(EvolutionState next) {
        if (!choices.contains(Choice.NETWORKS)) {
            return;
        }
        writeNetworks(next);
        if (choices.contains(Choice.NEWEST_NETWORKS_ONLY)) {
            String newest = RunLayout.networksFolder(next.generation());
            folder.folders().stream()
                    .filter(name -> RunLayout.isNetworksFolder(name) && !name.equals(newest))
                    .forEach(folder::deleteFolder);
        }
    }

    @Override
    public void generationCompleted(Generation generation, EvolutionState next) {
        if (choices.contains(Choice.LOGS)) {
            writeScores(RunLayout.CHILDREN, generation.number(), generation.children());
            log(childLog, generation.number(), scores(generation.children()));
            logParents(generation);
            List<Individual> all = Stream.concat(generation.parents().stream(), generation.children().stream())
                    .toList();
            log(performanceLog, generation.number(), EvaluationCosts.of(all, task.trials()));
            logOffspring(generation);
            generation
                    .tug()
                    .ifPresent(
                            step -> folder.append(TugLog.file(folder.prefix()), TugLog.row(generation.number(), step)));
        }
        if (choices.contains(Choice.NETWORKS)) {
            writeChampion(generation.champion(task));
            writeBestInObjectives(generation.children());
            writeShadows(next);
            if (!choices.contains(Choice.NEWEST_NETWORKS_ONLY)) {
                writeNetworks(next);
            }
        }
    }

    @Override
    public void completed(Generation finalParents) {
        if (choices.contains(Choice.LOGS)) {
            logParents(finalParents);
        }
        if (choices.contains(Choice.NETWORKS)) {
            // Quirk of the original: the champion remains that of the last generation with children.
            writeBestInObjectives(finalParents.parents());
        }
    }

    private void logParents(Generation generation) {
        int number = generation.number();
        List<Individual> parents = generation.parents();
        writeScores(RunLayout.PARENTS, number, parents);
        log(parentsLog, number, scores(parents));
        log(networksLog, number, networks(parents, generation.archetypeSize()));
        if (choices.contains(Choice.MODULE_COUNTS)) {
            folder.append(ModuleCountLog.file(folder.prefix()), ModuleCountLog.row(number, parents));
        }
    }

    private void logOffspring(Generation generation) {
        String prefix = folder.prefix();
        folder.append(
                OffspringLogs.mutationsFile(prefix),
                OffspringLogs.mutations(generation.number(), generation.offspring()));
        folder.append(
                OffspringLogs.lineageFile(prefix), OffspringLogs.lineage(generation.number(), generation.offspring()));
    }

    private void writeScores(String population, int generation, List<Individual> individuals) {
        String prefix = folder.prefix();
        folder.write(
                RunLayout.scores(prefix, population, generation), ScoreTables.of(individuals, Evaluation::objectives));
        folder.write(
                RunLayout.otherScores(prefix, population, generation),
                ScoreTables.of(individuals, Evaluation::otherScores));
    }

    private void log(PopulationLog log, int generation, List<double[]> population) {
        folder.append(log.file(folder.prefix()), log.row(generation, population));
    }

    private static List<double[]> scores(List<Individual> individuals) {
        return individuals.stream()
                .map(Individual::evaluation)
                .map(evaluation -> Stream.of(evaluation.objectives(), evaluation.otherScores())
                        .flatMapToDouble(Arrays::stream)
                        .toArray())
                .toList();
    }

    private static List<double[]> networks(List<Individual> individuals, int archetypeSize) {
        return individuals.stream()
                .map(individual -> NetworkProperties.of(individual.genotype(), archetypeSize))
                .toList();
    }

    private void writeChampion(Individual champion) {
        writeGenotype(RunLayout.ORIGINAL_CHAMPION, champion.genotype());
        folder.write(RunLayout.ORIGINAL_CHAMPION_SCORE, ScoreTables.line(champion));
    }

    private void writeBestInObjectives(List<Individual> population) {
        for (int objective = 0; objective < task.objectiveNames().size(); objective++) {
            Individual best = Generation.bestIn(population, objective);
            writeGenotype(RunLayout.bestIn(objective), best.genotype());
            folder.write(RunLayout.scoresOfBestIn(objective), ScoreTables.line(best));
        }
    }

    private void writeGenotype(String name, Genotype genotype) {
        folder.write(name, () -> GenotypeXml.write(genotype).getBytes(StandardCharsets.UTF_8));
    }

    private void writeNetworks(EvolutionState state) {
        int index = 0;
        for (Genotype genotype : state.population()) {
            String file = RunLayout.network(folder.prefix(), state.generation(), index++);
            if (choices.contains(Choice.NEWEST_NETWORKS_ONLY)) {
                folder.writeDerived(file, GenotypeXml.write(genotype));
            } else {
                // The networks of earlier generations are not in the checkpoint.
                writeGenotype(file, genotype);
            }
        }
        folder.writeDerived(
                RunLayout.ARCHETYPE,
                GenotypeXml.writeArchetype(state.pool().archetype().entries()));
    }

    /** Writes the shadow entries. If there are none, an existing file stays unchanged, as in the original. */
    private void writeShadows(EvolutionState state) {
        SortedMap<Long, Long> shadows = state.pool().archetype().shadows();
        if (!shadows.isEmpty()) {
            folder.write(RunLayout.CROSSOVER_MAPPING, shadowLines(shadows));
        }
    }

    private static String shadowLines(SortedMap<Long, Long> shadows) {
        StringBuilder lines = new StringBuilder();
        shadows.forEach((neuron, shadow) ->
                lines.append(neuron).append(' ').append(shadow).append('\n'));
        return lines.toString();
    }
}
