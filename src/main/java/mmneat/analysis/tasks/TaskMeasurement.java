package mmneat.analysis.tasks;

import java.util.List;
import mmneat.mspacman.TaskVersion;
import org.apache.commons.math3.stat.descriptive.DescriptiveStatistics;

/**
 * The measurements of the games (episodes) of one player, in one version of the Ms.&nbsp;Pac-Man task, for one division
 * of the game into subtasks.
 *
 * @param division the division into subtasks
 * @param episodes games that were played, at least one
 */
public record TaskMeasurement(TaskDivision division, List<Episode> episodes) {

    /**
     * The mean thrashing rate up to which tasks count as interleaved: the paper's bound for the interleaved version.
     */
    public static final double INTERLEAVED_BOUND = 0.01;

    public TaskMeasurement {
        episodes = List.copyOf(episodes);
        if (episodes.isEmpty()) {
            throw new IllegalArgumentException("there is no episode to measure");
        }
    }

    /** Thrashing rates of the episodes: their mean, standard deviation and maximum. */
    public DescriptiveStatistics thrashingRates() {
        return new DescriptiveStatistics(
                episodes.stream().mapToDouble(Episode::thrashingRate).toArray());
    }

    /** Steps of all episodes. */
    public long steps() {
        return episodes.stream().mapToLong(Episode::steps).sum();
    }

    /** Mean score of the episodes. */
    public double meanScore() {
        return episodes.stream().mapToInt(Episode::score).average().orElseThrow();
    }

    /** Share of all steps in which two or more tasks were to be done, in [0, 1]. */
    public double overlap() {
        return (double) episodes.stream().mapToLong(Episode::overlapping).sum() / steps();
    }

    /** Share of all steps in which both of two tasks were to be done; of a task with itself: its share of the steps. */
    public double share(int task, int other) {
        return (double) episodes.stream()
                        .mapToLong(episode -> episode.overlaps()[task][other])
                        .sum()
                / steps();
    }

    /**
     * The version that the episodes are examples of, as section 3 of the paper defines them: isolated if the task never
     * changes within an episode; interleaved if there is one task at a time and it changes seldom, at a mean thrashing
     * rate of at most {@value #INTERLEAVED_BOUND}; otherwise blended.
     */
    public TaskVersion version() {
        if (overlap() > 0) {
            return TaskVersion.BLENDED;
        }
        double mean = thrashingRates().getMean();
        if (mean == 0) {
            return TaskVersion.ISOLATED;
        }
        return mean <= INTERLEAVED_BOUND ? TaskVersion.INTERLEAVED : TaskVersion.BLENDED;
    }
}
