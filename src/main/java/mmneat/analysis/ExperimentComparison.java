package mmneat.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.PublishedResults;
import mmneat.analysis.results.RunResult;
import mmneat.analysis.statistics.ComparisonReport;
import mmneat.analysis.statistics.Sample;
import mmneat.experiment.UserError;

/**
 * The statistics of several experiments' champions, in one version of the task: scores of different versions mean different things.
 *
 * @param version of the task; empty for a task of the user's own
 * @param evaluated whether the scores are those of the evaluation after evolution; if not, of the last generation
 * @param report the tables
 * @param notes what a reader should know about the numbers
 */
public record ExperimentComparison(String version, boolean evaluated, ComparisonReport report, List<String> notes) {

    /** Where the champions' scores come from. */
    public enum Scores {
        /** The evaluations if all runs have one, else the last generation. */
        AUTO,
        /** The evaluations after evolution. */
        EVALUATION,
        /** The last generation: few games, and the best of them, so too high. */
        TRAINING
    }

    public ExperimentComparison {
        notes = List.copyOf(notes);
    }

    /**
     * Compares the experiments of each version of the task.
     *
     * @param paper whether the paper's champions stand beside ours
     * @return one comparison per version, in the order of the experiments
     * @throws UserError if the evaluations are wanted but not all there, or the paper has none of the experiments
     */
    public static List<ExperimentComparison> ofEachVersion(List<Experiment> experiments, Scores scores, boolean paper) {
        Map<String, List<Experiment>> versions = Experiment.byVersion(experiments);
        List<ExperimentComparison> comparisons = new ArrayList<>();
        versions.forEach((version, ofVersion) -> comparisons.add(of(version, ofVersion, scores, paper)));
        if (paper && comparisons.stream().noneMatch(comparison -> comparison.report.hasPaper())) {
            throw new UserError(
                    "paper=true: the paper has none of these experiments; it has the methods of the blended,"
                            + " interleaved and isolated task");
        }
        return comparisons;
    }

    private static ExperimentComparison of(String version, List<Experiment> experiments, Scores scores, boolean paper) {
        List<String> notes = new ArrayList<>();
        boolean evaluated = chooseEvaluated(experiments, scores, notes);
        noteUnfinished(experiments, notes);
        List<Sample> samples = experiments.stream()
                .map(e -> new Sample(e.label(), e.championScores(evaluated)))
                .toList();
        List<Sample> published = paper ? published(experiments) : List.of();
        if (!published.isEmpty() && !evaluated) {
            notes.add("The paper's scores are averages of 1,000 games; the last generation's are the best of few games."
                    + " Run evaluate before you read anything into the difference.");
        }
        return new ExperimentComparison(version, evaluated, ComparisonReport.of(samples, published), notes);
    }

    private static boolean chooseEvaluated(List<Experiment> experiments, Scores scores, List<String> notes) {
        List<String> missing = experiments.stream()
                .filter(e -> !e.isEvaluated())
                .map(Experiment::label)
                .toList();
        if (scores == Scores.TRAINING) {
            return false;
        }
        if (missing.isEmpty()) {
            return true;
        }
        if (scores == Scores.EVALUATION) {
            throw new UserError("scores=evaluation: not every champion of " + String.join(", ", missing)
                    + " was evaluated; run evaluate on it first");
        }
        if (experiments.stream().allMatch(experiment -> experiment.version().isEmpty())) {
            // evaluate plays Ms. Pac-Man.
            notes.add("Scores are the best of the last generation: of few evaluations, and so too high.");
            return false;
        }
        notes.add("Scores are the best of the last generation, of few games and so too high: not every"
                + " champion of " + String.join(", ", missing) + " was evaluated. Run evaluate for 1,000 games each.");
        return false;
    }

    /** Champions of runs that are still going on, or were stopped, are compared as they are; the reader must know. */
    private static void noteUnfinished(List<Experiment> experiments, List<String> notes) {
        for (Experiment experiment : experiments) {
            List<RunResult> unfinished =
                    experiment.runs().stream().filter(RunResult::isUnfinished).toList();
            if (!unfinished.isEmpty()) {
                notes.add(unfinished.size() + " of the " + experiment.runs().size() + " runs of " + experiment.label()
                        + " are not finished (run " + unfinished.get(0).number() + " is in generation "
                        + unfinished.get(0).generations() + " of "
                        + unfinished.get(0).parameters().get("maxGens") + ").");
            }
        }
    }

    private static List<Sample> published(List<Experiment> experiments) {
        PublishedResults results = PublishedResults.read();
        List<Sample> samples = new ArrayList<>();
        for (Experiment experiment : experiments) {
            double[] scores = results.champions(experiment.version(), experiment.method()).stream()
                    .mapToDouble(PublishedResults.Champion::averageScore)
                    .toArray();
            if (scores.length > 0) {
                samples.add(new Sample(experiment.label(), scores));
            }
        }
        return samples;
    }

    /**
     * What the scores are, as a heading.
     *
     * @param ofSeveral whether the version has to be named
     */
    public String heading(boolean ofSeveral) {
        String scores = evaluated
                ? "Champions' average score in games after evolution"
                : "Best score in the last generation of evolution";
        return ofSeveral ? scores + ", " + (version.isEmpty() ? "other tasks" : version + " task") : scores;
    }
}
