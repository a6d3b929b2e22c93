package mmneat.experiment.parameters;

import java.util.List;
import java.util.Locale;
import java.util.Set;
import mmneat.experiment.NearestName;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;

/**
 * One entry of the catalogue.
 *
 * @param name the name; for most parameters that of the original
 * @param type type of the value
 * @param defaultValue the value if none is given, in canonical form ({@link #check})
 * @param support whether this program supports it
 * @param allowed the values that it may have
 * @param group heading under which it is listed
 * @param meaning one sentence without its full stop
 */
public record Parameter(
        String name,
        ParameterType type,
        String defaultValue,
        Support support,
        AllowedValues allowed,
        String group,
        String meaning) {

    /** The heading of the parameters that the original does not have. */
    static final String EVERYDAY = "Everyday";

    /** The package of the example controllers, in the original and here. */
    private static final String EXAMPLE_CONTROLLERS = "pacman.controllers.examples.";

    private static final Set<String> OF_EVOLUTION_ALONE = Set.of(
            "Run control",
            "Selection and evaluation",
            "Objectives",
            "Post-evaluation and display",
            "Training camps",
            "Other domains",
            "Evolution extras",
            "TUG");

    /** The kind of support that this program gives to a parameter. */
    public enum Support {
        /** The parameter has its described effect. */
        YES,
        /** Any value is accepted, without effect. */
        IGNORED,
        /** The parameter of the original is not supported: only its default is accepted. */
        NO;

        static Support of(String name) {
            return valueOf(name.toUpperCase(Locale.ROOT));
        }
    }

    /**
     * Checks a value and returns it in canonical form: equal values have equal texts. For example, {@code 1e-1} becomes
     * {@code 0.1}, {@code TRUE} becomes {@code true}, and a class of the original loses its package.
     *
     * @param text the value as it was given
     * @throws UserError if the value is not allowed; the message names the parameter, the value and what is allowed
     */
    public String check(String text) {
        PlainText.require(name, PlainText.trimmed(text));
        String canonical;
        try {
            canonical = allowed.spelled(withoutPackageIfShipped(type.canonical(text)));
        } catch (IllegalArgumentException e) {
            throw badValue(text);
        }
        if (support == Support.NO && !canonical.equals(defaultValue)) {
            throw new UserError(name + "=" + text + ": the original's parameter '" + name + "' is not supported; "
                    + OriginalCounterparts.ofParameter(name, text)
                            .orElse("leave it out" + (defaultValue.isEmpty() ? "" : ", which means " + defaultValue)));
        }
        if (support == Support.YES && !canonical.equals(defaultValue) && !allowed.permits(type, canonical)) {
            throw badValue(text);
        }
        return canonical;
    }

    /** A class of the user's own may be in the package of the example controllers, too, so only known names lose it. */
    private String withoutPackageIfShipped(String value) {
        if (type != ParameterType.CLASS || !value.startsWith(EXAMPLE_CONTROLLERS)) {
            return value;
        }
        String simple = value.substring(EXAMPLE_CONTROLLERS.length());
        return simple.equals(defaultValue) || allowed.choices().contains(simple) ? simple : value;
    }

    /** Whether {@link #check} lets a value pass. */
    boolean accepts(String text) {
        try {
            check(text);
            return true;
        } catch (UserError e) {
            return false;
        }
    }

    /** Whether the parameter influences how a network plays, and not only its evolution. */
    boolean decidesGames() {
        return name.equals("task") || !OF_EVOLUTION_ALONE.contains(group);
    }

    /** Returns a description of the allowed values. */
    public String allowedInWords() {
        return allowed.describe(type);
    }

    /** Returns the allowed words; empty if every text is allowed. */
    public List<String> choices() {
        return type == ParameterType.BOOLEAN ? List.of("false", "true") : allowed.choices();
    }

    /** Whether it is a parameter of the original. */
    public boolean isOfOriginal() {
        return !group.equals(EVERYDAY);
    }

    UserError badValue(String text) {
        return new UserError(OriginalCounterparts.ofParameter(name, text)
                .map(counterpart -> name + "=" + text + ": not supported; " + counterpart)
                .orElse(name + "=" + text + ": must be " + allowed.describe(type, text)
                        + NearestName.suggestion(text, allowed.choices())));
    }
}
