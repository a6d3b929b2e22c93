import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.ToIntFunction;
import java.util.stream.IntStream;
import mmneat.evolution.Evaluator;
import mmneat.evolution.Evolution;
import mmneat.evolution.EvolutionObserver;
import mmneat.evolution.EvolutionSettings;
import mmneat.evolution.EvolutionState;
import mmneat.evolution.Generation;
import mmneat.evolution.Individual;
import mmneat.evolution.ScoreKeepingEvaluator;
import mmneat.evolution.SequentialEvaluator;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.variation.MutationRates;
import mmneat.neat.variation.VariationSettings;
import mmneat.nsga2.ParentSelection;
import mmneat.nsga2.Selection;
import mmneat.random.ResumableRandom;

/**
 * A comparison of what may help MM-NEAT on double pole balancing: species as in NEAT, more mutation of weights, no
 * crossover. Each line has the seeds of 30 that balance the poles for 10,000 decisions within 100 generations of
 * population 150.
 *
 * <p>The argument is the first seed (0).
 */
public final class PoleSpeciation {

    private static final int POPULATION = 150;
    private static final int SEEDS = 30;
    private static final double SOLVED = 10_000;

    /** The probability with which neat-python.cfg lets each weight change. */
    private static final double AS_NEAT_PYTHON = 0.8;

    /** A number of species that is never reached: the threshold alone divides the population. */
    private static final int ANY_NUMBER = Integer.MAX_VALUE;

    private PoleSpeciation() {}

    public static void main(String[] arguments) {
        int firstSeed = arguments.length == 0 ? 0 : Integer.parseInt(arguments[0]);
        double published = MutationRates.PUBLISHED.perLinkWeight();
        for (double rate : new double[] {published, 0.1, 0.2, AS_NEAT_PYTHON}) {
            print("no species, perLinkMutateRate=" + rate, firstSeed, rate, true, null);
        }
        print("no species, no crossover", firstSeed, published, false, null);
        for (double threshold : new double[] {3, 1.5, 0.75}) {
            Species species = new Species(threshold, ANY_NUMBER);
            print("species, threshold " + threshold, firstSeed, published, true, species);
        }
        Species many = new Species(0.75, ANY_NUMBER);
        Species eight = new Species(0, 8);
        print("8 species", firstSeed, published, true, eight);
        print("8 species, perLinkMutateRate=0.8", firstSeed, AS_NEAT_PYTHON, true, eight);
        print("species, threshold 0.75, perLinkMutateRate=0.8", firstSeed, AS_NEAT_PYTHON, true, many);
    }

    /** @param species how the population is divided; null for NSGA-II's selection */
    private static void print(String what, int firstSeed, double weightRate, boolean isCrossing, Species species) {
        int[] needed = IntStream.range(firstSeed, firstSeed + SEEDS)
                .map(seed -> evaluations(seed, weightRate, isCrossing, species))
                .sorted()
                .toArray();
        long solved = Arrays.stream(needed).filter(n -> n < Integer.MAX_VALUE).count();
        int higher = needed[SEEDS / 2];
        String median = higher == Integer.MAX_VALUE ? "not reached" : "" + (needed[SEEDS / 2 - 1] + higher) / 2;
        System.out.printf(Locale.ROOT, "%-48s %2d of %d seeds solved, median of all %s%n", what, solved, SEEDS, median);
    }

    /** Evaluations until the poles stay up; {@link Integer#MAX_VALUE} if they never do. */
    private static int evaluations(int seed, double weightRate, boolean isCrossing, Species species) {
        DoublePoleTask task = new DoublePoleTask(Map.of());
        EvolutionSettings defaults = EvolutionSettings.published(task);
        MutationRates rates = MutationRates.PUBLISHED;
        EvolutionSettings settings = new EvolutionSettings(
                seed,
                OptionalInt.empty(),
                POPULATION,
                100,
                defaults.cleanFrequency(),
                defaults.initialNetworks(),
                new ParentSelection(
                        isCrossing,
                        defaults.parentSelection().crossoverRate(),
                        defaults.parentSelection().crowding()),
                new VariationSettings(new MutationRates(
                        rates.newLink(),
                        rates.spliceNeuron(),
                        weightRate,
                        rates.oneWeight(),
                        rates.module(),
                        rates.deletion(),
                        rates.freezing())));
        Evaluator evaluator = new ScoreKeepingEvaluator(new SequentialEvaluator(task));
        if (species != null) {
            SpeciesSelection selection = new SpeciesSelection(species, evaluator);
            settings = settings.withSelection(selection);
            evaluator = selection;
        }
        Generation last = new Evolution(
                        settings,
                        EvolutionState.initial(settings),
                        evaluator,
                        new EvolutionObserver() {},
                        PoleSpeciation::isSolved)
                .run();
        return isSolved(last.parents()) ? POPULATION * (last.number() + 1) : Integer.MAX_VALUE;
    }

    private static boolean isSolved(List<Individual> parents) {
        return parents.stream().anyMatch(parent -> parent.evaluation().objectives()[0] >= SOLVED);
    }

    /**
     * The division of genotypes into species by NEAT's distance, with the coefficients of neat-python.cfg: unmatched
     * links per link of the larger genotype, plus half the mean difference between the weights of matching links.
     *
     * @param threshold the distance from the oldest member at which a genotype is of another species
     * @param most the largest number of species; the threshold is raised until there are no more
     */
    private record Species(double threshold, int most) {

