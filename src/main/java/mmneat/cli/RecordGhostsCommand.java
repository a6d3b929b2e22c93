package mmneat.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.PlayerSettings;
import mmneat.analysis.evaluation.Rules;
import mmneat.analysis.recording.GhostLocationRecorder;
import mmneat.cli.options.ChampionChoice;
import mmneat.cli.options.JarOption;
import mmneat.cli.options.Range;
import mmneat.cli.options.TaskOption;
import mmneat.cli.output.OutputFile;
import mmneat.cli.output.ProgressTicker;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/**
 * The command {@code record-ghosts}: records the locations of the ghosts when a champion eats power pills, for the
 * isolated task.
 */
@Command(
        name = "record-ghosts",
        customSynopsis = "mmneat record-ghosts [FILE] [name=value...]",
        description = {
            "Records ghost locations for the isolated task.",
            "",
            "A champion plays until enough of its power pills were eaten in every maze while all four "
                    + "ghosts were outside the lair and none was edible. Each such moment becomes a line: maze, "
                    + "power pill and the nodes of the four ghosts. The isolated task starts its ghost games from "
                    + "these lines (mazePowerPillGhostMapping=FILE).",
            "",
            "Example: mmneat record-ghosts results/blended/2M0 out=ghost-locations.txt seed=1",
            "",
        })
final class RecordGhostsCommand extends ConsoleCommand implements Runnable {

    private static final String WHERE_MISSING = "missing";
    private static final List<String> MAZES = List.of("a", "b", "c", "d");

    private static final class Starts extends ArrayList<String> {
        Starts() {
            add(WHERE_MISSING);
            addAll(MAZES);
        }
    }

    @Parameters(
            arity = "0..1",
            paramLabel = "FILE",
            description = "Folder of a run, or file of a network (default: champion=blended).")
    private @Nullable Path file;

    @Mixin
    private ChampionChoice choice;

    @Option(
            names = "out",
            paramLabel = "FILE",
            defaultValue = "ghost-locations.txt",
            description = "The file to write (default: ${DEFAULT-VALUE}).")
    private Path out;

    @Option(
            names = "seed",
            paramLabel = "N",
            defaultValue = "0",
            description = "Seed of all games (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(
            names = "situations",
            paramLabel = "N",
            defaultValue = "100",
            description = "Lines for each power pill; the isolated task needs 100 (default: ${DEFAULT-VALUE}).")
    @Range(min = 1, max = 1_000_000)
    private int situations;

    @Option(
            names = "games",
            paramLabel = "N",
            defaultValue = "20000",
            description = "Gives up after this number of games (default: ${DEFAULT-VALUE}).")
    @Range(min = 1)
    private int games;

    @Option(
            names = "start",
            paramLabel = "MAZE",
            defaultValue = WHERE_MISSING,
            completionCandidates = Starts.class,
            description = "Maze in which games start: a, b, c, d (a: as in the original), or " + WHERE_MISSING
                    + ": the maze of the power pill with the fewest lines so far (default: ${DEFAULT-VALUE}).")
    private String start;

    @Mixin
    private TaskOption task;

    @Mixin
    private JarOption jar;

    @Override
    public void run() {
        Champion champion = jar.allow(choice.read(file, TaskVersion.BLENDED.label()));
        OutputFile.require("out", out);
        OutputFile.requireOther("out", out, "the network", champion.file());
        MsPacManTaskSettings settings = PlayerSettings.of(champion, task.version(), Rules.TRAINING, Optional.empty());
        if (settings.games().version() == TaskVersion.ISOLATED) {
            throw new UserError("the games of the isolated version have no power pills to be eaten; record with"
                    + " task=blended or task=interleaved, or another champion");
        }
        GhostLocationRecorder recorder = new GhostLocationRecorder(settings, champion.genotype(), situations, seed);
        AtomicReference<String> line = new AtomicReference<>("record-ghosts: 0 games");
        ProgressTicker.during(notes(), () -> List.of(line.get()), () -> play(recorder, line));
        if (!recorder.isComplete()) {
            Path part = Path.of(out + ".incomplete");
            OutputFile.write(part, recorder.text());
            throw new UserError("gave up after " + recorder.games() + " games, with " + recorder.recorded() + " of "
                    + recorder.wantedInAll() + " situations in " + part + "; still missing: " + recorder.missing()
                    + "; give more games=, another seed= or a better champion");
        }
        OutputFile.write(out, recorder.text());
        PrintWriter lines = out();
        lines.println(out + ": " + recorder.recorded() + " situations from " + recorder.games() + " games of "
                + champion.label() + "; use it with mazePowerPillGhostMapping=" + out);
        lines.flush();
    }

    private GhostLocationRecorder play(GhostLocationRecorder recorder, AtomicReference<String> line) {
        boolean whereMissing = start.equals(WHERE_MISSING);
        while (!recorder.isComplete() && recorder.games() < games) {
            recorder.playGame(whereMissing ? recorder.scarcestMaze() : MAZES.indexOf(start));
            line.set("record-ghosts: " + recorder.games() + " games, " + recorder.recorded() + " of "
                    + recorder.wantedInAll() + " situations, fewest: " + recorder.scarcestPowerPill());
        }
        return recorder;
    }
}
