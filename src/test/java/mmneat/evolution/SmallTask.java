package mmneat.evolution;

import java.util.List;

/** Base class of test tasks with one input, one policy neuron and one objective. */
public abstract class SmallTask implements Task {

    @Override
    public List<String> objectiveNames() {
        return List.of("Score");
    }

    @Override
    public List<String> inputLabels() {
        return List.of("Constant");
    }

    @Override
    public int policyNeuronsPerModule() {
        return 1;
    }
}
