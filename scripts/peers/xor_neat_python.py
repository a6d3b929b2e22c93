"""Exclusive or with neat-python, as XorTask.java has it.

xor_neat_python.py CONFIG cost POPULATION GENERATIONS   processor time per evaluation
xor_neat_python.py CONFIG solve SEEDS                   evaluations until fitness 3.9, for each seed
"""

import random
import statistics
import sys
import time

import neat

PATTERNS = (((0, 0), 0), ((0, 1), 1), ((1, 0), 1), ((1, 1), 0))
evaluations = 0


def evaluate(genomes, config):
    global evaluations
    for _, genome in genomes:
        network = neat.nn.FeedForwardNetwork.create(genome, config)
        genome.fitness = 4.0
        for inputs, expected in PATTERNS:
            genome.fitness -= (network.activate(inputs)[0] - expected) ** 2
        evaluations += 1


config = neat.Config(
    neat.DefaultGenome, neat.DefaultReproduction, neat.DefaultSpeciesSet, neat.DefaultStagnation, sys.argv[1]
)
if sys.argv[2] == "cost":
    config.pop_size = int(sys.argv[3])
    random.seed(1)
    start = time.process_time()
    neat.Population(config).run(evaluate, int(sys.argv[4]))
    seconds = time.process_time() - start
    print(f"neat-python: population {sys.argv[3]}: {seconds / evaluations * 1e6:.1f} us per evaluation")
else:
    config.no_fitness_termination = False
    config.fitness_threshold = 3.9
    needed = []
    for seed in range(int(sys.argv[3])):
        evaluations = 0
        random.seed(seed)
        try:
            winner = neat.Population(config).run(evaluate, 300)
        except neat.CompleteExtinctionException:
            continue
        if winner.fitness >= 3.9:
            needed.append(evaluations)
    print(
        f"neat-python: {len(needed)} of {sys.argv[3]} seeds solved, median {statistics.median(needed):.0f} evaluations"
    )
