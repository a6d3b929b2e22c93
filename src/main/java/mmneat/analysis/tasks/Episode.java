package mmneat.analysis.tasks;

/**
 * The counts of one game. A task is a subtask of the game, such as eating pills.
 *
 * @param steps decisions of the player, at least 1
 * @param switches steps in which another set of tasks was to be done than in the step before. A step without any task
 *     counts as if the tasks of the step before were still to be done
 * @param overlaps at index [i][j]: steps in which tasks i and j were both to be done; at [i][i]: steps of task i
 * @param overlapping steps in which two or more tasks were to be done
 * @param score points of the game
 */
public record Episode(int steps, int switches, int[][] overlaps, int overlapping, int score) {

    /** Switches per time step. */
    public double thrashingRate() {
        return (double) switches / steps;
    }

    /** Counts one game, state after state. */
    static final class Counter {

        private final int tasks;
        private final int[][] overlaps;
        private int steps;
        private int switches;
        private int overlapping;

        /** Tasks of the last step that had any. */
        private int last;

        Counter(int tasks) {
            this.tasks = tasks;
            overlaps = new int[tasks][tasks];
        }

        /** @param present tasks that are to be done in this step, as bits */
        void step(int present) {
            steps++;
            overlapping += Integer.bitCount(present) > 1 ? 1 : 0;
            for (int i = 0; i < tasks; i++) {
                for (int j = 0; j < tasks; j++) {
                    overlaps[i][j] += (present >>> i & present >>> j & 1);
                }
            }
            if (present == 0) {
                return;
            }
            switches += last != 0 && present != last ? 1 : 0;
            last = present;
        }

        Episode finish(int score) {
            return new Episode(steps, switches, overlaps, overlapping, score);
        }
    }
}
