package mmneat.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.ChampionLabels;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.PublishedConfigurations;
import mmneat.neat.Genotype;
import mmneat.neat.io.GenotypeJson;
import mmneat.neat.io.GenotypeXml;
import mmneat.neat.io.NetworkDot;
import mmneat.neat.io.NetworkGraphml;
import mmneat.neat.io.NetworkLabels;
import mmneat.neat.io.NetworkSvg;
import picocli.CommandLine.Command;

/** {@code network FILE}: draws a saved network, or writes it in another form. */
@Command(
        name = "network",
        customSynopsis = "mmneat network [FILE] [name=value...]",
        description = {
            "Draws a saved network, or writes it in another form.",
            "FILE is a network that this program or the original has saved (JSON or XML), or the folder of a run: its"
                    + " champion. Its inputs are named by the sensors of its run's task.",
            "Example: mmneat network results/blended/2M0 out=network.svg",
            "Example: mmneat network champion=isolated out=network.svg",
            "",
        })
final class NetworkCommand extends WordCommand implements Runnable {

    private static final List<String> FORMATS = List.of("svg", "dot", "graphml", "json", "xml");
    /** The formats that name inputs. */
    private static final List<String> LABELLED = List.of("svg", "dot", "graphml");

    private static final String NO_TASK = "none";
    private static final List<String> TASKS = Stream.concat(
                    PublishedConfigurations.tasks().stream(), Stream.of(NO_TASK))
            .toList();

    @Override
    List<Word> knownWords() {
        return List.of(
                ChosenChampion.WORD,
                new Word(
                        "task",
                        String.join("|", TASKS),
                        "version of the task whose sensors name the inputs; none: they are numbered (default: the task of its"
                                + " run, or what the number of inputs says)"),
                new Word(
                        "format",
                        "svg|dot|graphml|json|xml",
                        "picture, graph for Graphviz, graph for other programs, our form, the original's form;"
                                + " default: by the ending of out; without out, svg"),
                new Word("out", "FILE", "where to write; default: standard output"));
    }

    @Override
    public void run() {
        Words parsed = words(1);
        Champion champion = ChosenChampion.of(parsed, null);
        Optional<Path> out = parsed.path("out");
        String format =
                parsed.has("format") || out.isEmpty() ? parsed.choice("format", "svg", FORMATS) : formatOf(out.get());
        String text = convert(champion.genotype(), format, labels(parsed, champion, format));
        if (out.isPresent()) {
            OutputFile.write(out.get(), text);
        } else {
            out().print(text);
            out().flush();
        }
    }

    private NetworkLabels labels(Words words, Champion champion, String format) {
        String task = words.choice("task", "", TASKS);
        if (task.equals(NO_TASK) || !LABELLED.contains(format)) {
            return NetworkLabels.NUMBERS;
        }
        ChampionLabels labels = ChampionLabels.of(champion, task.isEmpty() ? Optional.empty() : Optional.of(task));
        if (!labels.remark().isEmpty()) {
            notes().println("network: " + labels.remark());
            notes().flush();
        }
        return labels.labels();
    }

    private static String formatOf(Path out) {
        String name = String.valueOf(out.getFileName());
        String ending = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        if (!FORMATS.contains(ending)) {
            throw new UserError("out=" + out + ": the ending tells no format; name the file *."
                    + String.join(", *.", FORMATS) + " or say format=");
        }
        return ending;
    }

    private static String convert(Genotype genotype, String format, NetworkLabels labels) {
        return switch (format) {
            case "dot" -> NetworkDot.of(genotype, labels);
            case "graphml" -> NetworkGraphml.of(genotype, labels);
            case "json" -> GenotypeJson.write(genotype);
            case "xml" -> GenotypeXml.write(genotype);
            default -> NetworkSvg.of(genotype, labels);
        };
    }
}
