package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.Test;

class WordsTest {

    private static final List<String> NAMES = List.of("games", "seed", "pacman", "timed", "rate", "file");

    private static Words parse(String... words) {
        return Words.parse(List.of(words), NAMES);
    }

    @Test
    void bothSigns_giveTheSameValue() {
        assertThat(parse("games=3").integer("games", 1, 1, 9)).isEqualTo(3);
        assertThat(parse("games:3").integer("games", 1, 1, 9)).isEqualTo(3);
        assertThat(parse("pacman=a:b=c").text("pacman")).contains("a:b=c");
    }

    @Test
    void nameNotGiven_givesTheDefault() {
        Words words = parse();
        assertThat(words.has("games")).isFalse();
        assertThat(words.text("pacman")).isEmpty();
        assertThat(words.text("pacman", "Starter")).isEqualTo("Starter");
        assertThat(words.integer("games", 7, 1, 9)).isEqualTo(7);
        assertThat(words.longInteger("seed", 5, 0, Long.MAX_VALUE)).isEqualTo(5);
        assertThat(words.number("rate", 0.5, 0, 1)).isEqualTo(0.5);
        assertThat(words.flag("timed", true)).isTrue();
        assertThat(words.path("file")).isEmpty();
        assertThat(words.choice("pacman", "A", List.of("A", "B"))).isEqualTo("A");
    }

    @Test
    void valuesGiven_areRead() {
        Words words = parse("seed=-12", "rate=0.25", "timed=TRUE", "file=a/b.txt", "pacman=b", "games=10_000");
        assertThat(words.longInteger("seed", 0, Long.MIN_VALUE, Long.MAX_VALUE)).isEqualTo(-12);
        assertThat(words.number("rate", 0, 0, 1)).isEqualTo(0.25);
        assertThat(words.flag("timed", false)).isTrue();
        assertThat(words.path("file")).contains(Path.of("a", "b.txt"));
        assertThat(words.choice("pacman", "A", List.of("A", "B"))).isEqualTo("B");
        assertThat(words.integer("games", 1, 1, Integer.MAX_VALUE)).isEqualTo(10_000);
        assertThat(words.named()).containsEntry("seed", "-12").hasSize(6);
    }

    @Test
    void unknownName_suggestsTheNearest() {
        assertThatThrownBy(() -> parse("gmaes=3"))
                .isInstanceOf(UserError.class)
                .hasMessage("unknown name 'gmaes' (did you mean 'games'?)");
        assertThatThrownBy(() -> parse("zzzzzzz=3"))
                .hasMessage("unknown name 'zzzzzzz'; known: games, seed, pacman, timed, rate, file");
    }

    @Test
    void nameGivenTwice_isAnError() {
        assertThatThrownBy(() -> parse("games=3", "games:4")).hasMessage("'games' is given twice; give it once");
    }

    @Test
    void plainWord_isTakenOnlyWhereTheCommandWantsOne() {
        assertThatThrownBy(() -> parse("game.txt")).hasMessage("'game.txt' is not understood; write name=value");
        assertThat(Words.parse(List.of("game.txt", "seed=1"), NAMES, 1).plain()).containsExactly("game.txt");
        assertThat(Words.parse(List.of("C:\\game.txt"), NAMES, 1).plain()).containsExactly("C:\\game.txt");
        assertThatThrownBy(() -> Words.parse(List.of("sed=1"), NAMES, 1)).hasMessageContaining("'seed'");
        assertThatThrownBy(() -> Words.parse(List.of("a.txt", "b.txt"), NAMES, 1))
                .hasMessageContaining("b.txt");
    }

    @Test
    void valueThatDoesNotFit_saysWhatIsAllowed() {
        assertThatThrownBy(() -> parse("games=0").integer("games", 1, 1, 9))
                .hasMessage("games=0: must be a whole number from 1 to 9");
        assertThatThrownBy(() -> parse("games=x").integer("games", 1, 1, Integer.MAX_VALUE))
                .hasMessage("games=x: must be a whole number, at least 1");
        assertThatThrownBy(() -> parse("seed=x").longInteger("seed", 1, Long.MIN_VALUE, Long.MAX_VALUE))
                .hasMessage("seed=x: must be a whole number");
        assertThatThrownBy(() -> parse("rate=NaN").number("rate", 1, 0, 1))
                .hasMessage("rate=NaN: must be a number from 0.0 to 1.0");
        assertThatThrownBy(() -> parse("rate=1,5").number("rate", 1, 0, 2))
                .hasMessage("rate=1,5: must be a number from 0.0 to 2.0");
        assertThatThrownBy(() -> parse("timed=yes").flag("timed", false))
                .hasMessage("timed=yes: must be true or false");
        assertThatThrownBy(() -> parse("pacman=Leagcy").choice("pacman", "", List.of("Legacy", "B")))
                .hasMessage("pacman=Leagcy: must be one of Legacy, B (did you mean 'Legacy'?)");
        assertThatThrownBy(() -> parse("file=").path("file")).hasMessage("file=: must be the name of a file or folder");
        assertThatThrownBy(() -> parse().requiredText("file", "run.txt"))
                .hasMessage("'file' is missing; give it as file=run.txt");
    }
}
