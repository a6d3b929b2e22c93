import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.function.IntSupplier;
import mmneat.nsga2.Crowding;
import mmneat.nsga2.SurvivorSelection;
import org.moeaframework.core.Solution;
import org.moeaframework.core.population.NondominatedSortingPopulation;
import org.uma.jmetal.solution.doublesolution.DoubleSolution;
import org.uma.jmetal.solution.doublesolution.impl.DefaultDoubleSolution;
import org.uma.jmetal.util.bounds.Bounds;
import org.uma.jmetal.util.densityestimator.impl.CrowdingDistanceDensityEstimator;
import org.uma.jmetal.util.ranking.impl.MergeNonDominatedSortRanking;

/**
 * Times survivor selection (the better half of a random population, crowding per front) of three Java libraries in
 * turns, in one JVM and one thread. Prints the median and the quartiles in milliseconds.
 */
public final class SelectionPeers {

    private static final int WARM_UP = 30;
    private static final int TURNS = 60;

    public static void main(String[] arguments) {
        for (String size : List.of("200x2", "1000x3", "2000x2", "10000x2")) {
            String[] sizes = size.split("x");
            compare(size, Integer.parseInt(sizes[0]), Integer.parseInt(sizes[1]));
        }
    }

    private static void compare(String name, int size, int objectives) {
        double[][] scores = new double[size][objectives];
        Random random = new Random(1);
        for (double[] score : scores) {
            Arrays.setAll(score, j -> random.nextDouble());
        }
        Map<String, IntSupplier> libraries = new LinkedHashMap<>();
        libraries.put("MM-NEAT", () -> SurvivorSelection.survivors(scores, size / 2, Crowding.PER_FRONT).length);
        libraries.put("MOEA Framework 5.0", moea(scores));
        libraries.put("jMetal 6.6, merge sort", jMetal(scores));
        Map<String, double[]> times = new LinkedHashMap<>();
        libraries.keySet().forEach(library -> times.put(library, new double[TURNS]));
        int repeats = Math.max(1, 2000 / size);
        for (int turn = -WARM_UP; turn < TURNS; turn++) {
            for (Map.Entry<String, IntSupplier> library : libraries.entrySet()) {
                long start = System.nanoTime();
                for (int repeat = 0; repeat < repeats; repeat++) {
                    if (library.getValue().getAsInt() != size / 2) {
                        throw new IllegalStateException(library.getKey() + " did not select half of the population");
                    }
                }
                if (turn >= 0) {
                    times.get(library.getKey())[turn] = (System.nanoTime() - start) / 1e6 / repeats;
                }
            }
        }
        times.forEach((library, ofLibrary) -> {
            Arrays.sort(ofLibrary);
            System.out.printf(
                    Locale.ROOT,
                    "%-8s %-24s %9.3f ms (%.3f to %.3f)%n",
                    name,
                    library,
                    ofLibrary[TURNS / 2],
                    ofLibrary[TURNS / 4],
                    ofLibrary[TURNS * 3 / 4]);
        });
    }

    private static IntSupplier moea(double[][] scores) {
        List<Solution> solutions = new ArrayList<>();
        for (double[] score : scores) {
            Solution solution = new Solution(0, score.length);
            for (int j = 0; j < score.length; j++) {
                solution.setObjectiveValue(j, -score[j]);
            }
            solutions.add(solution);
        }
        return () -> {
            NondominatedSortingPopulation population = new NondominatedSortingPopulation();
            population.addAll(solutions);
            population.truncate(scores.length / 2);
            return population.size();
        };
    }

    private static IntSupplier jMetal(double[][] scores) {
        List<DoubleSolution> solutions = new ArrayList<>();
        for (double[] score : scores) {
            DoubleSolution solution = new DefaultDoubleSolution(List.of(Bounds.create(0.0, 1.0)), score.length, 0);
            Arrays.setAll(solution.objectives(), j -> -score[j]);
            solutions.add(solution);
        }
        return () -> {
            var ranking = new MergeNonDominatedSortRanking<DoubleSolution>();
            ranking.compute(solutions);
            var crowding = new CrowdingDistanceDensityEstimator<DoubleSolution>();
            int room = scores.length / 2;
            List<DoubleSolution> survivors = new ArrayList<>(room);
            for (int front = 0; survivors.size() < room; front++) {
                List<DoubleSolution> members = new ArrayList<>(ranking.getSubFront(front));
                crowding.compute(members);
                if (survivors.size() + members.size() > room) {
                    members.sort(Comparator.comparing((DoubleSolution member) -> crowding.value(member))
                            .reversed());
                    members = members.subList(0, room - survivors.size());
                }
                survivors.addAll(members);
            }
            return survivors.size();
        };
    }
}
