import java.util.List;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.LinkGene;
import mmneat.neat.ModuleLayout;
import mmneat.neat.NodeGene;
import mmneat.neat.NodeType;
import mmneat.neat.network.Network;
import mmneat.neat.network.NetworkState;
import mmneat.random.ResumableRandom;

/** Activates a network of one link. */
public class NeatUser {
    public static void main(String[] arguments) {
        List<NodeGene> nodes = List.of(
                new NodeGene(-1, NodeType.INPUT, ActivationFunction.TANH),
                new NodeGene(-2, NodeType.OUTPUT, ActivationFunction.TANH));
        List<LinkGene> links = List.of(new LinkGene(1, -1, -2, 0.5, false));
        Genotype genotype = new Genotype(0, 1, ModuleLayout.single(1), nodes, links, new int[1]);
        NetworkState state = Network.compile(genotype).newState();
        state.activate(new double[] {1}, new ResumableRandom(0));
        System.out.println(state.policyOutput(0) == StrictMath.tanh(0.5 * StrictMath.tanh(1)));
    }
}
