package mmneat.cli;

import com.fasterxml.jackson.databind.MappingIterator;
import com.fasterxml.jackson.dataformat.csv.CsvMapper;
import com.fasterxml.jackson.dataformat.csv.CsvSchema;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import mmneat.analysis.figures.Figure;
import mmneat.analysis.figures.LearningCurveFigure;
import mmneat.analysis.results.Experiment;
import mmneat.analysis.results.PublishedResults;
import mmneat.analysis.results.RunResult;
import mmneat.experiment.ExperimentPlan;
import mmneat.experiment.RunOutcome;

/** The learning curve of an experiment, of any task, as a picture in its folder. */
final class LearningCurve {

    private LearningCurve() {}

    /**
     * Writes {@code <name>_learning-curve.svg} and {@code .png} beside the folders of the complete runs.
     *
     * @return the SVG file; empty if no run is complete
     */
    static Optional<Path> write(ExperimentPlan plan, List<RunOutcome> outcomes) throws IOException {
        List<RunResult> runs = new ArrayList<>();
        for (RunOutcome outcome : outcomes) {
            if (outcome.isComplete()) {
                Path folder = outcome.run().directory();
                runs.add(new RunResult(
                        folder, outcome.run().number(), Map.of(), championScores(folder), Optional.empty()));
            }
        }
        if (runs.isEmpty()) {
            return Optional.empty();
        }
        Experiment experiment =
                new Experiment(plan.parameters().text("task"), plan.parameters().text("method"), plan.name(), runs);
        Figure figure = LearningCurveFigure.panels(experiment.version(), List.of(experiment), PublishedResults.read());
        Path svg = plan.base().resolve(plan.name() + "_learning-curve.svg");
        Files.writeString(svg, figure.svg());
        Files.write(plan.base().resolve(plan.name() + "_learning-curve.png"), figure.png());
        return Optional.of(svg);
    }

    private static double[] championScores(Path run) throws IOException {
        List<Double> scores = new ArrayList<>();
        try (MappingIterator<Map<String, String>> rows = new CsvMapper()
                .readerForMapOf(String.class)
                .with(CsvSchema.emptySchema().withHeader())
                .readValues(run.resolve("generations.csv").toFile())) {
            while (rows.hasNext()) {
                scores.add(Double.parseDouble(rows.next().get("best")));
            }
        }
        return scores.stream().mapToDouble(Double::doubleValue).toArray();
    }
}
