"""Times survivor selection of pymoo (the better half of a random population), as SelectionPeers.java does for Java libraries."""

import statistics
import time

import numpy as np
from pymoo.algorithms.moo.nsga2 import RankAndCrowdingSurvival
from pymoo.core.individual import Individual
from pymoo.core.population import Population
from pymoo.core.problem import Problem

for size, objectives in ((200, 2), (1000, 3), (2000, 2), (10000, 2)):
    scores = np.random.default_rng(1).random((size, objectives))
    population = Population.new("F", -scores)
    problem = Problem(n_var=1, n_obj=objectives)
    survival = RankAndCrowdingSurvival()
    times = []
    turns = 3 if size == 10000 else 20
    for turn in range(-1, turns):
        start = time.perf_counter()
        survivors = survival.do(problem, population, n_survive=size // 2)
        if turn >= 0:
            times.append((time.perf_counter() - start) * 1e3)
        assert len(survivors) == size // 2
    low, middle, high = statistics.quantiles(times, n=4)
    print(f"{size}x{objectives:<{7 - len(str(size))}} {'pymoo':<24} {middle:9.3f} ms ({low:.3f} to {high:.3f})")
