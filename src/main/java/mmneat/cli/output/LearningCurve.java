package mmneat.cli.output;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import mmneat.analysis.figures.Figure;
import mmneat.analysis.figures.LearningCurveFigure;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.PublishedResults;
import mmneat.analysis.results.RunReader;
import mmneat.analysis.results.RunResult;
import mmneat.experiment.run.ExperimentPlan;
import mmneat.experiment.run.RunOutcome;
import mmneat.experiment.store.DurableFiles;

/**
 * Writer of the learning curve that the main job ({@link MainJob}) leaves in the folder of an experiment, of any task.
 * It converts the outcomes of the runs for {@link LearningCurveFigure}, which draws, and saves the files.
 */
public final class LearningCurve {

    private LearningCurve() {}

    /**
     * Writes {@code <name>_learning-curve.svg} beside the folders of the complete runs, and {@code .png} if this
     * machine has fonts.
     *
     * @return the SVG file; empty if no run is complete
     */
    public static Optional<Path> write(ExperimentPlan plan, List<RunOutcome> outcomes) throws IOException {
        List<RunResult> runs = new ArrayList<>();
        for (RunOutcome outcome : outcomes) {
            if (outcome.isComplete()) {
                Path folder = outcome.run().directory();
                runs.add(new RunResult(
                        folder, outcome.run().number(), Map.of(), RunReader.championScores(folder), Optional.empty()));
            }
        }
        if (runs.isEmpty()) {
            return Optional.empty();
        }
        Experiment experiment =
                new Experiment(plan.parameters().text("task"), plan.parameters().text("method"), plan.name(), runs);
        Figure figure = LearningCurveFigure.panels(experiment.version(), List.of(experiment), PublishedResults.read());
        Path svg = plan.base().resolve(plan.name() + "_learning-curve.svg");
        DurableFiles.write(svg, figure.svg().getBytes(StandardCharsets.UTF_8));
        Optional<byte[]> png = figure.png();
        if (png.isPresent()) {
            DurableFiles.write(plan.base().resolve(plan.name() + "_learning-curve.png"), png.get());
        }
        return Optional.of(svg);
    }
}
