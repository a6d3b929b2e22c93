package mmneat.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.Rules;
import mmneat.analysis.replay.GameRecording;
import mmneat.analysis.replay.Replay;
import mmneat.analysis.replay.ReplayPage;
import mmneat.analysis.replay.ReplayTitle;
import mmneat.experiment.PublishedConfigurations;
import mmneat.mspacman.MsPacManTaskSettings;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Lets a network play a game and writes a page that shows it. */
@Command(
        name = "watch",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        customSynopsis = "mmneat watch [FILE] [name=value...]",
        description = {
            "Lets a network play Ms. Pac-Man and writes the game as a web page: the maze, the module in charge, the senses"
                    + " and the network at every step. The page needs no server and no network.",
            "",
            "FILE is the folder of a run (its champion) or the file of a network, ours or the original's.",
            "Example: mmneat watch champion=blended",
            "Example: mmneat watch results/blended/2M0 out=game.html seed=3",
            "",
        })
final class WatchCommand implements Runnable, WordCommand {

    @Spec
    private CommandSpec command;

    @Parameters(hidden = true, paramLabel = "FILE")
    private List<String> arguments = new ArrayList<>();

    @Override
    public List<Word> knownWords() {
        return List.of(
                ChosenChampion.WORD,
                new Word("out", "FILE", "the page to write (default: the network's name with .html, in this folder)"),
                new Word("seed", "0", "which game: the same seed gives the same game (default 0)"),
                new Word(
                        "rules",
                        String.join("|", Rules.labels()),
                        "the rules (default training: one life, as in evolution)"),
                new Word(
                        "task",
                        String.join("|", PublishedConfigurations.tasks()),
                        "version of the task (default: that of the run, or what the network's inputs say)"),
                new Word("ghosts", "FILE", "recorded ghost locations, for the isolated version"));
    }

    @Override
    public void run() {
        Words words = Words.parse(arguments, this, 1);
        Champion champion = ChosenChampion.of(words, null);
        Rules rules = Rules.of(words.text("rules", Rules.TRAINING.label()));
        long seed = words.longInteger("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE);
        MsPacManTaskSettings settings = ChampionWords.settings(words, champion, rules);
        ReplayTitle title = new ReplayTitle(
                settings.version().name().toLowerCase(java.util.Locale.ROOT) + " · " + champion.name(),
                rules.label() + " rules, seed " + seed + ", network "
                        + champion.genotype().id());
        Replay replay = GameRecording.record(settings, champion.genotype(), seed, title);
        Path out = words.path("out").orElse(Path.of(champion.name() + ".html"));
        String page = ReplayPage.html(replay);
        OutputFile.write(out, page);
        command.commandLine()
                .getOut()
                .printf(
                        java.util.Locale.ROOT,
                        "%s, %s: %,d points in %,d steps%n%s (%,d kB): open it in a browser%n",
                        champion.name(),
                        rules.label(),
                        replay.finalScore(),
                        replay.steps(),
                        out,
                        page.length() / 1000);
        command.commandLine().getOut().flush();
    }
}
