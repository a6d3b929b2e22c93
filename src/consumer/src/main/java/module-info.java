/** Uses all libraries from the module path. */
module consumer {
    requires mmneat.evolution;
    requires mmneat.neat;
    requires mmneat.nsga2;
    requires mmneat.random;
    requires mmneat.simulator;
}
