package mmneat.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.ChampionLabels;
import mmneat.cli.options.ChampionChoice;
import mmneat.cli.options.JarOption;
import mmneat.cli.output.OutputFile;
import mmneat.experiment.UserError;
import mmneat.mspacman.TaskVersion;
import mmneat.neat.Genotype;
import mmneat.neat.io.GenotypeJson;
import mmneat.neat.io.GenotypeXml;
import mmneat.neat.io.NetworkDot;
import mmneat.neat.io.NetworkGraphml;
import mmneat.neat.io.NetworkLabels;
import mmneat.neat.io.NetworkSvg;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The command {@code network}: draws a saved network, or writes it in another format. */
@Command(
        name = "network",
        customSynopsis = "mmneat network [FILE] [name=value...]",
        description = {
            "Draws a network, or converts it to another format.",
            "",
            "FILE is a network in JSON or XML, saved by this program or by the original, or the folder of "
                    + "a run: then its champion. The inputs are named after the sensors of the run's task.",
            "",
            "Example: mmneat network results/blended/2M0",
            "Example: mmneat network champion=isolated out=network.svg",
            "Example: mmneat network champion.json format=dot out=- | dot -Tpdf > network.pdf",
            "",
        })
final class NetworkCommand extends ConsoleCommand implements Runnable {

    private static final class Formats extends ArrayList<String> {
        Formats() {
            super(List.of("svg", "dot", "graphml", "json", "xml"));
        }
    }

    /** The formats that contain the names of inputs. */
    private static final List<String> LABELLED = List.of("svg", "dot", "graphml");

    private static final String NO_TASK = "none";

    private static final class Tasks extends ArrayList<String> {
        Tasks() {
            super(TaskVersion.labels());
            add(NO_TASK);
        }
    }

    @Parameters(arity = "0..1", paramLabel = "FILE", description = "Folder of a run, or file of a network.")
    private @Nullable Path file;

    @Mixin
    private ChampionChoice choice;

    @Mixin
    private JarOption jar;

    @Option(
            names = "task",
            paramLabel = "TASK",
            completionCandidates = Tasks.class,
            description =
                    "Version of the task whose sensors name the inputs: ${COMPLETION-CANDIDATES}; with none they are"
                            + " numbered (default: that of the run, or the one that the number of inputs fits).")
    private @Nullable String task;

    @Option(
            names = "format",
            paramLabel = "FORMAT",
            completionCandidates = Formats.class,
            description =
                    "svg: a picture; dot: a graph for Graphviz; graphml: a graph for other programs; json: this"
                            + " program's format; xml: the original's format (default: by the ending of out=; without out=, svg).")
    private @Nullable String format;

    @Option(
            names = "out",
            paramLabel = "FILE",
            description = "File to write, or - for standard output (default: named after network and format, in this"
                    + " folder).")
    private @Nullable Path out;

    @Override
    public void run() {
        Champion champion = jar.allow(choice.read(file, null));
        boolean toScreen = out != null && out.equals(OutputFile.STANDARD_OUTPUT);
        if (out != null && !toScreen) {
            OutputFile.require("out", out);
            OutputFile.requireOther("out", out, "the network", champion.file());
        }
        String form = format != null ? format : out == null || toScreen ? "svg" : formatOf(out);
        String text = convert(champion.genotype(), form, labels(champion, form));
        if (toScreen) {
            out().print(text);
        } else {
            Path target = out == null ? Path.of(champion.name() + "-network." + form) : out;
            OutputFile.write(target, text);
            out().println(target);
        }
        out().flush();
    }

    private NetworkLabels labels(Champion champion, String format) {
        if (NO_TASK.equals(task) || !LABELLED.contains(format)) {
            return NetworkLabels.NUMBERS;
        }
        ChampionLabels labels =
                ChampionLabels.of(champion, Optional.ofNullable(task).flatMap(TaskVersion::labelled));
        if (!labels.remark().isEmpty()) {
            notes().println("network: " + labels.remark());
            notes().flush();
        }
        return labels.labels();
    }

    private static String formatOf(Path out) {
        String name = String.valueOf(out.getFileName());
        String ending = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        List<String> formats = new Formats();
        if (!formats.contains(ending)) {
            throw new UserError("out=" + out + ": the ending is not a format; name the file *."
                    + String.join(", *.", formats) + " or give format=");
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
