package mmneat.analysis.evaluation;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import mmneat.evolution.Evaluation;
import mmneat.evolution.SampleStatistics;
import mmneat.experiment.FileErrors;
import mmneat.experiment.UserError;
import mmneat.experiment.store.DoubleText;
import mmneat.experiment.store.DurableFiles;
import mmneat.experiment.store.RunLayout;
import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.ModuleUse;
import mmneat.mspacman.ModuleUse.When;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import pacman.game.Game;

/**
 * The original's evaluation report on a champion, equal to the original's file: one evaluation of many trials. All
 * games draw from one generator with the run's seed, in the original's order. The report is for comparisons with the
 * original; {@link ChampionEvaluator} plays games in parallel and writes statistics and tables.
 *
 * <p>In each time step the network is activated once for each of the four directions. The report counts the modules
 * that decided in each of these four activations, and apart from them the module of the chosen direction.
 *
 * <p>Source: docs/specification/evolution.md, section 6.2.
 */
public final class EvaluationReport implements EvaluationObserver {

    private static final List<String> DIRECTIONS = List.of("UP", "RIGHT", "DOWN", "LEFT");

    private final MsPacManTask task;
    private final Genotype genotype;
    private final ModuleUse total;
    private final List<double[]> objectives = new ArrayList<>();
    private final List<double[]> otherScores = new ArrayList<>();
    private final StringBuilder text = new StringBuilder();

    private EvaluationReport(MsPacManTask task, Genotype genotype) {
        this.task = task;
        this.genotype = genotype;
        total = new ModuleUse(genotype.modules());
    }

