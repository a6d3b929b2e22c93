package mmneat.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import mmneat.experiment.UserError;
import mmneat.neat.Genotype;
import mmneat.neat.io.GenotypeFiles;
import mmneat.neat.io.GenotypeFormatException;
import mmneat.neat.io.GenotypeJson;
import mmneat.neat.io.GenotypeXml;
import mmneat.neat.io.NetworkDot;
import mmneat.neat.io.NetworkGraphml;
import mmneat.neat.io.NetworkSvg;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code network FILE}: draws a saved network, or writes it in another form. */
@Command(
        name = "network",
        mixinStandardHelpOptions = true,
        description = {
            "Draws a saved network, or writes it in another form.",
            "FILE is a network that this program or the original has saved (JSON or XML)."
        })
final class NetworkCommand implements Callable<Integer>, WordCommand {

    private static final List<String> FORMATS = List.of("svg", "dot", "graphml", "json", "xml");

    @Spec
    private CommandSpec command;

    @Parameters(
            arity = "0..*",
            paramLabel = "FILE",
            hideParamSyntax = true,
            description = "the network, and words as below")
    private List<String> words = List.of();

    @Override
    public List<Word> knownWords() {
        return List.of(
                new Word(
                        "format",
                        "svg|dot|graphml|json|xml",
                        "picture, graph for Graphviz, graph for other programs, our form, the original's form;"
                                + " default: by the ending of out, else svg"),
                new Word("out", "FILE", "where to write; default: standard output"));
    }

    @Override
    public Integer call() throws IOException {
        Words parsed = Words.parse(words, this, 1);
        if (parsed.plain().isEmpty()) {
            throw new UserError("no network named; write: network FILE [format=svg] [out=FILE]");
        }
        Optional<Path> out = parsed.path("out");
        String format =
                parsed.choice("format", out.map(NetworkCommand::formatOf).orElse("svg"), FORMATS);
        String text = convert(read(Path.of(parsed.plain().get(0))), format);
        if (out.isPresent()) {
            write(out.get(), text);
        } else {
            command.commandLine().getOut().print(text);
            command.commandLine().getOut().flush();
        }
        return 0;
    }

    private static Genotype read(Path file) {
        try {
            return GenotypeFiles.read(file);
        } catch (GenotypeFormatException e) {
            throw new UserError(e.getMessage(), e);
        } catch (NoSuchFileException e) {
            throw new UserError(file + ": no such file", e);
        } catch (IOException e) {
            throw new UserError(file + ": cannot be read" + (Files.isDirectory(file) ? ", it is a folder" : ""), e);
        }
    }

    private static String formatOf(Path out) {
        String name = out.getFileName().toString();
        String ending = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        return FORMATS.contains(ending) ? ending : "svg";
    }

    private static String convert(Genotype genotype, String format) {
        return switch (format) {
            case "dot" -> NetworkDot.of(genotype, List.of());
            case "graphml" -> NetworkGraphml.of(genotype, List.of());
            case "json" -> GenotypeJson.write(genotype);
            case "xml" -> GenotypeXml.write(genotype);
            default -> NetworkSvg.of(genotype, List.of());
        };
    }

    private static void write(Path out, String text) {
        try {
            Files.writeString(out, text, StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UserError("out=" + out + ": cannot be written; does the folder exist?", e);
        }
    }
}
