package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import mmneat.cli.options.Range;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The options of all commands: forms, types, ranges, unknown names, and the help. */
class OptionsTest extends CommandTest {

    /** Every option that is written {@code name=value}, with its command. */
    static Stream<Arguments> options() {
        return Main.commandLine().getSubcommands().values().stream()
                .map(CommandLine::getCommandSpec)
                .flatMap(command -> command.options().stream()
                        .filter(option -> !option.longestName().startsWith("-"))
                        .map(option -> Arguments.of(command.name(), option.longestName(), option)));
    }

    static Stream<String> commands() {
        return Main.commandLine().getSubcommands().keySet().stream();
    }

    private static boolean takesParameters(String command) {
        return List.of("submit", "process").contains(command);
    }

    @Test
    void everyCommandClass_isACommandOfMain_andOnAPage() throws IOException {
        List<String> sources = names(Path.of("src/main/java/mmneat/cli"), "Command.java");
        assertThat(sources).hasSizeGreaterThan(10);
        List<String> registered = Main.commandLine().getSubcommands().values().stream()
                .map(command -> command.getCommand().getClass().getSimpleName() + ".java")
                .toList();
        assertThat(registered)
                .containsAll(sources.stream()
                        .filter(source -> !source.startsWith("Console") && !source.startsWith("Shell"))
                        .toList());

        StringBuilder pages = new StringBuilder(Files.readString(Path.of("README.md")));
        for (String page : names(Path.of("docs"), ".md")) {
            pages.append(Files.readString(Path.of("docs", page)));
        }
        for (String command : Main.commandLine().getSubcommands().keySet()) {
            assertThat(pages).containsPattern("(mmneat|mmneat\\.jar|`)\\s?" + command + "\\b");
        }
    }

