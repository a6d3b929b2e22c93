package mmneat.experiment.original;

import java.util.List;
import java.util.function.Function;
import mmneat.experiment.store.RunLayout;
import mmneat.neat.variation.Offspring;

/**
 * The logs of lineage and of mutations: a line for each child, and one that closes the generation.
 *
 * <p>Source: docs/specification/evolution.md, sections 1.2, 3.4 and 5.1.
 */
final class OffspringLogs {

    private OffspringLogs() {}

    static String lineageFile(String prefix) {
        return RunLayout.log(prefix, RunLayout.LINEAGE);
    }

    static String mutationsFile(String prefix) {
        return RunLayout.log(prefix, RunLayout.MUTATIONS);
    }

    /** Who came from whom in a generation. */
    static String lineage(int generation, List<Offspring> offspring) {
        return lines(generation, offspring, child -> {
            String mate = child.secondParent().isPresent()
                    ? " X " + child.secondParent().getAsLong()
                    : "";
            return child.firstParent() + mate + " -> " + child.genotype().id();
        });
    }

    /** Who was changed by what in a generation. */
    static String mutations(int generation, List<Offspring> offspring) {
        return lines(generation, offspring, child -> {
            StringBuilder line =
                    new StringBuilder().append(child.genotype().id()).append(' ');
            child.mutations().forEach(mutation -> line.append(mutation).append(' '));
            return line.toString();
        });
    }

    private static String lines(int generation, List<Offspring> offspring, Function<Offspring, String> line) {
        StringBuilder lines = new StringBuilder();
        offspring.forEach(child -> lines.append(line.apply(child)).append('\n'));
        return lines.append("---Gen ")
                .append(generation)
                .append(" Over-----------------\n")
                .toString();
    }
}
