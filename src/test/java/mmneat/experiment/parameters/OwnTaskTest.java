package mmneat.experiment.parameters;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import mmneat.evolution.Evaluation;
import mmneat.evolution.Task;
import mmneat.experiment.UserError;
import mmneat.experiment.run.ExperimentPlan;
import mmneat.experiment.run.ExperimentRunner;
import mmneat.experiment.run.RunOutcome;
import mmneat.experiment.run.RunPlan;
import mmneat.experiment.store.RunParametersFile;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The checks of a user's task before a run starts. */
class OwnTaskTest {

    /** A task whose parameters set the numbers of its inputs, outputs and objectives; each is 1 by default. */
    public static final class Shaped implements Task {
        private final Map<String, String> parameters;

        public Shaped(Map<String, String> parameters) {
            this.parameters = parameters;
        }

        private int count(String name) {
            return Integer.parseInt(parameters.getOrDefault(name, "1"));
        }

        /** Returns a line break for names of the kind that the parameter {@code nasty} selects, else the empty text. */
        private String nasty(String kind) {
            return parameters.getOrDefault("nasty", "").equals(kind) ? "\n2" : "";
        }

        @Override
        public List<String> otherScoreNames() {
            return List.of("Other" + nasty("other"));
        }

        @Override
        public List<String> objectiveNames() {
            return Collections.nCopies(count("objectives"), "Score" + nasty("objective"));
        }

        @Override
        public double[] referencePoint() {
            return new double[count("referencePoint")];
        }

        @Override
        public List<String> inputLabels() {
            return Collections.nCopies(count("labels"), "Input" + nasty("input"));
        }

        @Override
        public int inputs() {
            return count("inputs");
        }

        @Override
        public int policyNeuronsPerModule() {
            return count("outputs");
        }

        @Override
        public int trials() {
            return count("trials");
        }

        @Override
        public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
            throw new UnsupportedOperationException();
        }
    }

    private static ParameterReader.Result read(String... words) {
        return new ParameterReader(ParameterCatalogue.load())
                .read(Stream.concat(Stream.of("task=" + Shaped.class.getName()), Arrays.stream(words))
                        .toList());
    }

    private static ExperimentRunner experiment(String... words) {
        return new ExperimentRunner(ExperimentPlan.of(read(words).parameters()));
    }

    @Test
    void taskWithOneInputOutputAndObjective_isAccepted() {
        assertThat(experiment().monitors()).hasSize(1);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "objectives=0; names no objective; referencePoint=0",
                "objectives=2; referencePoint() must give 2 numbers, one for each objective, gives 1; inputs=1",
                "labels=0; must have at least one input and a label for each, has 0 inputs and 0 labels; inputs=0",
                "labels=2; must have at least one input and a label for each, has 1 inputs and 2 labels; inputs=1",
                "outputs=0; policyNeuronsPerModule() must be at least 1, is 0; inputs=1",
                "trials=0; trials() must be at least 1, is 0; inputs=1"
            })
    void taskWithNothingToEvolve_isRefusedAtTheStart(String word, String message, String other) {
        assertThatThrownBy(() -> experiment("task." + word, "task." + other))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith("task=" + Shaped.class.getName() + ": ")
                .hasMessageContaining(message)
                .message()
                .doesNotContain("\n");
    }

    @ParameterizedTest
    @CsvSource({"objective, objectiveNames()", "other, otherScoreNames()", "input, inputLabels()"})
    void namesWithControlCharacters_areRefusedAtTheStart(String kind, String method) {
        assertThatThrownBy(() -> experiment("task.nasty=" + kind))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith("task=" + Shaped.class.getName() + ": " + method)
                .hasMessageContaining("must not contain control characters, has U+000A");
    }

    @ParameterizedTest
    @ValueSource(strings = {"parallelEvaluations=false", "parallelEvaluations=true"})
    void exceptionOfATask_namesTheGenotypeAndTheGeneration(String word, @TempDir Path folder) throws Exception {
        RunOutcome outcome =
                experiment("mu=2", "base=" + folder, "threads=1", word).run().get(0);
        assertThat(outcome.message())
                .isEqualTo("task=" + Shaped.class.getName()
                        + ": genotype 1 in generation 0: java.lang.UnsupportedOperationException");
        assertThat(outcome.failure()).isInstanceOf(UnsupportedOperationException.class);
    }

    @Test
    void parametersOfTheGame_areRemarkedUpon() {
        assertThat(read("trials=1", "edibleTime=100", "disabledMode=-1", "mu=7", "multitaskModes=2")
                        .remarks())
                .containsExactly("no effect on task=" + Shaped.class.getName()
                        + ": trials, edibleTime, disabledMode (for Ms. Pac-Man alone;"
                        + " parameters of a task of your own are called task.NAME)");
        assertThat(read("method=2M", "mu=7", "task.trials=3").remarks()).isEmpty();
    }

    @Test
    void fileOfARun_givesRemarks_onlyForValuesThatAreNotDefaults(@TempDir Path folder) throws IOException {
        RunPlan plain = ExperimentPlan.of(read("mu=7").parameters()).runs().get(0);
        new RunParametersFile(folder).write(plain.parameters());
        String config = "config=" + folder.resolve("parameters.properties");
        assertThat(read(config).remarks()).isEmpty();
        RunPlan idle =
                ExperimentPlan.of(read("highLevel=false").parameters()).runs().get(0);
        new RunParametersFile(folder).write(idle.parameters());
        assertThat(read(config).remarks()).singleElement().asString().contains(": highLevel (");
        assertThat(read(config).parameters().flag("highLevel")).isFalse();
    }

    @Test
    void usageForNewModeOfZero_isAGateThatNeverOpens() {
        assertThat(experiment("method=MMD", "usageForNewMode=0").monitors()).hasSize(1);
    }
}
