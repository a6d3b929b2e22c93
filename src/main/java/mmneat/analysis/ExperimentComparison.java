package mmneat.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.MethodName;
import mmneat.analysis.results.PublishedResults;
import mmneat.analysis.results.RunResult;
import mmneat.analysis.statistics.ComparisonReport;
import mmneat.analysis.statistics.Sample;
import mmneat.experiment.UserError;

/**
 * The statistical comparison of the champions of several experiments in one version of the task (blended, interleaved
 * or isolated). Scores of different versions are not comparable.
 *
 * @param version of the task; empty for a task of the user's own
 * @param evaluated whether the scores are those of the evaluation after evolution; if not, of the last generation
 * @param report the tables
 * @param notes remarks on the numbers, for example which runs were left out
 */
public record ExperimentComparison(String version, boolean evaluated, ComparisonReport report, List<String> notes) {

    /** The source of the champions' scores: their evaluations after evolution, or the last generation. */
    public enum Scores {
        /** The evaluations if each experiment with finished runs has an evaluated one, else the last generation. */
        AUTO,
        /** The evaluations after evolution. */
        EVALUATION,
        /**
         * The best score among the final parents of each run ({@link RunResult#lastScore}). It is too high: it rests on
         * few games and is the maximum over many networks.
         */
        TRAINING
    }

    public ExperimentComparison {
        notes = List.copyOf(notes);
    }

    /**
     * Compares the experiments of each version of the task.
     *
     * @param paper whether to compare each experiment with the paper's champions, too
     * @return one comparison per version, in the order of the experiments
     * @throws UserError in two cases: {@code scores} is {@link Scores#EVALUATION} and an experiment has no evaluated
     *     run; or {@code paper} is true and none of the experiments is one of the paper's
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
        List<Sample> samples = new ArrayList<>();
        List<ComparisonReport.PaperSample> published = new ArrayList<>();
        PublishedResults results = PublishedResults.read();
        List<Experiment> compared = new ArrayList<>();
        for (Experiment experiment : experiments) {
            noteLeftOut(experiment, evaluated, notes);
            double[] ofRuns = experiment.championScores(evaluated);
            if (ofRuns.length > 0) {
                samples.add(new Sample(experiment.label(), ofRuns));
                compared.add(experiment.ofScoredRuns(evaluated));
            }
            if (paper) {
                addPublished(experiment, evaluated && ofRuns.length > 0, results, published, notes);
            }
        }
        UnlikeRuns unlike = new UnlikeRuns(compared);
        notes.addAll(unlike.ofParameters());
        if (evaluated) {
            notes.addAll(unlike.ofEvaluations());
        }
        if (!published.isEmpty() && !evaluated) {
            notes.add(
                    "The paper's scores are averages of 1,000 games, but the scores of the last generation are the best of"
                            + " few games. Run evaluate on the experiments before comparing them with the paper.");
        }
        return new ExperimentComparison(version, evaluated, ComparisonReport.of(samples, published), notes);
    }

    /** Whether to compare evaluations. Experiments without a finished run do not count, as none of them is compared. */
    private static boolean chooseEvaluated(List<Experiment> experiments, Scores scores, List<String> notes) {
        if (scores == Scores.TRAINING) {
            return false;
        }
        if (scores == Scores.EVALUATION) {
            String missing = labelsWithoutEvaluation(experiments.stream());
            if (!missing.isEmpty()) {
                throw new UserError("scores=evaluation: no champion of a finished run of " + missing
                        + " was evaluated; run evaluate on it first");
            }
            return true;
        }
        List<Experiment> finished = experiments.stream()
                .filter(experiment -> !experiment.runs().stream().allMatch(RunResult::isUnfinished))
                .toList();
        String missing = labelsWithoutEvaluation(finished.stream());
        boolean hasEvaluations = finished.stream()
                .flatMap(experiment -> experiment.runs().stream())
                .anyMatch(RunResult::isComparable);
        if (hasEvaluations && missing.isEmpty()) {
            return true;
        }
        // evaluate plays Ms. Pac-Man.
        boolean canBeEvaluated = experiments.stream()
                .anyMatch(experiment -> !experiment.version().isEmpty());
        notes.add("Scores are the best of the last generation"
                + (hasEvaluations ? ", because no champion of " + missing + " was evaluated. " : ". ")
                + (canBeEvaluated
                        ? "They come from few games and are too high. Run evaluate for 1,000 games each."
                        : "They come from few evaluations and are too high."));
        return false;
    }

    private static String labelsWithoutEvaluation(Stream<Experiment> experiments) {
        return experiments
                .filter(experiment -> experiment.runs().stream().noneMatch(RunResult::isComparable))
                .map(Experiment::label)
                .collect(Collectors.joining(", "));
    }

    /** Lists the runs that are not compared, and why. */
    private static void noteLeftOut(Experiment experiment, boolean evaluated, List<String> notes) {
        List<String> leftOut = new ArrayList<>();
        for (RunResult run : experiment.runs()) {
            if (run.isUnfinished()) {
                leftOut.add("run " + run.number() + " (not finished: generation " + run.generations() + " of "
                        + run.parameters().get("maxGens") + ")");
            } else if (evaluated && run.evaluation().isEmpty()) {
                leftOut.add("run " + run.number() + " (not evaluated)");
            }
        }
        if (!leftOut.isEmpty()) {
            notes.add("Left out of " + experiment.label() + ": " + String.join(", ", leftOut) + ".");
        }
    }

    private static void addPublished(
            Experiment experiment,
            boolean canBeCompared,
            PublishedResults results,
            List<ComparisonReport.PaperSample> published,
            List<String> notes) {
        if (experiment.isVariant()) {
            notes.add(experiment.label() + " is a variant of the paper's " + MethodName.paper(experiment.method())
                    + " (" + differences(experiment) + ") and is not compared with the paper.");
            return;
        }
        double[] scores = results.champions(experiment.version(), experiment.paperMethod()).stream()
                .mapToDouble(PublishedResults.Champion::averageScore)
                .toArray();
        if (scores.length > 0) {
            published.add(new ComparisonReport.PaperSample(
                    new Sample(experiment.label(), scores), canBeCompared, differences(experiment)));
        }
    }

    /** The parameters that are not the paper's, with both values; empty if there are none. */
    private static String differences(Experiment experiment) {
        Map<String, String> ours = experiment.runs().get(0).parameters();
        return experiment.differencesFromPaper().entrySet().stream()
                .map(entry -> entry.getKey() + "=" + ours.get(entry.getKey()) + ", in the paper " + entry.getValue())
                .collect(Collectors.joining("; "));
    }

    /**
     * A heading that names the kind of scores.
     *
     * @param ofSeveral whether to name the version
     */
    public String heading(boolean ofSeveral) {
        String scores = evaluated
                ? "Champions' average score in games after evolution"
                : "Best score in the last generation of evolution";
        return ofSeveral ? scores + ", " + (version.isEmpty() ? "other tasks" : version + " task") : scores;
    }
}