        /** The number of each genotype's species, from 0, oldest genotypes first. */
        int[] of(List<Genotype> genotypes) {
            int[] divided = of(genotypes, threshold);
            if (count(divided) <= most) {
                return divided;
            }
            double tooLow = threshold;
            double high = 64;
            for (int i = 0; i < 12; i++) {
                double middle = (tooLow + high) / 2;
                if (count(of(genotypes, middle)) > most) {
                    tooLow = middle;
                } else {
                    high = middle;
                }
            }
            return of(genotypes, high);
        }

        static int count(int[] species) {
            return Arrays.stream(species).max().orElse(-1) + 1;
        }

        private static int[] of(List<Genotype> genotypes, double threshold) {
            int[] species = new int[genotypes.size()];
            List<Map<Long, Double>> oldest = new ArrayList<>();
            IntStream.range(0, genotypes.size())
                    .boxed()
                    .sorted(Comparator.comparingLong(i -> genotypes.get(i).id()))
                    .forEach(i -> {
                        Map<Long, Double> weights = new HashMap<>();
                        genotypes.get(i).links().forEach(link -> weights.put(link.innovation(), link.weight()));
                        int joined = 0;
                        while (joined < oldest.size()
                                && distance(genotypes.get(i), weights.size(), oldest.get(joined)) >= threshold) {
                            joined++;
                        }
                        if (joined == oldest.size()) {
                            oldest.add(weights);
                        }
                        species[i] = joined;
                    });
            return species;
        }

        private static double distance(Genotype genotype, int links, Map<Long, Double> other) {
            int matching = 0;
            double difference = 0;
            for (LinkGene link : genotype.links()) {
                Double weight = other.get(link.innovation());
                if (weight != null) {
                    matching++;
                    difference += Math.abs(weight - link.weight());
                }
            }
            double unmatched = links + other.size() - 2 * matching;
            return unmatched / Math.max(1, Math.max(links, other.size()))
                    + 0.5 * (matching == 0 ? 0 : difference / matching);
        }
    }

    /**
     * Selection with explicit fitness sharing. Each species has survivors in proportion to the mean score of its
     * members (above the worst of all), those with the highest scores. The first contestant of a tournament for parents
     * is of any species, the second of the same.
     *
     * <p>A selection sees only scores. It is also the evaluator, because that sees the genotypes.
     */
    private static final class SpeciesSelection implements Selection, Evaluator {

        private final Species species;
        private final Evaluator evaluator;
        private List<Genotype> parents = List.of();
        private List<Genotype> children = List.of();

        SpeciesSelection(Species species, Evaluator evaluator) {
            this.species = species;
            this.evaluator = evaluator;
        }

        @Override
        public List<Individual> evaluate(
                List<Genotype> genotypes,
                int generation,
                int firstIndex,
                ResumableRandom random,
                Consumer<Individual> whenDone) {
            if (firstIndex == 0) {
                parents = genotypes;
            } else {
                children = genotypes;
            }
            return evaluator.evaluate(genotypes, generation, firstIndex, random, whenDone);
        }

        @Override
        public ToIntFunction<ResumableRandom> parents(double[][] scores) {
            int[] speciesOf = species.of(parents);
            List<List<Integer>> members = members(speciesOf);
            return random -> {
                int first = random.nextInt(scores.length);
                List<Integer> same = members.get(speciesOf[first]);
                int second = same.get(random.nextInt(same.size()));
                return scores[second][0] > scores[first][0] ? second : first;
            };
        }

        @Override
        public int[] survivors(double[][] scores, int count, ResumableRandom random) {
            List<Genotype> all = new ArrayList<>(parents);
            all.addAll(children);
            List<List<Integer>> members = members(species.of(all));
            double worst =
                    Arrays.stream(scores).mapToDouble(score -> score[0]).min().orElseThrow();
            double[] shared = new double[members.size()];
            for (int k = 0; k < shared.length; k++) {
                // The small number lets equal scores share the places equally.
                shared[k] = members.get(k).stream()
                        .mapToDouble(i -> scores[i][0] - worst + 1e-9)
                        .average()
                        .orElseThrow();
                // Of equal scores, the youngest first.
                members.get(k)
                        .sort(Comparator.comparingDouble((Integer i) -> scores[i][0])
                                .thenComparingInt(i -> i)
                                .reversed());
            }
            int[] quota = quotas(shared, members, count);
            return IntStream.range(0, shared.length)
                    .boxed()
                    .flatMap(k -> members.get(k).subList(0, quota[k]).stream())
                    .mapToInt(i -> i)
                    .toArray();
        }

        private static List<List<Integer>> members(int[] species) {
            List<List<Integer>> members = new ArrayList<>();
            IntStream.range(0, Species.count(species)).forEach(k -> members.add(new ArrayList<>()));
            IntStream.range(0, species.length)
                    .forEach(i -> members.get(species[i]).add(i));
            return members;
        }

        /** Gives one place after the other to the species with the largest share per place (D'Hondt's method). */
        private static int[] quotas(double[] shared, List<List<Integer>> members, int count) {
            int[] quota = new int[shared.length];
            for (int place = 0; place < count; place++) {
                int next = -1;
                for (int k = 0; k < quota.length; k++) {
                    boolean hasMore = quota[k] < members.get(k).size();
                    if (hasMore && (next < 0 || shared[k] / (quota[k] + 1) > shared[next] / (quota[next] + 1))) {
                        next = k;
                    }
                }
                quota[next]++;
            }
            return quota;
        }
    }
}
