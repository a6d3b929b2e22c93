package mmneat.cli;

import java.nio.file.Path;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.experiment.UserError;

/** The network that a command is about: a plain word names its run or file, {@code champion=} one that comes with the program. */
final class ChosenChampion {

    static final Word WORD = new Word(
            "champion",
            String.join("|", ShippedChampions.versions()),
            "instead of FILE: the champion of this version of the task that comes with the program");

    private ChosenChampion() {}

    /**
     * The champion that is asked for.
     *
     * @param otherwise version of the shipped champion to take if none is; null if that is a mistake
     * @throws UserError if none, or more than one, is named
     */
    static Champion of(Words words, String otherwise) {
        if (!words.plain().isEmpty()) {
            if (words.has(WORD.name())) {
                throw new UserError("both a file and champion= are given; give one of them");
            }
            return Champion.read(Path.of(words.plain().get(0)));
        }
        if (!words.has(WORD.name()) && otherwise == null) {
            throw new UserError("no network is given; name a run's folder or a file, or write champion="
                    + String.join("|", ShippedChampions.versions()));
        }
        return ShippedChampions.read(words.choice(WORD.name(), otherwise, ShippedChampions.versions()));
    }
}
