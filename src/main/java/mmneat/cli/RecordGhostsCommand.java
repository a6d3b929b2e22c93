package mmneat.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.Rules;
import mmneat.analysis.recording.GhostLocationRecorder;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.PublishedConfigurations;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;
import picocli.CommandLine.Command;

/** Records where the ghosts are when a champion eats power pills, for the isolated task. */
@Command(
        name = "record-ghosts",
        customSynopsis = "mmneat record-ghosts [FILE] [name=value...]",
        description = {
            "Lets a champion play until every power pill of every maze has been eaten often enough while all four ghosts were"
                    + " outside the lair and none was edible, and writes where the ghosts were: one line each, maze, power"
                    + " pill and four nodes. The isolated task starts its ghost games from them"
                    + " (mazePowerPillGhostMapping=FILE).",
            "",
            "FILE is the folder of a run (its champion) or the file of a network; default: the blended champion that comes"
                    + " with the program.",
            "Example: mmneat record-ghosts results/blended/2M0 out=ghost-locations.txt seed=1",
            "",
        })
final class RecordGhostsCommand extends WordCommand implements Runnable {

    private static final String DEFAULT_OUT = "ghost-locations.txt";
    private static final int NEEDED = 100;
    private static final int MOST_GAMES = 20_000;
    private static final int PROGRESS_SECONDS = 5;
    private static final String WHERE_MISSING = "missing";
    private static final List<String> STARTS = List.of(WHERE_MISSING, "a", "b", "c", "d");

    @Override
    List<Word> knownWords() {
        return List.of(
                ChosenChampion.WORD,
                new Word("out", "FILE", "the file to write (default " + DEFAULT_OUT + ")"),
                new Word("seed", "0", "seed of all games (default 0)"),
                new Word("situations", "100", "lines for each power pill (default and need of the isolated task: 100)"),
                new Word("games", "20000", "gives up after so many games (default " + MOST_GAMES + ")"),
                new Word(
                        "start",
                        String.join("|", STARTS),
                        "the maze in which games start; " + WHERE_MISSING
                                + ": each where the scarcest power pill is (default); a: as in the original"),
                new Word(
                        "task",
                        String.join("|", PublishedConfigurations.tasks()),
                        "version of the games (default: that of the run, or what the network's inputs say)"));
    }

    @Override
    public void run() {
        Words words = words(1);
        Champion champion = ChosenChampion.of(words, "blended");
        Path out = words.path("out").orElse(Path.of(DEFAULT_OUT));
        OutputFile.require("out", out);
        MsPacManTaskSettings settings = ChampionWords.settings(words, champion, Rules.TRAINING);
        if (settings.version() == TaskVersion.ISOLATED) {
            throw new UserError("the games of the isolated version have no power pills to be eaten; record with"
                    + " task=blended or task=interleaved, or another champion");
        }
        GhostLocationRecorder recorder = new GhostLocationRecorder(
                settings,
                champion.genotype(),
                words.integer("situations", NEEDED, 1, 1_000_000),
                words.longInteger("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE));
        String start = words.choice("start", WHERE_MISSING, STARTS);
        play(recorder, start, words.integer("games", MOST_GAMES, 1, Integer.MAX_VALUE));
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
                + champion.name() + "; use it with mazePowerPillGhostMapping=" + out);
        lines.flush();
    }

    private void play(GhostLocationRecorder recorder, String start, int games) {
        PrintWriter notes = notes();
        long interval = TimeUnit.SECONDS.toNanos(PROGRESS_SECONDS);
        long nextProgress = System.nanoTime() + interval;
        while (!recorder.isComplete() && recorder.games() < games) {
            boolean whereMissing = start.equals(WHERE_MISSING);
            recorder.playGame(whereMissing ? recorder.scarcestMaze() : STARTS.indexOf(start) - 1);
            if (System.nanoTime() > nextProgress) {
                nextProgress += interval;
                notes.println("record-ghosts: " + recorder.games() + " games, " + recorder.recorded() + " of "
                        + recorder.wantedInAll() + " situations, fewest: " + recorder.scarcestPowerPill());
                notes.flush();
            }
        }
    }
}
