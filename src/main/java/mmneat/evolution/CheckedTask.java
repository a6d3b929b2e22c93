package mmneat.evolution;

import java.util.List;
import java.util.function.Supplier;
import mmneat.neat.Genotype;
import mmneat.neat.OwnPart;
import mmneat.random.ResumableRandom;

/**
 * A task of the user's own, checked at each call: what its methods throw, null, and scores that are not finite become a
 * {@link mmneat.neat.BadPartException} that names the method. {@link #evaluate} passes the call on; an evaluator checks
 * it.
 */
public final class CheckedTask implements Task {

    private final Task task;

    private CheckedTask(Task task) {
        this.task = task;
    }

    /** The task with checks; the same object if it has them already. */
    public static Task of(Task task) {
        return task instanceof CheckedTask ? task : new CheckedTask(task);
    }

    private OwnPart method(String name) {
        return OwnPart.of(name + "() of task", task);
    }

    private <T> T answer(String name, Supplier<T> method) {
        T answer = method(name).call(method);
        if (answer == null) {
            throw method(name).bad("gave null");
        }
        return answer;
    }

    @Override
    public List<String> objectiveNames() {
        return answer("objectiveNames", task::objectiveNames);
    }

    @Override
    public double[] referencePoint() {
        return answer("referencePoint", task::referencePoint);
    }

    @Override
    public boolean isDeterministic() {
        return answer("isDeterministic", task::isDeterministic);
    }

    @Override
    public List<String> otherScoreNames() {
        return answer("otherScoreNames", task::otherScoreNames);
    }

    @Override
    public List<String> otherScoreLabels() {
        return answer("otherScoreLabels", task::otherScoreLabels);
    }

    @Override
    public double championScore(Evaluation evaluation) {
        return method("championScore").number(() -> task.championScore(evaluation));
    }

    @Override
    public double championRank(Evaluation evaluation) {
        return method("championRank").number(() -> task.championRank(evaluation));
    }

    @Override
    public List<String> inputLabels() {
        return answer("inputLabels", task::inputLabels);
    }

    @Override
    public int inputs() {
        return answer("inputs", task::inputs);
    }

    @Override
    public int policyNeuronsPerModule() {
        return answer("policyNeuronsPerModule", task::policyNeuronsPerModule);
    }

    @Override
    public int trials() {
        return answer("trials", task::trials);
    }

    @Override
    public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
        return task.evaluate(genotype, random);
    }
}
