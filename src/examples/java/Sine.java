import mmneat.cli.Main;
import mmneat.neat.NeuronFunction;

/** An activation function: the sine of the sum. StrictMath gives the same results on every machine. */
public class Sine implements NeuronFunction {
    public double of(double sum) {
        return StrictMath.sin(sum);
    }

    public static void main(String[] arguments) {
        Main.main("task=blended activation=Sine mu=10 maxGens=3 trials=2 base=results/sine".split(" "));
    }
}
