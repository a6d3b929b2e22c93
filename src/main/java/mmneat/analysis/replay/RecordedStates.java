package mmneat.analysis.replay;

import java.util.Locale;
import pacman.Recording;
import pacman.game.Game;
import pacman.game.GameRules;

/**
 * Converter of a {@link Recording} to a {@link Replay}. A recording is a file of state strings, one per time step, as
 * the command {@code play record=FILE} and the original's simulator write it. It says nothing about the controllers, so
 * the replay shows no network.
 */
public final class RecordedStates {

    private RecordedStates() {}

    /**
     * The recording as a replay. Each state becomes a step; its decision is the next move of Ms. Pac-Man. States after
     * the end of the last level are left out.
     *
     * @param rules the rules of the recorded game, or at least its mazes
     * @throws IllegalArgumentException if a state cannot be read, or belongs to another maze
     */
    public static Replay replay(Recording recording, GameRules rules, ReplayTitle title) {
        ReplayNetwork network = ReplayNetwork.none();
        ReplayRecorder recorder = new ReplayRecorder(network, 1);
        ReplayStep step = new ReplayStep(network);
        StateCapture capture = new StateCapture(recorder, step);
        recorder.startGame("");
        Game game = new Game(0, rules);
        boolean isCaptured = false;
        for (String state : recording.states()) {
            game.setGameState(state);
            if (game.getCurrentLevel() >= rules.levels().maximumLevel()) {
                break;
            }
            if (isCaptured) {
                step.module = 0;
                step.choice = game.getPacmanLastMoveMade().ordinal();
                recorder.record(step);
            }
            capture.capture(game);
            isCaptured = true;
        }
        if (!isCaptured) {
            throw new IllegalArgumentException("the recording has no state in a level of these rules");
        }
        // Not the score of the game, whose last state may be one that was left out.
        int score = step.score;
        step.module = -1;
        step.choice = ReplayStep.NO_MOVE;
        recorder.record(step);
        recorder.endGame(String.format(Locale.ROOT, "End of the recording · %,d points", score));
        return recorder.finish(title);
    }
}
