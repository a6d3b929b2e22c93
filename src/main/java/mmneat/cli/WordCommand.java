package mmneat.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import mmneat.experiment.UserError;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** A command that is told what to do by {@code name=value} words; its {@code --help} lists them. */
@Command(mixinStandardHelpOptions = true, sortOptions = false)
abstract class WordCommand {

    /** More experiments than anyone names. */
    private static final int MOST_EXPERIMENTS = 1000;

    @Spec
    private CommandSpec command;

    @Parameters(hidden = true, paramLabel = "name=value")
    private List<String> arguments = new ArrayList<>();

    /** The words that the command understands, in the order of the help. */
    abstract List<Word> knownWords();

    /** The arguments as they were typed. */
    final List<String> arguments() {
        return List.copyOf(arguments);
    }

    /**
     * The arguments as words.
     *
     * @param plainWords how many words without a name there may be at most, for instance file names
     * @throws UserError if one is not known, or given twice
     */
    final Words words(int plainWords) {
        return Words.parse(arguments, knownWords().stream().map(Word::name).toList(), plainWords);
    }

    /** The arguments of a command whose plain words name experiments. */
    final Words wordsAboutExperiments() {
        return words(MOST_EXPERIMENTS);
    }

    /** The words that name experiments; at least one. */
    final List<Path> experimentPaths(Words words) {
        if (words.plain().isEmpty()) {
            throw new UserError(
                    "no experiment is given; write mmneat " + command.name() + " results/blended, for example");
        }
        return words.plain().stream().map(Path::of).toList();
    }

    /** Where results go. */
    final PrintWriter out() {
        return command.commandLine().getOut();
    }

    /** Where remarks and progress go. */
    final PrintWriter notes() {
        return command.commandLine().getErr();
    }
}
