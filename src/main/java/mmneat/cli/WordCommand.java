package mmneat.cli;

import java.util.List;

/** A command that is told what to do by {@code name=value} words; its {@code --help} lists them. */
interface WordCommand {

    /** The words that the command understands, in the order of the help. */
    List<Word> knownWords();
}
