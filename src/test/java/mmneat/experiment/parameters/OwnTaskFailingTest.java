package mmneat.experiment.parameters;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import mmneat.evolution.Evaluation;
import mmneat.evolution.Task;
import mmneat.experiment.UserError;
import mmneat.experiment.run.ExperimentPlan;
import mmneat.experiment.run.ExperimentRunner;
import mmneat.experiment.run.RunOutcome;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tasks of the user's own whose methods fail: one line names the task and the method. */
class OwnTaskFailingTest {

    private static final String TASK = "task=" + Failing.class.getName();

    /** A task one method of which fails, in the way and from the call that parameters select. */
    public static final class Failing implements Task {
        private final String method;
        private final String way;
        private int evaluations;

        public Failing(Map<String, String> parameters) {
            method = parameters.getOrDefault("method", "");
            way = parameters.getOrDefault("way", "");
            answer("constructor", 0, 0);
        }

        private <T> T answer(String name, T usual, T bad) {
            boolean isLate = way.startsWith("late");
            if (!name.equals(method) || isLate && evaluations == 0) {
                return usual;
            }
            return switch (way) {
                case "bad", "late bad" -> bad;
                case "throws", "late throws" -> throw new IllegalStateException("two\nlines");
                case "error" -> throw new Error("own");
                case "memory" -> throw new OutOfMemoryError("Java heap space");
                default -> throw OwnTaskFailingTest.<RuntimeException>sneak(new IOException("checked"));
            };
        }

        @Override
        public List<String> objectiveNames() {
            return answer("objectiveNames", List.of("Score"), null);
        }

        @Override
        public double[] referencePoint() {
            return answer("referencePoint", new double[] {0}, new double[] {Double.NaN});
        }

        @Override
        public boolean isDeterministic() {
            return answer("isDeterministic", false, true);
        }

        @Override
        public List<String> otherScoreNames() {
            return answer("otherScoreNames", List.of(), null);
        }

        @Override
        public List<String> otherScoreLabels() {
            return answer("otherScoreLabels", List.of(), Arrays.asList((String) null));
        }

        @Override
        public double championScore(Evaluation evaluation) {
            return answer("championScore", 1.0, Double.NaN);
        }

        @Override
        public double championRank(Evaluation evaluation) {
            return answer("championRank", 1.0, Double.POSITIVE_INFINITY);
        }

        @Override
        public List<String> inputLabels() {
            return answer("inputLabels", List.of("Input"), null);
        }

        @Override
        public int inputs() {
            return answer("inputs", 1, 0);
        }

        @Override
        public int policyNeuronsPerModule() {
            return answer("policyNeuronsPerModule", 1, 2_000_000_000);
        }

        @Override
        public int trials() {
            return answer("trials", 1, Integer.MAX_VALUE);
        }

        @Override
        public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
            evaluations++;
            return answer("evaluate", Evaluation.of(new int[genotype.modules()], 1), null);
        }
    }

    @SuppressWarnings("unchecked") // A checked exception that no method declares, as other languages throw them.
    private static <T extends Throwable> RuntimeException sneak(Throwable thrown) throws T {
        throw (T) thrown;
    }

    @TempDir
    private Path folder;

    private ExperimentRunner experiment(String method, String way, String... words) {
        List<String> all = Stream.concat(
                        Stream.of(
                                TASK,
                                "task.method=" + method,
                                "task.way=" + way,
                                "base=" + folder,
                                "mu=2",
                                "maxGens=1",
                                "threads=1"),
                        Arrays.stream(words))
                .toList();
        return new ExperimentRunner(ExperimentPlan.of(
                new ParameterReader(ParameterCatalogue.load()).read(all).parameters()));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "objectiveNames",
                "referencePoint",
                "isDeterministic",
                "otherScoreNames",
                "otherScoreLabels",
                "inputLabels",
                "inputs",
                "policyNeuronsPerModule",
                "trials"
            })
    void methodThatThrows_isNamedBeforeAnyRun(String method) {
        assertThatThrownBy(() -> experiment(method, "throws"))
                .isInstanceOf(UserError.class)
                .hasMessage(TASK + ": " + method + "() threw java.lang.IllegalStateException: two?lines");
        assertThatThrownBy(() -> experiment(method, "sneaks"))
                .isInstanceOf(UserError.class)
                .hasMessage(TASK + ": " + method + "() threw java.io.IOException: checked");
        assertThatThrownBy(() -> experiment(method, "error"))
                .isInstanceOf(UserError.class)
                .hasMessage(TASK + ": " + method + "() threw java.lang.Error: own");
    }

    @ParameterizedTest
    @CsvSource({
        "objectiveNames, objectiveNames() must not be null",
        "referencePoint, referencePoint() must give finite numbers",
        "otherScoreNames, otherScoreNames() must not be null",
        "otherScoreLabels, otherScoreLabels(): must not be null or contain null",
        "inputLabels, inputLabels() must not be null",
        "inputs, must have at least one input and a label for each",
        "policyNeuronsPerModule, policyNeuronsPerModule() must be at most 1000000"
    })
    void invalidAnswer_isNamedBeforeAnyRun(String method, String message) {
        assertThatThrownBy(() -> experiment(method, "bad"))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith(TASK + ": " + message);
    }

    @Test
    void manyTrials_areOnlyRecorded() throws Exception {
        assertThat(experiment("trials", "bad").run().get(0).isComplete()).isTrue();
    }

    @ParameterizedTest
    @CsvSource({
        "throws, java.lang.IllegalStateException: two?lines",
        "sneaks, java.io.IOException: checked",
        "error, java.lang.Error: own"
    })
    void constructorThatThrows_isNamed(String way, String thrown) {
        assertThatThrownBy(() -> experiment("constructor", way))
                .isInstanceOf(UserError.class)
                .hasMessage(TASK + ": cannot be created: " + thrown);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "championScore; bad; gave NaN; it must give a finite number",
                "championRank; bad; gave Infinity; it must give a finite number",
                "championScore; throws; threw java.lang.IllegalStateException: two?lines at ",
                "championRank; sneaks; threw java.io.IOException: checked at ",
                "isDeterministic; late throws; threw java.lang.IllegalStateException: two?lines at ",
                "objectiveNames; late bad; gave null",
                "otherScoreNames; late sneaks; threw java.io.IOException: checked at ",
                "trials; late throws; threw java.lang.IllegalStateException: two?lines at ",
            })
    void methodThatFailsDuringARun_endsItWithOneLine(String method, String way, String problem) throws Exception {
        RunOutcome outcome = experiment(method, way).run().get(0);
        assertThat(outcome.message())
                .startsWith(method + "() of task " + Failing.class.getName() + ": " + problem)
                .doesNotContain("\n", "cannot write");
        assertThat(outcome.failure()).isNull();
        assertThat(outcome.isComplete()).isFalse();
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void checkedExceptionOfAnEvaluation_isNoProblemOfTheDisk(boolean isParallel) throws Exception {
        RunOutcome outcome = experiment("evaluate", "sneaks", "parallelEvaluations=" + isParallel)
                .run()
                .get(0);
        assertThat(outcome.message()).isEqualTo(TASK + ": genotype 1 in generation 0: java.io.IOException: checked");
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void exhaustedMemory_isOneLine(boolean isParallel) throws Exception {
        RunOutcome outcome = experiment("evaluate", "memory", "parallelEvaluations=" + isParallel)
                .run()
                .get(0);
        assertThat(outcome.message()).startsWith("out of memory; give Java more memory with the option -Xmx");
        assertThat(outcome.failure()).isNull();
    }
}
