package mmneat.mspacman;

import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.sensors.Observation;
import mmneat.mspacman.sensors.suite.NetworkInputs;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.network.ModuleArbitration;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkStates;
import mmneat.random.Argmax;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.Nullable;
import pacman.game.Game;

/**
 * The player of Ms.&nbsp;Pac-Man: activates a network once per open direction and chooses the direction with the
 * highest output.
 *
 * <p>Every direction has its own network state, which is kept while the direction stays open. Directions are numbered
 * UP 0, RIGHT 1, DOWN 2, LEFT 3. Not thread-safe; a step allocates nothing.
 *
 * <p>Source: docs/specification/mspacman-task.md, section 3; the paper's section on direction evaluation.
 */
public final class DirectionEvaluator {

    /** Returned instead of a direction to request the end of the game. */
    public static final int END_GAME = -1;

    private static final int DIRECTIONS = 4;
    private static final double WALL = -1;

    private final NetworkInputs sensors;

    /** Selects the module of a step, or the group of a hybrid; null if only preference neurons choose. */
    private final @Nullable ModuleDivision division;

    private final NetworkStates states;
    /** Preference for each direction, if exact preferences were needed for the comparison. */
    private final double[] preferences = new double[DIRECTIONS];

    private final ModuleUse use;
    private final boolean usesTanh;
    private int livesBefore = -1;

    /** Open directions of the last decision, as a bit set. */
    private int open;

    /**
     * Creates a player with a network.
     *
     * @param sensors sensors that no other player uses
     * @param genotype with as many inputs as there are sensors and one policy neuron per module
     * @param arbitration how the network chooses among its modules
     * @param division selects the module of each step; null if the network's preference neurons choose
     * @throws IllegalArgumentException if the genotype does not fit the sensors or the division
     */
    public DirectionEvaluator(
            NetworkInputs sensors,
            Genotype genotype,
            ModuleArbitration arbitration,
            @Nullable ModuleDivision division) {
        Network network = Network.compile(genotype);
        if (network.inputs() != sensors.suite().size()) {
            throw new IllegalArgumentException("the network has " + network.inputs() + " inputs, but there are "
                    + sensors.suite().size() + " sensors");
        }
        if (network.layout().isDivided() && division == null) {
            throw new IllegalArgumentException(
                    "a multitask network needs a division of the task (pacmanMultitaskScheme)");
        }
        if (division != null && network.layout().isDivided() && network.layout().choicesOfTask() < division.modules()) {
            throw new IllegalArgumentException("the division of the task names " + division.modules()
                    + (network.layout().isGrouped() ? " groups of" : "") + " modules, but the network has "
                    + network.layout().choicesOfTask());
        }
        this.sensors = sensors;
        this.division = network.layout().isDivided() ? division : null;
        states = network.newStates(DIRECTIONS, arbitration);
        use = new ModuleUse(network.modules());
        usesTanh = genotype.nodes().stream()
                .limit(genotype.inputs())
                .allMatch(input -> input.activation() == ActivationFunction.TANH);
    }

    /** Resets the player for the next game. */
    public void startGame() {
        states.reset();
        use.clear();
        livesBefore = -1;
    }

    /**
     * Decides on a move.
     *
     * @param game read, not changed
     * @param random generator; a decision draws one number per open direction (choice of the module) and two to break
     *     ties between directions
     * @return 0 to 3, or {@link #END_GAME} if the last level is finished or the time limit of the level is reached
     */
    public int decide(Game game, ResumableRandom random) {
        if (game.getCurrentLevel() >= game.rules().levels().maximumLevel()) {
            return END_GAME;
        }
        flushAfterChange(game);
        if (game.levelTimeLeft() <= 0) {
            return END_GAME;
        }
        sensors.observe(game);
        Observation state = sensors.observation();
        int observation = ModuleUse.observation(state.highestEdibleTime() > 0, state.isAtJunction());
        if (division != null) {
            states.presetModule(division.module(state));
        }
        if (usesTanh) {
            activateTogether(state, random);
        } else {
            activateOneByOne(state, random);
        }
        for (int d = 0; d < DIRECTIONS; d++) {
            if (wasOpen(d)) {
                use.countNetwork(d, observation, states.get(d).lastModule());
            }
        }
        int clear = states.clearlyHighest(open, 0);
        for (int d = 0; clear < 0 && d < DIRECTIONS; d++) {
            preferences[d] = preference(d);
        }
        // Quirk of the original: at a tie, the counted module may be that of a direction that was not chosen.
        use.countDecision(
                observation, states.get(preferredDirection(clear, random)).lastModule());
        return preferredDirection(clear, random);
    }

    /** Activates the network for all directions together, with input activations from tables. */
    private void activateTogether(Observation state, ResumableRandom random) {
        open = 0;
        for (int d = 0; d < DIRECTIONS; d++) {
            if (state.isOpen(d)) {
                open |= 1 << d;
                sensors.sense(d);
            } else {
                states.get(d).flush();
            }
        }
        states.activate(open, sensors.activations(), sensors.suite().size(), random);
    }

    private void activateOneByOne(Observation state, ResumableRandom random) {
        open = 0;
        for (int d = 0; d < DIRECTIONS; d++) {
            if (state.isOpen(d)) {
                open |= 1 << d;
                states.get(d).activate(sensors.inputs(d), random);
            } else {
                states.get(d).flush();
            }
        }
    }

    /** Flushes the network states at the start of a level and after a lost life. */
    private void flushAfterChange(Game game) {
        int lives = game.getPacmanNumberOfLivesRemaining();
        if (game.getCurrentLevelTime() == 0 || lives < livesBefore) {
            states.flush();
        }
        livesBefore = lives;
    }

    /**
     * Returns the direction with the highest preference. It draws a random number even if there is no tie.
     *
     * @param clear the direction if it is already known; below 0 if exact preferences must be compared
     */
    private int preferredDirection(int clear, ResumableRandom random) {
        if (clear >= 0) {
            random.nextInt(1);
            return clear;
        }
        return Argmax.of(preferences, random);
    }

    /** Counts of module use since the game started; the object changes with further steps. */
    public ModuleUse moduleUse() {
        return use;
    }

    /**
     * Returns the module usage that is stored in the genotype: that of the LEFT direction's network, a quirk of the
     * original.
     */
    int[] rememberedModuleUsage() {
        return states.get(DIRECTIONS - 1).moduleUsage();
    }

    /**
     * Value of a direction in the last decision: the activation of the policy neuron of the module that the direction's
     * network chose; -1 if a wall is there. The direction with the largest value is taken. It has nothing to do with
     * the preference neuron, which chooses the module.
     */
    public double preference(int direction) {
        return wasOpen(direction) ? states.get(direction).policyOutput(0) : WALL;
    }

    /** Whether a direction was open in the last decision. */
    public boolean wasOpen(int direction) {
        return (open >> direction & 1) != 0;
    }

    /** The module that the network of a direction used last. */
    public int lastModule(int direction) {
        return states.get(direction).lastModule();
    }
}
