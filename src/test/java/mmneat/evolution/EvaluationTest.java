package mmneat.evolution;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.assertThatNullPointerException;

import org.junit.jupiter.api.Test;

class EvaluationTest {

    @Test
    void evaluation_copiesItsArrays() {
        double[] objectives = {1, 2};
        double[] otherScores = {3};
        int[] usage = {4, 5};
        Evaluation evaluation = new Evaluation(objectives, otherScores, usage, Evaluation.Outcomes.NONE);
        Evaluation asMade = new Evaluation(objectives, otherScores, usage, Evaluation.Outcomes.NONE);

        objectives[0] = 99;
        otherScores[0] = 99;
        usage[0] = 99;
        evaluation.objectives()[1] = 99;
        evaluation.otherScores()[0] = 99;
        evaluation.moduleUsage()[1] = 99;

        assertThat(evaluation).isEqualTo(asMade);
        assertThat(evaluation.objectives()).containsExactly(1, 2);
        assertThat(evaluation.otherScores()).containsExactly(3);
        assertThat(evaluation.moduleUsage()).containsExactly(4, 5);
    }

    @Test
    void missingParts_areNamed() {
        double[] scores = {1};
        int[] usage = {1};
        assertThatNullPointerException()
                .isThrownBy(() -> new Evaluation(null, scores, usage, Evaluation.Outcomes.NONE))
                .withMessage("objectives");
        assertThatNullPointerException()
                .isThrownBy(() -> new Evaluation(scores, null, usage, Evaluation.Outcomes.NONE))
                .withMessage("otherScores");
        assertThatNullPointerException()
                .isThrownBy(() -> new Evaluation(scores, scores, null, Evaluation.Outcomes.NONE))
                .withMessage("moduleUsage");
        assertThatNullPointerException()
                .isThrownBy(() -> new Evaluation(scores, scores, usage, null))
                .withMessage("outcomes");
        assertThatNullPointerException()
                .isThrownBy(
                        () -> new Individual(null, new Evaluation(scores, scores, usage, Evaluation.Outcomes.NONE), 0))
                .withMessage("genotype");
    }

    @Test
    void negativeOutcomes_areRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Evaluation.Outcomes(0, -1, 0, 0))
                .withMessage("timedOut must not be negative, is -1");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Evaluation.Outcomes(0, 0, 0, -7))
                .withMessage("steps must not be negative, is -7");
    }
}