    /**
     * Evaluates a champion and writes the report into its run's folder, under the original's name.
     *
     * @param games number of trials
     * @return the file
     */
    public static Path write(Champion champion, MsPacManTaskSettings settings, int games) {
        Path folder = champion.runFolder()
                .orElseThrow(() ->
                        new UserError(champion.file() + ": is not in the folder of a run, whose seed the original's"
                                + " report uses; give the folder of a run"));
        String seed = champion.parameters().getOrDefault("randomSeed", "0");
        Path file = folder.resolve(RunLayout.evaluationReport(
                RunLayout.prefixIn(folder), champion.genotype().id()));
        try {
            String report = of(settings, champion.genotype(), games, Long.parseLong(seed));
            DurableFiles.writeNamed(file, report.getBytes(StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw FileErrors.unwritable(file, e);
        }
        return file;
    }

    /**
     * The text of a report.
     *
     * @param seed of the generator that all games draw from
     */
    static String of(MsPacManTaskSettings settings, Genotype genotype, int games, long seed) {
        MsPacManTask task = new MsPacManTask(settings.withTrials(games));
        EvaluationReport report = new EvaluationReport(task, genotype);
        Evaluation evaluation = task.evaluate(genotype, new ResumableRandom(seed), report);
        report.summary(evaluation);
        return report.text.toString();
    }

    @Override
    public void trialStarted(int trial) {
        line("Eval " + trial + ":");
    }

    @Override
    public void levelFinished(int level, int maze) {
        line("Level " + level + "/Maze " + maze);
    }

    @Override
    public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
        line(
                switch (end) {
                    case ALL_LEVELS_BEATEN -> "All Levels Beaten";
                    case LOST_ALL_LIVES -> "Lost All Lives";
                    case LEVEL_TIME_LIMIT -> "Level Time Limit Reached\n\nNULL Move = Special Termination Request";
                    case GAME_TIME_LIMIT -> "Time Limit Reached";
                    case PUNISHED -> "Punished For Power Pill";
                });
        line("");
        ModuleUse use = player.moduleUse();
        total.add(use);
        line("Network Info");
        line("\tNum Nodes: " + genotype.nodes().size());
        line("\tNum Modes: " + genotype.modules());
        line("\tNum Outputs: " + genotype.outputs());
        line("\tNeurons Per Mode: " + genotype.layout().policyNeuronsPerModule());
        line("\tTime Steps: " + use.decisions());
        chosenDirection(use);
        for (int d = 0; d < DIRECTIONS.size(); d++) {
            network(d, use);
        }
        line("");
    }

    private void chosenDirection(ModuleUse use) {
        String of = " For Chosen Direction Networks: ";
        line("\tMode Usage" + of + counts(use.ofChosenDirection(When.ALL)));
        line("\tMode Usage At Junctions" + of + counts(use.ofChosenDirection(When.AT_JUNCTION)));
        line("\tEdible Mode Usage" + of + counts(use.ofChosenDirection(When.EDIBLE)));
        line("\tThreat Mode Usage" + of + counts(use.ofChosenDirection(When.THREAT)));
        line("\tEdible Mode Usage At Junctions" + of + counts(use.ofChosenDirection(When.EDIBLE_AT_JUNCTION)));
        line("\tThreat Mode Usage At Junctions" + of + counts(use.ofChosenDirection(When.THREAT_AT_JUNCTION)));
    }

    private void network(int direction, ModuleUse use) {
        line("\t" + DIRECTIONS.get(direction) + " Network:");
        line("\t\tMode Usage: " + counts(use.ofNetwork(direction, When.ALL)));
        line("\t\tEdible Mode Usage: " + counts(use.ofNetwork(direction, When.EDIBLE)));
        line("\t\tThreat Mode Usage: " + counts(use.ofNetwork(direction, When.THREAT)));
        line("\t\tJunction Mode Usage: " + counts(use.ofNetwork(direction, When.AT_JUNCTION)));
        line("\t\tEdible Mode Usage At Junctions: " + counts(use.ofNetwork(direction, When.EDIBLE_AT_JUNCTION)));
        line("\t\tThreat Mode Usage At Junctions: " + counts(use.ofNetwork(direction, When.THREAT_AT_JUNCTION)));
        int used = Arrays.stream(use.ofNetwork(direction, When.ALL)).sum();
        line("\t\tNetwork Usage: " + used + ":" + DoubleText.of(used / (double) use.decisions()));
        line("\t\tUnused Count: " + (use.decisions() - used));
    }

    @Override
    public void trialOver(int trial, double[] trialObjectives, double[] trialOthers) {
        objectives.add(trialObjectives);
        otherScores.add(trialOthers);
    }

    private void summary(Evaluation evaluation) {
        line("Fitness scores:");
        scores(task.objectiveNames(), objectives, evaluation.objectives());
        line("\tOther scores:");
        scores(task.otherScoreLabels(), otherScores, evaluation.otherScores());
        line("Fitness:" + array(evaluation.objectives()));
        line("OtherScores:" + array(evaluation.otherScores()));
        line("");
        line("Usage: "
                + Stream.of(When.values())
                        .map(when -> proportions(total.ofChosenDirection(when)))
                        .collect(Collectors.joining()));
        line("Total Mode Usage Across Evals");
        chosenDirection(total);
    }

    private void scores(List<String> labels, List<double[]> trials, double[] aggregates) {
        for (int k = 0; k < labels.size(); k++) {
            int score = k;
            double[] values = trials.stream().mapToDouble(trial -> trial[score]).toArray();
            // Only averages have a deviation. The label of another statistic ends with its name in brackets.
            String deviation = labels.get(k).endsWith("]") ? "" : " +/- " + DoubleText.of(deviation(values));
            line("\t" + labels.get(k) + ":\t" + array(values) + ":" + DoubleText.of(aggregates[k]) + deviation);
        }
    }

    /**
     * Sample deviation in two passes. The report is the one place where the original does not use its running formula
     * ({@link SampleStatistics}); they differ in the last digits.
     */
    private static double deviation(double[] values) {
        double mean = SampleStatistics.meanOf(values);
        double squares = 0;
        for (double value : values) {
            squares += (value - mean) * (value - mean);
        }
        return Math.sqrt(squares / (values.length - 1));
    }

    private static String counts(int[] counts) {
        return Arrays.toString(counts) + ":" + proportions(counts);
    }

    /** An empty array if nothing was counted. */
    private static String proportions(int[] counts) {
        double all = Arrays.stream(counts).sum();
        return array(
                all == 0
                        ? new double[0]
                        : Arrays.stream(counts)
                                .mapToDouble(count -> count / all)
                                .toArray());
    }

    private static String array(double[] values) {
        return DoubleStream.of(values).mapToObj(DoubleText::of).collect(Collectors.joining(", ", "[", "]"));
    }

    private void line(String line) {
        text.append(line).append('\n');
    }
}
