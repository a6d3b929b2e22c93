package mmneat.experiment.parameters;

import java.nio.file.Path;
import java.util.SortedSet;
import mmneat.experiment.UserError;
import mmneat.neat.ActivationFunction;
import mmneat.neat.BadPartException;
import mmneat.neat.Genotype;
import mmneat.neat.NeuronFunction;

/** The parameter {@code activation}: an activation function that is a class of the user's own. */
public final class OwnActivation {

    private static final String NAME = "activation";

    /** Sums that every activation function is tried with before anything runs. */
    private static final double[] TRIED = {0, 1, -1};

    private OwnActivation() {}

    /** @throws UserError if there is no such class, it cannot be made or it gives no finite numbers */
    static ActivationFunction load(String className, OwnClasses classes) {
        ActivationFunction function =
                ActivationFunction.own(className, classes.make(NAME, className, NeuronFunction.class));
        try {
            for (double sum : TRIED) {
                function.ofOwn(sum);
            }
        } catch (BadPartException e) {
            throw new UserError(e.getMessage(), e);
        }
        return function;
    }

    /**
     * Returns a network with its activation functions loaded, so that it can be activated.
     *
     * @param jar the jar or folder with their classes, named by the user
     * @throws UserError if a class cannot be used as an activation function
     */
    public static Genotype bind(Genotype genotype, Path jar) {
        OwnClasses classes = new OwnClasses(jar.toString());
        return genotype.withFunctions(function -> function.isBound() ? function : load(function.name(), classes));
    }

    /**
     * Refuses a network that cannot be activated because code would have to be loaded that the user has not allowed.
     *
     * @param file the network's file, for the message
     * @param jar the jar that the parameters of its run name; empty if they name none
     * @throws UserError if so, saying how to allow it
     */
    public static void requireBound(Genotype genotype, Path file, String jar) {
        SortedSet<String> names = genotype.unboundFunctions();
        if (!names.isEmpty()) {
            throw NamedCode.refusal(file + ": " + NAME + "=" + String.join(",", names), jar);
        }
    }
}