    private static List<String> names(Path folder, String ending) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString())
                    .filter(name -> name.endsWith(ending))
                    .toList();
        }
    }

    @ParameterizedTest(name = "{0} {1}")
    @MethodSource("options")
    void help_listsTheOption_andItsDefaultOnce(String command, String name, OptionSpec option) {
        assertThat(execute(command, "--help")).isZero();
        String help = out.toString();
        assertThat(help).contains(" " + name + "=" + option.paramLabel());
        assertThat(help).doesNotContain("${").doesNotContain("null");
        if (option.defaultValue() != null) {
            assertThat(option.description()[0]).contains("(default: " + option.defaultValue() + ")");
        }
    }

    @ParameterizedTest(name = "{0} {1}")
    @MethodSource("options")
    void valueOfAnotherType_isRefused_inBothForms(String command, String name, OptionSpec option) {
        boolean acceptsText = option.type() == String.class && option.completionCandidates() == null;
        String value = acceptsText || option.type() == Path.class ? null : "no-such-value";
        if (value != null) {
            assertMistake(name + "=" + value + ": must be ", command, name + "=" + value);
            assertMistake(name + "=" + value + ": must be ", command, name + ":" + value);
        }
        // jar= stands for the class path.
        if (option.type() == Path.class && !name.equals("jar")) {
            assertMistake(name + "=: must be the name of a file or folder", command, name + "=");
        }
    }

    @ParameterizedTest(name = "{0} {1}")
    @MethodSource("options")
    void misspelledName_isRefused_withTheNearest(String command, String name, OptionSpec option) {
        if (name.length() > 4 && !takesParameters(command)) {
            String typed = name.substring(0, name.length() - 1);
            assertMistake("unknown name '" + typed + "' (did you mean '" + name + "'?)", command, typed + "=1");
        }
    }

    @ParameterizedTest(name = "{0} {1}")
    @MethodSource("options")
    void nameWithoutValue_isRefused(String command, String name, OptionSpec option) {
        if (!takesParameters(command)) {
            assertMistake("'" + name + "' has no value; write " + name + "=...", command, name);
        }
    }

    @ParameterizedTest
    @MethodSource("commands")
    void optionsThatDoNotExist_areRefused(String command) {
        assertMistake("unknown option '--nonsense'; see mmneat " + command + " --help", command, "--nonsense");
        if (!takesParameters(command)) {
            assertMistake("unknown name 'zzzzzz'", command, "zzzzzz=1");
        }
    }

    @ParameterizedTest
    @MethodSource("commands")
    void version_isThatOfTheProgram(String command) {
        assertThat(execute(command, "--version")).isZero();
        assertThat(out.toString()).startsWith("MM-NEAT ");
    }

    /** Prints its arguments. */
    @Command(name = "echo")
    static final class Echo extends ConsoleCommand implements Runnable {

        @Option(names = "games", defaultValue = "7")
        @Range(min = 1, max = 10_000)
        private int games;

        @Option(names = "seed")
        private Long seed;

        @Option(names = "timed", arity = "1")
        private boolean timed;

        @Option(names = "pacman")
        private String pacman;

        @Parameters(arity = "0..1")
        private String file;

        @Override
        public void run() {
            out().print(games + " " + seed + " " + timed + " " + pacman + " " + file);
            out().flush();
        }
    }

    private String echo(String... words) {
        CommandLine line = new CommandLine(new Echo());
        Main.configure(line);
        int code = execute(line, words);
        return code == 0 ? out.toString() : errors.toString().strip();
    }

    @Test
    void values_areRead() {
        assertThat(echo()).isEqualTo("7 null false null null");
        assertThat(echo("games=3", "seed=-12", "timed=TRUE", "pacman=a:b=c", "f"))
                .isEqualTo("3 -12 true a:b=c f");
        assertThat(echo("f", "games:10_000", "seed: 5 ", "timed:true", "pacman:x=y"))
                .isEqualTo("10000 5 true x=y f");
        assertThat(echo("pacman=games", "C:\\game.txt")).isEqualTo("7 null false games C:\\game.txt");
        assertThat(echo("pacman=--help", "pacman.txt")).isEqualTo("7 null false --help pacman.txt");
        assertThat(echo("pacman=", "@file")).isEqualTo("7 null false  @file");
    }

    @Test
    void valuesOutOfRange_nameTheRange() {
        assertThat(echo("games=0")).isEqualTo("mmneat: games=0: must be a whole number from 1 to 10000");
        assertThat(echo("games=10001")).isEqualTo("mmneat: games=10001: must be a whole number from 1 to 10000");
        assertThat(echo("games=99999999999")).endsWith(": must be a whole number from 1 to 10000");
        assertThat(echo("seed=x")).isEqualTo("mmneat: seed=x: must be a whole number");
        assertThat(echo("timed=yes")).isEqualTo("mmneat: timed=yes: must be true or false");
        assertMistake("rules=blendde: must be one of", "play", "rules=blendde");
        assertMistake("(did you mean 'blended'?)", "play", "rules=blendde");
        assertThat(execute("play", "rules=BLENDED", "pacman=RandomPacMan")).isZero();
        assertThat(out.toString()).contains("rules blended");
    }

    @Test
    void optionGivenTwice_keepsTheLastValue_withARemark() {
        assertThat(echo("games=3", "pacman=x", "games:4")).isEqualTo("4 null false x null");
        assertThat(errors.toString().strip()).isEqualTo("mmneat: games=3 is overridden by games=4, which comes later");
        assertThat(echo("games=x", "games=4")).startsWith("4 ");
    }

    @Test
    void positionalWords_areAcceptedOnlyByCommandsThatHaveThem() {
        assertThat(echo("a.txt", "b.txt")).isEqualTo("mmneat: 'b.txt' is not understood; write name=value");
        assertThat(echo("sed=1")).isEqualTo("mmneat: unknown name 'sed' (did you mean 'seed'?)");
        assertThat(echo("a=1")).isEqualTo("mmneat: unknown name 'a'; known: games, seed, timed, pacman");
        CommandSpec play = Main.commandLine().getSubcommands().get("play").getCommandSpec();
        assertThat(play.positionalParameters()).isEmpty();
        assertMistake("'game.txt' is not understood; write name=value", "play", "game.txt");
    }
}
