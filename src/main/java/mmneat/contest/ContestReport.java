package mmneat.contest;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import mmneat.contest.ContestResult.Punctuality;
import mmneat.contest.ContestResult.Repetition;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;

/** Formats the result of a contest as lines of text. */
public final class ContestReport {

    private ContestReport() {}

    /**
     * Returns the lines; empty if no game counts.
     *
     * @param rulesName name of the rules
     * @param seconds wall-clock time of the games
     */
    public static List<String> lines(ContestSettings settings, ContestResult result, String rulesName, double seconds) {
        if (result.scores().isEmpty()) {
            return List.of();
        }
        List<String> lines = new ArrayList<>();
        int games = result.scores().size();
        lines.add(settings.pacMan().name() + " against " + settings.ghosts().name() + ", "
                + (games == settings.games() ? "" : games + " of ")
                + settings.games() + (settings.games() == 1 ? " game" : " games") + ", seed " + settings.seed()
                + ", rules "
                + rulesName + inWords(settings.timing()));
        lines.add(scores(result.scores()));
        lines.add(String.format(
                Locale.ROOT,
                "steps: %d, %.0f per second, without the time for loading the mazes",
                result.steps(),
                result.steps() / Math.max(seconds, 1e-9)));
        if (settings.timing() != Timing.NONE) {
            lines.add("Ms. Pac-Man: " + punctuality(result.pacMan()));
            lines.add("ghosts: " + punctuality(result.ghosts()));
        }
        if (!result.failures().isEmpty()) {
            lines.add(failures(settings, result.failures()));
        }
        boolean hasEntries = !settings.pacMan().origin().isEmpty()
                || !settings.ghosts().origin().isEmpty();
        if (hasEntries) {
            lines.add("classes: " + origin(settings.pacMan()) + "; " + origin(settings.ghosts()));
        }
        result.repetition().map(ContestReport::repetition).ifPresent(lines::add);
        return lines;
    }

    private static String inWords(Timing timing) {
        return switch (timing) {
            case NONE -> "";
            case REAL_TIME -> ", timed, 40 ms per step";
            case UNTIL_ANSWERED -> ", timed, at most 40 ms per step";
        };
    }

    private static String scores(List<Integer> scores) {
        SummaryStatistics statistics = new SummaryStatistics();
        scores.forEach(statistics::addValue);
        return String.format(
                Locale.ROOT,
                "score: mean %.1f, standard deviation %s, minimum %.0f, maximum %.0f",
                statistics.getMean(),
                scores.size() == 1 ? "-" : String.format(Locale.ROOT, "%.1f", statistics.getStandardDeviation()),
                statistics.getMin(),
                statistics.getMax());
    }

    private static String punctuality(Punctuality side) {
        return String.format(
                Locale.ROOT,
                "late answers %d, exceptions %d, repeated moves %d of %d",
                side.lateAnswers(),
                side.exceptions(),
                side.repeatedMoves(),
                side.steps());
    }

    private static String failures(ContestSettings settings, List<GameFailure> failures) {
        String count = failures.size() == 1 ? "1 game failed" : failures.size() + " games failed";
        String consequence =
                switch (settings.onFailure()) {
                    case STOP -> "the contest ended there";
                    case SKIP -> failures.size() == 1 ? "it is left out" : "they are left out";
                    case SCORE0 -> failures.size() == 1 ? "it counts with score 0" : "they count with score 0";
                };
        GameFailure first = failures.get(0);
        return "failures: " + count + ", " + consequence + "; game " + first.game() + ": " + first.sentence();
    }

    private static String origin(Contestant<?> side) {
        return side.name() + " from " + (side.origin().isEmpty() ? "this program" : side.origin());
    }

    private static String repetition(Repetition twice) {
        if (twice.isSame()) {
            return String.format(
                    Locale.ROOT,
                    "check: game %d gave the same result when it was repeated: score %d, %d steps",
                    twice.game(),
                    twice.score(),
                    twice.steps());
        }
        return String.format(
                Locale.ROOT,
                "check: the scores are not reproducible: game %d scored %d in %d steps, repeated %s in %d steps;"
                        + " a controller uses its own random generator, reads the clock, or keeps data between games",
                twice.game(),
                twice.score(),
                twice.steps(),
                twice.scoreAgain().map(String::valueOf).orElse("it failed"),
                twice.stepsAgain());
    }
}
