package mmneat.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import mmneat.experiment.FileTrouble;
import mmneat.experiment.UserError;
import pacman.Executor;
import pacman.Recording;
import pacman.game.Constants;
import pacman.game.Game;
import pacman.game.GameRules;
import picocli.CommandLine.Command;

/** Shows a recorded game. */
@Command(
        name = "replay",
        customSynopsis = "mmneat replay FILE [name=value...]",
        description = {
            "Shows a recording that play record=FILE or an executor has written.",
            "",
            "Example: mmneat replay game.txt delay=10",
            "",
        })
final class ReplayCommand extends WordCommand implements Runnable {

    private static final int LONGEST_DELAY_MILLISECONDS = 60_000;

    @Override
    List<Word> knownWords() {
        List<Word> own = List.of(
                new Word("delay", "40", "milliseconds per step (default 40)"),
                new Word("view", "false", "only checks the recording and tells how it ended (default true)"));
        return Stream.concat(own.stream(), GameWords.KNOWN.stream()).toList();
    }

    @Override
    public void run() {
        Words words = words(1);
        if (words.plain().isEmpty()) {
            throw new UserError("the recording is missing; write replay FILE");
        }
        Path file = Path.of(words.plain().get(0));
        int delay = words.integer("delay", Constants.DELAY, 0, LONGEST_DELAY_MILLISECONDS);
        boolean wantsView = words.flag("view", true);
        boolean view = wantsView && Display.isThere();
        Recording recording = load(file);
        if (wantsView && !view) {
            notes().println("mmneat: there is no display, so the game is not shown");
        }
        GameRules rules = GameWords.rules(words, recording.rules());
        try {
            Game game = new Executor().replayGame(recording, rules, view, view ? delay : 0);
            boolean isWon = game.getCurrentLevel() >= rules.maximumLevel();
            out().println(recording.states().size() + " states: score " + game.getScore() + ", "
                    + (isWon ? "all " + rules.maximumLevel() + " levels" : "level " + (game.getCurrentLevel() + 1))
                    + ", time " + game.getTotalTime() + ", lives " + game.getPacmanNumberOfLivesRemaining());
        } catch (IllegalArgumentException e) {
            String hint = words.has("maze") ? "" : "; a game in a maze of your own needs the same maze=FILE";
            throw new UserError(file + ": " + e.getMessage() + hint, e);
        }
    }

    private static Recording load(Path file) {
        try {
            return Recording.load(file);
        } catch (IOException e) {
            throw new UserError("cannot read " + file + ": " + FileTrouble.reason(e), e);
        } catch (IllegalArgumentException e) {
            throw new UserError(file + ": " + e.getMessage(), e);
        }
    }
}
