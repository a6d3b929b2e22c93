import java.util.List;
import java.util.Map;
import mmneat.evolution.Evaluation;
import mmneat.evolution.Task;
import mmneat.neat.Genotype;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkState;
import mmneat.random.ResumableRandom;

/**
 * Double pole balancing with velocities: a cart of 1 kg on a track of 4.8 m carries poles of 1 m and 0.1 m. The fitness
 * is the number of decisions, one each 0.02 s, until the cart leaves the track or a pole leans more than 36 degrees.
 *
 * <p>Parameters: {@code task.steps} is the number of decisions after which the poles count as balanced (10,000). With
 * {@code task.again=true} the poles are set up again whenever they fall, until that number is reached. All evaluations
 * are then equally long, to compare their times.
 *
 * <p>Source: A. Wieland, Evolving neural network controllers for unstable systems, 1991; start and scaling of inputs as
 * in K. Stanley and R. Miikkulainen, Evolving neural networks through augmenting topologies, 2002, section 4.2.
 */
public final class DoublePoleTask implements Task {

    private static final double GRAVITY = -9.8;
    private static final double CART_KILOGRAMS = 1;
    private static final double[] POLE_KILOGRAMS = {0.1, 0.01};
    private static final double[] HALF_POLE_METRES = {0.5, 0.05};
    private static final double CART_FRICTION = 0.0005;
    private static final double HINGE_FRICTION = 0.000002;
    private static final double MOST_NEWTONS = 10;
    private static final double SECONDS = 0.01;
    private static final int INTEGRATIONS = 2;
    private static final double HALF_TRACK_METRES = 2.4;
    private static final double MOST_RADIANS = Math.toRadians(36);
    private static final double FIRST_RADIANS = Math.toRadians(4.5);

    private final int steps;
    private final boolean startsAgain;

    public DoublePoleTask(Map<String, String> parameters) {
        steps = Integer.parseInt(parameters.getOrDefault("steps", "10000"));
        startsAgain = Boolean.parseBoolean(parameters.getOrDefault("again", "false"));
    }

    @Override
    public List<String> objectiveNames() {
        return List.of("Steps");
    }

    @Override
    public List<String> inputLabels() {
        return List.of("Bias", "Position", "Velocity", "Angle 1", "Turn 1", "Angle 2", "Turn 2");
    }

    @Override
    public int policyNeuronsPerModule() {
        return 1;
    }

    @Override
    public boolean isDeterministic() {
        return true;
    }

    @Override
    public Evaluation evaluate(Genotype genotype, ResumableRandom random) {
        NetworkState network = Network.compile(genotype).newState();
        int[] moduleUsage = new int[genotype.modules()];
        double[] inputs = new double[7];
        double[] state = start();
        int balanced = 0;
        int done = 0;
        boolean hasFallen = false;
        while (done < steps && (startsAgain || !hasFallen)) {
            inputs[0] = 1;
            inputs[1] = state[0] / 4.8;
            inputs[2] = state[1] / 2;
            inputs[3] = state[2] / 0.52;
            inputs[4] = state[3] / 2;
            inputs[5] = state[4] / 0.52;
            inputs[6] = state[5] / 2;
            moduleUsage[network.activate(inputs, random)]++;
            double force = MOST_NEWTONS * Math.max(-1, Math.min(1, network.policyOutput(0)));
            for (int i = 0; i < INTEGRATIONS; i++) {
                state = next(state, force);
            }
            done++;
            if (!hasFallen) {
                balanced++;
            }
            if (hasFallen(state)) {
                hasFallen = true;
                state = start();
                network.flush();
            }
        }
        return new Evaluation(
                new double[] {balanced}, new double[0], moduleUsage, new Evaluation.Outcomes(0, 0, 0, done));
    }

    private static double[] start() {
        return new double[] {0, 0, FIRST_RADIANS, 0, 0, 0};
    }

    private static boolean hasFallen(double[] state) {
        return !(Math.abs(state[0]) <= HALF_TRACK_METRES
                && Math.abs(state[2]) <= MOST_RADIANS
                && Math.abs(state[4]) <= MOST_RADIANS);
    }

    /** One Runge-Kutta integration of fourth order. */
    private static double[] next(double[] state, double force) {
        double[] k1 = slopes(state, force);
        double[] k2 = slopes(moved(state, k1, SECONDS / 2), force);
        double[] k3 = slopes(moved(state, k2, SECONDS / 2), force);
        double[] k4 = slopes(moved(state, k3, SECONDS), force);
        double[] next = new double[state.length];
        for (int i = 0; i < next.length; i++) {
            next[i] = state[i] + SECONDS / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
        }
        return next;
    }

    private static double[] moved(double[] state, double[] slopes, double seconds) {
        double[] moved = new double[state.length];
        for (int i = 0; i < moved.length; i++) {
            moved[i] = state[i] + seconds * slopes[i];
        }
        return moved;
    }

    /** Wieland's equations of motion: velocities and accelerations of the cart and both poles. */
    private static double[] slopes(double[] state, double force) {
        double[] slopes = new double[state.length];
        double pushes = force - CART_FRICTION * Math.signum(state[1]);
        double kilograms = CART_KILOGRAMS;
        for (int pole = 0; pole < 2; pole++) {
            double angle = state[2 + 2 * pole];
            double turn = state[3 + 2 * pole];
            double sine = Math.sin(angle);
            double cosine = Math.cos(angle);
            double leverage = POLE_KILOGRAMS[pole] * HALF_POLE_METRES[pole];
            double hinge = HINGE_FRICTION * turn / leverage;
            pushes += leverage * turn * turn * sine + 0.75 * POLE_KILOGRAMS[pole] * cosine * (hinge + GRAVITY * sine);
            kilograms += POLE_KILOGRAMS[pole] * (1 - 0.75 * cosine * cosine);
            slopes[2 + 2 * pole] = turn;
            slopes[3 + 2 * pole] = hinge + GRAVITY * sine;
        }
        slopes[0] = state[1];
        slopes[1] = pushes / kilograms;
        for (int pole = 0; pole < 2; pole++) {
            double cosine = Math.cos(state[2 + 2 * pole]);
            slopes[3 + 2 * pole] = -0.75 / HALF_POLE_METRES[pole] * (slopes[1] * cosine + slopes[3 + 2 * pole]);
        }
        return slopes;
    }
}
