package mmneat.analysis.statistics;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/** The tables of a comparison: the groups, the pairs, and optionally each group against the paper's. */
public final class ComparisonReport {

    /** The seed of all bootstrap intervals: the same table on every machine. */
    private static final long BOOTSTRAP_SEED = 1;

    private static final double INTERVAL = 0.95;

    private final @Nullable Comparison comparison;
    private final List<Sample> samples;
    private final List<Comparison.Pair> againstPaper;
    private final List<PaperSample> paper;

    /**
     * The scores of a group (an experiment) of the paper, for comparison with the group of ours that has the same
     * label.
     *
     * @param sample the scores of the paper's group; its label is that of our group
     * @param isComparable whether our group has scores from evaluations after evolution, as the paper's group has;
     *     otherwise the two are not tested
     * @param differences how the parameters of our group differ from the paper's; empty if they do not
     */
    public record PaperSample(Sample sample, boolean isComparable, String differences) {}

    private ComparisonReport(@Nullable Comparison comparison, List<Sample> samples, List<PaperSample> paper) {
        this.comparison = comparison;
        this.samples = List.copyOf(samples);
        this.paper = List.copyOf(paper);
        List<PairwiseTest> tests = new ArrayList<>();
        for (PaperSample theirs : paper) {
            if (theirs.isComparable) {
                Sample ours = samples.stream()
                        .filter(sample -> sample.label().equals(theirs.sample.label()))
                        .findFirst()
                        .orElseThrow();
                tests.add(PairwiseTest.of(ours, theirs.sample));
            }
        }
        againstPaper = Comparison.bonferroni(tests);
    }

    /**
     * A report of any number of groups.
     *
     * @param samples our groups, each with a label of its own
     * @param paper the paper's groups; empty if not wanted
     */
    public static ComparisonReport of(List<Sample> samples, List<PaperSample> paper) {
        return new ComparisonReport(samples.size() < 2 ? null : Comparison.of(samples), samples, paper);
    }

    /** One row per group: size, median with its bootstrap interval, mean, deviation, range. */
    public TextTable groups() {
        TextTable table = new TextTable("method", "runs", "median", "95 % interval", "mean", "sd", "min", "max");
        samples.forEach(sample -> groupRow(table, sample.label(), sample));
        for (PaperSample theirs : paper) {
            groupRow(table, theirs.sample.label() + " (paper)", theirs.sample);
        }
        return table;
    }

    private static void groupRow(TextTable table, String label, Sample sample) {
        BootstrapInterval interval = BootstrapInterval.ofMedian(sample, INTERVAL, BOOTSTRAP_SEED);
        table.row(
                label,
                String.valueOf(sample.size()),
                Numbers.score(sample.median()),
                Numbers.interval(interval.low(), interval.high()),
                Numbers.score(sample.mean()),
                Numbers.score(sample.standardDeviation()),
                Numbers.score(sample.quantile(0)),
                Numbers.score(sample.quantile(1)));
    }

    /** The Kruskal-Wallis test in one line. */
    public String overall() {
        if (comparison == null) {
            return samples.isEmpty()
                    ? "Nothing to compare: no run has a score."
                    : "Nothing to compare: there is only one group.";
        }
        KruskalWallis test = comparison.kruskalWallis();
        return "Kruskal-Wallis: H = " + Numbers.decimal(test.h(), 3) + ", df = " + test.degreesOfFreedom() + ", p = "
                + Numbers.probability(test.p());
    }

    /** One row per pair of groups. */
    public TextTable pairs() {
        return pairTable(comparison == null ? List.of() : comparison.pairs(), "pair", " - ");
    }

    /** One row per group that the paper has: ours against the paper's. */
    public TextTable againstPaper() {
        TextTable table =
                new TextTable("method", "U", "p", "corrected p", "A", "effect", "verdict", "not as in the paper");
        Iterator<Comparison.Pair> tested = againstPaper.iterator();
        for (PaperSample theirs : paper) {
            if (!theirs.isComparable) {
                table.row(theirs.sample.label(), "-", "-", "-", "-", "-", "none: no evaluated run", theirs.differences);
                continue;
            }
            Comparison.Pair pair = tested.next();
            PairwiseTest test = pair.test();
            table.row(
                    test.a(),
                    Numbers.decimal(test.u(), 1),
                    Numbers.probability(test.p()),
                    Numbers.probability(pair.corrected()),
                    Numbers.decimal(test.effectSize(), 3),
                    test.magnitude(),
                    verdict(pair),
                    theirs.differences);
        }
        return table;
    }

    /** Whether ours differ from the paper's, in words. */
    static String verdict(Comparison.Pair pair) {
        if (!(pair.corrected() < Comparison.SIGNIFICANCE)) {
            return "no difference shown";
        }
        return pair.test().effectSize() > 0.5 ? "ours higher" : "ours lower";
    }

    private static TextTable pairTable(List<Comparison.Pair> pairs, String first, String between) {
        TextTable table = new TextTable(first, "U", "p", "corrected p", "method", "A", "effect", "");
        for (Comparison.Pair pair : pairs) {
            PairwiseTest test = pair.test();
            table.row(
                    test.a() + between + test.b(),
                    Numbers.decimal(test.u(), 1),
                    Numbers.probability(test.p()),
                    Numbers.probability(pair.corrected()),
                    test.method() == PairwiseTest.Method.EXACT ? "exact" : "normal",
                    Numbers.decimal(test.effectSize(), 3),
                    test.magnitude(),
                    pair.corrected() < Comparison.SIGNIFICANCE ? "*" : "");
        }
        return table;
    }

    /** Whether the paper's groups stand beside ours. */
    public boolean hasPaper() {
        return !paper.isEmpty();
    }

    /** All tables as text for the terminal. */
    public String text() {
        StringBuilder text = new StringBuilder(groups().text())
                .append('\n')
                .append(overall())
                .append('\n');
        if (comparison != null) {
            text.append("\nAll pairs: two-sided Mann-Whitney U, Bonferroni for ")
                    .append(Numbers.counted(comparison.comparisons(), "comparison"))
                    .append("; A is the probability that the first scores higher\n\n")
                    .append(pairs().text())
                    .append("* corrected p below ")
                    .append(Comparison.SIGNIFICANCE)
                    .append('\n');
        }
        if (hasPaper()) {
            text.append("\nOurs against the paper's champions (")
                    .append(Numbers.counted(againstPaper.size(), "comparison"))
                    .append(")\n\n")
                    .append(againstPaper().text());
        }
        return text.toString();
    }

    /** All tables as LaTeX. */
    public String latex() {
        return Stream.of(groups(), pairs(), againstPaper())
                .filter(table -> !table.rows().isEmpty())
                .map(TextTable::latex)
                .reduce("% needs \\usepackage{booktabs}\n% " + overall() + "\n", (all, table) -> all + "\n" + table);
    }

    /** Our groups. */
    public List<Sample> samples() {
        return samples;
    }

    /** The comparison of our groups; empty for a single one. */
    public Optional<Comparison> comparison() {
        return Optional.ofNullable(comparison);
    }

    /**
     * The tests of our groups against the paper's groups of the same label. Groups that are not comparable have no
     * test. The correction counts these tests only, not those between our groups.
     */
    public List<Comparison.Pair> pairsAgainstPaper() {
        return againstPaper;
    }
}
