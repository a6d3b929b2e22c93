package mmneat.experiment.parameters;

import java.nio.file.Path;
import java.util.SortedSet;
import mmneat.experiment.UserError;
import mmneat.neat.ActivationFunction;
import mmneat.neat.BadPartException;
import mmneat.neat.Genotype;
import mmneat.neat.NeuronFunction;

/**
 * Loader of activation functions that are classes of the user's own. The parameter {@code activation} names one for an
 * evolution; the file of a network names those of its neurons. Such a class implements {@link NeuronFunction}
 * and has a public constructor without parameters.
 */
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
     * Returns a network with its activation functions loaded, so that it can be activated. A network that was read from
     * a file has only the names of the user's own functions.
     *
     * @param jar the jar or folder with their classes, named by the user
     * @throws UserError if a class cannot be used as an activation function
     */
    public static Genotype bind(Genotype genotype, Path jar) {
        OwnClasses classes = new OwnClasses(jar.toString());
        return genotype.withFunctions(function -> function.isBound() ? function : load(function.name(), classes));
    }

    /**
     * Checks that a network can be activated without loading code that the user has not allowed: all its activation
     * functions are built in or loaded.
     *
     * @param file the network's file, for the message
     * @param jar the jar that the parameters of its run name; empty if they name none
     * @throws UserError if a function is not loaded; the message says how to allow it
     */
    public static void requireBound(Genotype genotype, Path file, String jar) {
        SortedSet<String> names = genotype.unboundFunctions();
        if (!names.isEmpty()) {
            throw NamedCode.refusal(file + ": " + NAME + "=" + String.join(",", names), jar);
        }
    }
}
