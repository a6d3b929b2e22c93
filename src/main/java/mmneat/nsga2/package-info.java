/**
 * NSGA-II as the program MM-NEAT runs it: dominance, fronts, crowding distance, parent selection and survivor
 * selection.
 *
 * <p>All objectives are maximised. The package works with score vectors and makes children through {@link
 * mmneat.nsga2.Variation}, so individuals may have any type.
 *
 * <p>Sources: K. Deb, A. Pratap, S. Agarwal, T. Meyarivan: A fast and elitist multiobjective genetic algorithm:
 * NSGA-II, IEEE Transactions on Evolutionary Computation 6 (2002), called <em>the published algorithm</em> here;
 * docs/specification/evolution.md, section 2. <em>The original</em> is not that algorithm but MM-NEAT, the program of
 * J. Schrum and R. Miikkulainen, version of February 2016. It departs from the published algorithm in several places,
 * listed in section 2.6 there; {@link mmneat.nsga2.Crowding} offers both forms of the most important one.
 */
@NullMarked
package mmneat.nsga2;

import org.jspecify.annotations.NullMarked;
