package mmneat.analysis.results;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import mmneat.experiment.store.RunLayout;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.neat.io.GenotypeJson;
import mmneat.neat.variation.InitialNetworks;
import mmneat.random.ResumableRandom;

/** Writes folders of runs as a finished experiment leaves them, with made-up scores. */
public final class RunFixture {

    private RunFixture() {}

    /** A run {@code <base>/<version>/<method><number>} with the given champion scores, one per generation. */
    public static Path run(Path base, String version, String method, int number, double... scores) throws IOException {
        Path folder = Files.createDirectories(base.resolve(version).resolve(method + number));
        StringBuilder log = new StringBuilder();
        for (int generation = 0; generation < scores.length; generation++) {
            log.append(generation)
                    .append("\t0.0".repeat(10))
                    .append('\t')
                    .append(scores[generation])
                    .append("\t0.0\t\n");
        }
        Files.writeString(folder.resolve(version + "-" + method + number + "_parents_log.txt"), log);
        String modules =
                switch (method) {
                    case "2M", "3M" -> "startingModes=" + method.charAt(0);
                    case "MT", "MT2" -> "multitaskModes=2";
                    case "MT3" -> "multitaskModes=3";
                    case "MMD" -> "mmdRate=0.1";
                    default -> "startingModes=1";
                };
        Files.writeString(
                folder.resolve("parameters.properties"),
                "task=" + version + "\nrunNumber=" + number + "\nmu=100\nmaxGens=" + (scores.length - 1)
                        + "\ntrials=10\n" + modules + "\n");
        return folder;
    }

    /** Adds a champion of 30 inputs, as new networks are: number 0, the one that {@link #evaluation} tells of. */
    public static Path champion(Path folder, ModuleLayout layout, long seed) throws IOException {
        Genotype champion = new InitialNetworks(30, layout).create(0, new ResumableRandom(seed));
        return Files.writeString(folder.resolve("champion.json"), GenotypeJson.write(champion));
    }

    /** Adds the evaluation of the run's champion. */
    public static void evaluation(Path folder, double score, long... moduleUse) throws IOException {
        ChampionEvaluation evaluation = new ChampionEvaluation(
                0, "training", 1000, 0L, score, 500.0, score - 30, score + 30, List.of(moduleUse), new long[] {
                    600, 300, 80, 20
                });
        new ObjectMapper()
                .writeValue(
                        folder.resolve(RunLayout.evaluationSummary("training")).toFile(), evaluation);
    }
}
