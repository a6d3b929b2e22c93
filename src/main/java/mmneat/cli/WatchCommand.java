package mmneat.cli;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.atomic.AtomicReference;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.Rules;
import mmneat.analysis.replay.GameGif;
import mmneat.analysis.replay.GameRecording;
import mmneat.analysis.replay.GameWindow;
import mmneat.analysis.replay.Replay;
import mmneat.analysis.replay.ReplayPage;
import mmneat.analysis.replay.ReplayTitle;
import mmneat.cli.options.ChampionChoice;
import mmneat.cli.options.DelayOption;
import mmneat.cli.options.GhostsOption;
import mmneat.cli.options.JarOption;
import mmneat.cli.options.RulesOption;
import mmneat.cli.options.TaskOption;
import mmneat.cli.output.Display;
import mmneat.cli.output.OutputFile;
import mmneat.cli.output.ProgressTicker;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTaskSettings;
import org.jspecify.annotations.Nullable;
import pacman.game.MachineFonts;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The command {@code watch}: a network plays a game, and a page that shows the game is written. */
@Command(
        name = "watch",
        customSynopsis = "mmneat watch [FILE] [name=value...]",
        description = {
            "Plays a game with a network and writes it as a web page.",
            "",
            "The page shows the maze, the deciding module, the sensors and the network at every step. It "
                    + "is one file that a browser opens from disk. FILE is the folder of a run (its champion) or "
                    + "the file of a network, of this program or of the original.",
            "",
            "Example: mmneat watch champion=blended",
            "Example: mmneat watch results/blended/2M0 out=game.html seed=3",
            "Example: mmneat watch champion=interleaved out=game.gif",
            "",
        })
final class WatchCommand extends ConsoleCommand implements Runnable {

    @Parameters(arity = "0..1", paramLabel = "FILE", description = "Folder of a run, or file of a network.")
    private @Nullable Path file;

    @Mixin
    private ChampionChoice choice;

    @Option(
            names = "out",
            paramLabel = "FILE",
            description =
                    "The page to write, or an animated picture if the name ends in .gif (default: named after task"
                            + " and network, with .html, in this folder).")
    private @Nullable Path out;

    @Option(
            names = "window",
            paramLabel = "true|false",
            arity = "1",
            defaultValue = "false",
            description = "Shows the game in a window instead of writing it; the space bar pauses it"
                    + " (default: ${DEFAULT-VALUE}).")
    private boolean window;

    @Mixin
    private DelayOption delay;

    @Option(
            names = "seed",
            paramLabel = "N",
            defaultValue = "0",
            description = "Seed of the game: the same seed gives the same game (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Mixin
    private RulesOption rulesOption;

    @Mixin
    private TaskOption task;

    @Mixin
    private GhostsOption ghosts;

    @Mixin
    private JarOption jar;

    @Override
    public void run() {
        Champion champion = jar.allow(choice.read(file, null));
        Rules rules = rulesOption.rules();
        MsPacManTaskSettings settings = ghosts.settings(champion, task, rules);
        Path out = this.out == null ? Path.of(pageName(champion, settings) + ".html") : this.out;
        String name = out.toString().toLowerCase(Locale.ROOT);
        if (!name.matches(".*\\.(html?|gif)")) {
            throw new UserError("out=" + out + ": must end in .html (a page) or .gif (an animated picture)");
        }
        if (!window) {
            OutputFile.require("out", out);
            OutputFile.requireOther("out", out, "the network", champion.file());
        }
        requireEffect(
                "delay", window, "pages and pictures have their own speed (delay= is used only with window=true)");
        if (window) {
            showWindow(champion, settings);
        } else {
            Display.drawWithoutScreen();
            if (name.endsWith(".gif")) {
                writeGif(out, champion, settings);
            } else {
                writePage(out, champion, settings, rules);
            }
        }
        out().flush();
    }

    /**
     * Returns the file name of the page. It contains the task, because runs of different tasks can have the same name.
     */
    private static String pageName(Champion champion, MsPacManTaskSettings settings) {
        return champion.runFolder().isPresent()
                ? settings.games().version().label() + "-" + champion.name()
                : champion.name();
    }

    private void showWindow(Champion champion, MsPacManTaskSettings settings) {
        if (isGiven("out")) {
            throw new UserError("window=true shows the game and writes no file; leave out either window= or out=");
        }
        if (!Display.isThere()) {
            throw new UserError("window=true needs a display, and there is none; write out=game.html or out=game.gif");
        }
        int score = GameWindow.show(settings, champion.genotype(), seed, delay.milliseconds());
        out().printf(Locale.ROOT, "%s: %,d points%n", champion.label(), score);
    }

    private void writeGif(Path out, Champion champion, MsPacManTaskSettings settings) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        int frames;
        AtomicReference<String> line = new AtomicReference<>("watch: playing");
        try {
            frames = ProgressTicker.during(
                    notes(),
                    () -> List.of(line.get()),
                    () -> GameGif.write(
                            settings,
                            champion.genotype(),
                            seed,
                            bytes,
                            (drawn, all) -> line.set("watch: frame " + drawn + " of about " + all)));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        OutputFile.write(out, bytes.toByteArray());
        out().printf(Locale.ROOT, "%s (%,d frames, %,d kB)%n", out, frames, bytes.size() / 1000);
        if (!MachineFonts.areAvailable()) {
            out().println("The picture has no text: " + MachineFonts.MISSING);
        }
    }

    private void writePage(Path out, Champion champion, MsPacManTaskSettings settings, Rules rules) {
        ReplayTitle title = new ReplayTitle(
                settings.games().version().label() + " · " + champion.label(),
                rules.label() + " rules, seed " + seed + ", network "
                        + champion.genotype().id());
        Replay replay = GameRecording.record(settings, champion.genotype(), seed, title);
        String page = ReplayPage.html(replay);
        OutputFile.write(out, page);
        out().printf(
                        Locale.ROOT,
                        "%s, %s: %,d points in %,d steps%n%s (%,d kB): open it in a browser%n",
                        champion.label(),
                        rules.label(),
                        replay.finalScore(),
                        replay.steps(),
                        out,
                        page.length() / 1000);
    }
}
