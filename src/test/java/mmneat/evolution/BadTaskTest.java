package mmneat.evolution;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.List;
import mmneat.neat.Genotype;
import mmneat.neat.ModuleLayout;
import mmneat.neat.variation.InitialNetworks;
import mmneat.random.ResumableRandom;
import org.assertj.core.api.AbstractThrowableAssert;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tasks that throw something unusual or count modules wrongly, with both evaluators. */
class BadTaskTest {

    private final Genotype genotype = new InitialNetworks(1, ModuleLayout.single(1)).create(17, new ResumableRandom(1));

    private AbstractThrowableAssert<?, ? extends Throwable> assertFailure(Task task, boolean isParallel) {
        ResumableRandom random = new ResumableRandom(1);
        if (!isParallel) {
            SequentialEvaluator evaluator = new SequentialEvaluator(task);
            return assertThatThrownBy(() -> evaluator.evaluate(List.of(genotype), 5, 0, random, individual -> {}));
        }
        try (ParallelEvaluator evaluator = new ParallelEvaluator(() -> task, 1, 1)) {
            return assertThatThrownBy(() -> evaluator.evaluate(List.of(genotype), 5, 0, random, individual -> {}));
        }
    }

    @SuppressWarnings("unchecked") // A checked exception that no method declares, as other languages throw them.
    private static <T extends Throwable> RuntimeException sneak(Throwable thrown) throws T {
        throw (T) thrown;
    }

    private static Task throwing(Throwable thrown) {
        return Task.of(List.of("C"), List.of("B"), 1, (network, random) -> {
            throw BadTaskTest.<RuntimeException>sneak(thrown);
        });
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void negativeUsage_isABadEvaluation_thatNamesTheGenotype(boolean isParallel) {
        Task task = Task.of(List.of("C"), List.of("B"), 1, (network, random) -> Evaluation.of(new int[] {-1}, 1));
        assertFailure(task, isParallel)
                .isInstanceOf(BadEvaluationException.class)
                .hasMessage("genotype 17 in generation 5: the task gave the usage -1 of module 0;"
                        + " it must be at least 0");
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void checkedException_isAFailedEvaluation_ofOneLine(boolean isParallel) {
        assertFailure(throwing(new IOException("two\nlines")), isParallel)
                .isInstanceOf(FailedEvaluationException.class)
                .hasMessage("genotype 17 in generation 5: java.io.IOException: two?lines")
                .hasCauseInstanceOf(IOException.class);
        assertFailure(throwing(new Error("own")), isParallel)
                .isInstanceOf(FailedEvaluationException.class)
                .hasMessage("genotype 17 in generation 5: java.lang.Error: own");
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void exceptionWithoutText_isNamedByItsClass(boolean isParallel) {
        class Silent extends RuntimeException {
            @Override
            public String toString() {
                throw new IllegalStateException();
            }
        }
        assertFailure(throwing(new Silent()), isParallel)
                .isInstanceOf(FailedEvaluationException.class)
                .hasMessage("genotype 17 in generation 5: " + Silent.class.getName());
    }
}
