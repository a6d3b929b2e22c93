"""Double pole balancing with velocities with neat-python, as DoublePoleTask.java has it.

double_pole_neat_python.py CONFIG cost POPULATION GENERATIONS STEPS   processor time per evaluation of STEPS decisions
double_pole_neat_python.py CONFIG solve SEEDS GENERATIONS STEPS       evaluations until the poles stay up for STEPS,
                                                                      and numbers of species
"""

import math
import random
import statistics
import sys
import time

import neat

MOST_NEWTONS = 10.0
SECONDS = 0.01
HALF_TRACK_METRES = 2.4
MOST_RADIANS = math.radians(36)
START = (0.0, 0.0, math.radians(4.5), 0.0, 0.0, 0.0)
evaluations = 0
decisions = 0


def slopes(v, angle1, turn1, angle2, turn2, force, sin=math.sin, cos=math.cos):
    """Wieland's equations: accelerations of the cart (1 kg) and of the poles (0.1 kg, 1 m; 0.01 kg, 0.1 m)."""
    sine1, cosine1, sine2, cosine2 = sin(angle1), cos(angle1), sin(angle2), cos(angle2)
    hinge1 = 0.000002 * turn1 / 0.05 - 9.8 * sine1
    hinge2 = 0.000002 * turn2 / 0.0005 - 9.8 * sine2
    pushes = (
        force
        - (0.0005 if v > 0 else -0.0005 if v < 0 else 0.0)
        + 0.05 * turn1 * turn1 * sine1
        + 0.075 * cosine1 * hinge1
        + 0.0005 * turn2 * turn2 * sine2
        + 0.0075 * cosine2 * hinge2
    )
    a = pushes / (1 + 0.1 * (1 - 0.75 * cosine1 * cosine1) + 0.01 * (1 - 0.75 * cosine2 * cosine2))
    return a, -1.5 * (a * cosine1 + hinge1), -15 * (a * cosine2 + hinge2)


def integrate(state, force):
    """One Runge-Kutta integration of fourth order."""
    x, v, p, dp, q, dq = state
    h = SECONDS / 2
    a1, b1, c1 = slopes(v, p, dp, q, dq, force)
    v2, dp2, dq2 = v + h * a1, dp + h * b1, dq + h * c1
    a2, b2, c2 = slopes(v2, p + h * dp, dp2, q + h * dq, dq2, force)
    v3, dp3, dq3 = v + h * a2, dp + h * b2, dq + h * c2
    a3, b3, c3 = slopes(v3, p + h * dp2, dp3, q + h * dq2, dq3, force)
    h = SECONDS
    v4, dp4, dq4 = v + h * a3, dp + h * b3, dq + h * c3
    a4, b4, c4 = slopes(v4, p + h * dp3, dp4, q + h * dq3, dq4, force)
    h = SECONDS / 6
    return (
        x + h * (v + 2 * v2 + 2 * v3 + v4),
        v + h * (a1 + 2 * a2 + 2 * a3 + a4),
        p + h * (dp + 2 * dp2 + 2 * dp3 + dp4),
        dp + h * (b1 + 2 * b2 + 2 * b3 + b4),
        q + h * (dq + 2 * dq2 + 2 * dq3 + dq4),
        dq + h * (c1 + 2 * c2 + 2 * c3 + c4),
    )


def balanced(network, steps, starts_again):
    """Decisions until the cart leaves the track or a pole falls. With starts_again, the simulation goes on to STEPS."""
    global decisions
    state = START
    fell = 0
    for done in range(1, steps + 1):
        x, v, p, dp, q, dq = state
        output = network.activate((x / 4.8, v / 2, p / 0.52, dp / 2, q / 0.52, dq / 2))[0]
        force = MOST_NEWTONS * (2 * output - 1)
        state = integrate(integrate(state, force), force)
        if not (abs(state[0]) <= HALF_TRACK_METRES and abs(state[2]) <= MOST_RADIANS and abs(state[4]) <= MOST_RADIANS):
            fell = fell or done
            if not starts_again:
                break
            state = START
    decisions += done
    return fell or steps


def evaluator(steps, starts_again):
    def evaluate(genomes, config):
        global evaluations
        for _, genome in genomes:
            genome.fitness = balanced(neat.nn.FeedForwardNetwork.create(genome, config), steps, starts_again)
            evaluations += 1

    return evaluate


class SpeciesCounter(neat.reporting.BaseReporter):
    """Records how many species each evaluated generation has."""

    def __init__(self):
        self.counts = []

    def post_evaluate(self, config, population, species, best_genome):
        self.counts.append(len(species.species))


config = neat.Config(
    neat.DefaultGenome, neat.DefaultReproduction, neat.DefaultSpeciesSet, neat.DefaultStagnation, sys.argv[1]
)
config.genome_config.num_inputs = 6
config.genome_config.input_keys = [-1 - i for i in range(6)]
number, generations, steps = map(int, sys.argv[3:6])
if sys.argv[2] == "cost":
    config.pop_size = number
    random.seed(1)
    start = time.process_time()
    neat.Population(config).run(evaluator(steps, True), generations)
    seconds = time.process_time() - start
    print(
        f"neat-python: population {number}, {steps} decisions: {seconds / evaluations * 1e6:.1f} us per evaluation,"
        f" {seconds / decisions * 1e6:.2f} us per decision"
    )
else:
    config.no_fitness_termination = False
    config.fitness_threshold = steps
    needed = []
    counter = SpeciesCounter()
    for seed in range(number):
        evaluations = 0
        random.seed(seed)
        try:
            population = neat.Population(config)
            population.add_reporter(counter)
            winner = population.run(evaluator(steps, False), generations)
        except neat.CompleteExtinctionException:
            continue
        if winner.fitness >= steps:
            needed.append(evaluations)
    middle = f", median {statistics.median(needed):.0f} evaluations" if needed else ""
    species = statistics.mean(counter.counts)
    print(
        f"neat-python: {len(needed)} of {number} seeds solved{middle}; {species:.1f} species in the mean generation,"
        f" {max(counter.counts)} at most"
    )
