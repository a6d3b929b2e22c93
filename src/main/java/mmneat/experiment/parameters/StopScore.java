package mmneat.experiment.parameters;

import java.util.Map;
import mmneat.experiment.UserError;

/** The champion score at which a run ends before its last generation: the parameter {@code stopAt}. */
public final class StopScore {

    private static final String STOP_AT = "stopAt";

    private StopScore() {}

    /**
     * Returns the score; infinity if the parameters give none.
     *
     * @throws UserError if it is not a number
     */
    public static double of(Map<String, String> parameters) {
        String text = parameters.getOrDefault(STOP_AT, "");
        if (text.isEmpty()) {
            return Double.POSITIVE_INFINITY;
        }
        double score = parsed(text);
        if (Double.isNaN(score)) {
            throw new UserError(STOP_AT + "=" + text + ": must be a number");
        }
        return score;
    }

    private static double parsed(String text) {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }
}
