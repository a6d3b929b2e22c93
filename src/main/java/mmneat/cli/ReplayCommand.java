package mmneat.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import mmneat.analysis.replay.RecordedStates;
import mmneat.analysis.replay.ReplayPage;
import mmneat.analysis.replay.ReplayTitle;
import mmneat.cli.options.DelayOption;
import mmneat.cli.options.GameOptions;
import mmneat.cli.output.Display;
import mmneat.cli.output.OutputFile;
import mmneat.experiment.FileErrors;
import mmneat.experiment.UserError;
import org.jspecify.annotations.Nullable;
import pacman.Executor;
import pacman.Recording;
import pacman.game.Game;
import pacman.game.GameRules;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/**
 * The command {@code replay}: shows a recorded game in a window or as a page. The recording is a file that {@code play
 * record=FILE} has written. It holds the states of the game only, of any two controllers; the command {@code watch}
 * plays a new game with a network and also shows the network.
 */
@Command(
        name = "replay",
        customSynopsis = "mmneat replay FILE [name=value...]",
        description = {
            "Shows a recorded game in a window, or writes it as a web page.",
            "A recording is a file that play record=FILE or an executor has written.",
            "",
            "Example: mmneat replay game.txt delay=10",
            "Example: mmneat replay game.txt out=game.html",
            "",
        })
final class ReplayCommand extends ConsoleCommand implements Runnable {

    @Parameters(arity = "0..1", paramLabel = "FILE", description = "The recording.")
    private @Nullable Path file;

    @Mixin
    private DelayOption delay;

    @Option(
            names = "view",
            paramLabel = "true|false",
            arity = "1",
            defaultValue = "true",
            description = "false only checks the recording and prints how the game ended (default: ${DEFAULT-VALUE}).")
    private boolean wantsView;

    @Option(
            names = "out",
            paramLabel = "FILE",
            description = "Writes the game as a web page (.html) instead of showing it; needs no display.")
    private @Nullable Path out;

    @Mixin
    private GameOptions game;

    @Override
    public void run() {
        if (file == null) {
            throw new UserError("the recording is missing; write replay FILE");
        }
        if (out != null && !out.toString().toLowerCase(Locale.ROOT).matches(".*\\.html?")) {
            throw new UserError("out=" + out + ": must end in .html (a page)");
        }
        if (out != null) {
            OutputFile.require("out", out);
            OutputFile.requireOther("out", out, "the recording", file);
        }
        requireEffect("delay", out == null, "a page has its own speed");
        boolean view = wantsView && out == null && Display.isThere();
        Recording recording = load(file);
        if (wantsView && out == null && !view) {
            notes().println(
                            "mmneat: there is no display, so the game is not shown; write it as a page with out=game.html");
        }
        GameRules rules = game.rules(recording.rules());
        try {
            Game replayed = new Executor().replayGame(recording, rules, view, view ? delay.milliseconds() : 0);
            boolean isWon = replayed.getCurrentLevel() >= rules.levels().maximumLevel();
            out().println(recording.states().size() + " states: score " + replayed.getScore() + ", "
                    + (isWon
                            ? "all " + rules.levels().maximumLevel() + " levels"
                            : "level " + (replayed.getCurrentLevel() + 1))
                    + ", time " + replayed.getTotalTime() + ", lives " + replayed.getPacmanNumberOfLivesRemaining());
            if (out != null) {
                ReplayTitle title = new ReplayTitle(
                        String.valueOf(file.getFileName()),
                        "recorded game, " + recording.states().size() + " states");
                OutputFile.write(out, ReplayPage.html(RecordedStates.replay(recording, rules, title)));
                out().println(out + ": open it in a browser");
            }
        } catch (IllegalArgumentException e) {
            String hint = game.hasMaze() ? "" : "; a game in a maze of your own needs the same maze=FILE";
            throw new UserError(file + ": " + e.getMessage() + hint, e);
        }
    }

    private static Recording load(Path file) {
        try {
            Recording recording = Recording.load(file);
            recording.requireContinuous();
            return recording;
        } catch (IOException e) {
            throw FileErrors.unreadable(file, e);
        } catch (IllegalArgumentException e) {
            throw new UserError(file + ": " + e.getMessage(), e);
        }
    }
}
