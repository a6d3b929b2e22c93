package mmneat.mspacman;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import mmneat.evolution.Evaluation;
import mmneat.random.ResumableRandom;
import pacman.game.GhostLocations;

/** The recorded evaluations of the isolated version, replayed with given ghost locations. */
public final class GoldenEvaluations {

    private GoldenEvaluations() {}

    /** The names of the recorded evaluations of the isolated version. */
    public static List<String> isolated() throws IOException {
        return GoldenEvaluation.all().stream()
                .filter(evaluation -> evaluation.json().get("version").asText().equals("isolated"))
                .map(GoldenEvaluation::name)
                .toList();
    }

    /** Whether an evaluation has the recorded scores, module usage and number of random draws. */
    public static boolean isTheOriginals(String name, GhostLocations locations) {
        try {
            GoldenEvaluation golden = GoldenEvaluation.named(name);
            MsPacManTask task = new MsPacManTask(golden.settings(locations));
            ResumableRandom random = new ResumableRandom(golden.globalSeed());
            Evaluation evaluation = task.evaluate(golden.genotype(), random);
            return Arrays.equals(evaluation.objectives(), golden.doubles("objectives"))
                    && Arrays.equals(evaluation.otherScores(), golden.doubles("other"))
                    && Arrays.equals(evaluation.moduleUsage(), golden.ints("genotypeModuleUsage"))
                    && random.nextLong()
                            == golden.json().get("nextLongAfterwards").asLong();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
