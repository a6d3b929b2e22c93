import mmneat.nsga2.Crowding;
import mmneat.nsga2.Dominance;
import mmneat.nsga2.NondominatedSorting;

/** Sorts three individuals into fronts. */
public class Nsga2User {
    public static void main(String[] arguments) {
        double[][] scores = {{1, 2}, {2, 1}, {0, 0}};
        NondominatedSorting sorting = NondominatedSorting.of(scores, Crowding.values()[0]);
        System.out.println(Dominance.dominates(scores[0], scores[2]) && sorting.fronts().size() == 2);
    }
}
