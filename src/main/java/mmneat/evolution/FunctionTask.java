package mmneat.evolution;

import java.util.List;
import java.util.Objects;
import java.util.function.BiFunction;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;

/** The task that {@link Task#of} makes from an evaluation function. */
record FunctionTask(
        List<String> objectiveNames,
        List<String> inputLabels,
        int policyNeuronsPerModule,
        BiFunction<Genotype, ResumableRandom, Evaluation> evaluation)
        implements Task {

    FunctionTask {
        objectiveNames = List.copyOf(objectiveNames);
        inputLabels = List.copyOf(inputLabels);
        Objects.requireNonNull(evaluation, "evaluation");
        if (objectiveNames.isEmpty() || inputLabels.isEmpty() || policyNeuronsPerModule < 1) {
            throw new IllegalArgumentException(
                    "a task has at least one objective, one input and one policy neuron, not " + objectiveNames.size()
                            + ", " + inputLabels.size() + " and " + policyNeuronsPerModule);
        }
    }

    @Override
    public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
        return evaluation.apply(genotype, random);
    }
}
