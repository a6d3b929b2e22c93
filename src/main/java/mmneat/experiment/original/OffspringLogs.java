package mmneat.experiment.original;

import java.util.List;
import java.util.function.Function;
import mmneat.experiment.store.RunLayout;
import mmneat.neat.variation.Offspring;

/**
 * The logs of lineage and of mutations: one line per child, and one at the end of a generation.
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

    /** Returns the lines with the parents of each child. */
    static String lineage(int generation, List<Offspring> offspring) {
        return lines(generation, offspring, child -> {
            String mate = child.secondParent().isPresent()
                    ? " X " + child.secondParent().getAsLong()
                    : "";
            return child.firstParent() + mate + " -> " + child.genotype().id();
        });
    }

    /** Returns the lines with the mutations of each child. */
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
