package mmneat.cli;

import java.awt.GraphicsEnvironment;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import mmneat.experiment.UserError;
import pacman.Executor;
import pacman.Recording;
import pacman.game.Constants;
import pacman.game.Game;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Shows a recorded game. */
@Command(
        name = "replay",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        customSynopsis = "mmneat replay FILE [name=value...]",
        description = {
            "Shows a recording that play record=FILE or an executor has written.",
            "",
            "Example: mmneat replay game.txt delay=10",
            "",
        })
final class ReplayCommand implements Runnable, WordCommand {

    private static final int LONGEST_DELAY_MILLISECONDS = 60_000;

    @Spec
    private CommandSpec command;

    @Parameters(hidden = true)
    private List<String> arguments = new ArrayList<>();

    @Override
    public List<Word> knownWords() {
        List<Word> own = List.of(
                new Word("delay", "40", "milliseconds per step (default 40)"),
                new Word("view", "false", "only checks the recording and tells how it ended (default true)"));
        return Stream.concat(own.stream(), GameWords.KNOWN.stream()).toList();
    }

    @Override
    public void run() {
        Words words = Words.parse(arguments, this, 1);
        if (words.plain().isEmpty()) {
            throw new UserError("the recording is missing; write replay FILE");
        }
        Path file = Path.of(words.plain().get(0));
        int delay = words.integer("delay", Constants.DELAY, 0, LONGEST_DELAY_MILLISECONDS);
        boolean wantsView = words.flag("view", true);
        boolean view = wantsView && !GraphicsEnvironment.isHeadless();
        try {
            Recording recording = Recording.load(file);
            if (wantsView && !view) {
                command.commandLine().getErr().println("mmneat: there is no display, so the game is not shown");
            }
            Game game = new Executor()
                    .replayGame(recording, GameWords.rules(words, recording.rules()), view, view ? delay : 0);
            command.commandLine()
                    .getOut()
                    .println(recording.states().size() + " steps: score " + game.getScore() + ", level "
                            + (game.getCurrentLevel() + 1) + ", time " + game.getTotalTime() + ", lives "
                            + game.getPacmanNumberOfLivesRemaining());
        } catch (IOException e) {
            throw new UserError("cannot read " + file + ": " + GameWords.reason(e), e);
        } catch (IllegalArgumentException e) {
            throw new UserError(file + ": " + e.getMessage(), e);
        }
    }
}
