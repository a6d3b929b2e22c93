package mmneat.cli;

import java.io.PrintWriter;

/** The text that the program prints when it is called without arguments: the first commands for a newcomer. */
final class FirstPage {

    private static final String TEXT = """
            MM-NEAT evolves modular neural networks that play Ms. Pac-Man.

              java -jar mmneat.jar task=blended runs=2 mu=10 maxGens=20 trials=2   a first look, about a minute
              java -jar mmneat.jar task=blended runs=30                            an experiment of the paper, in full
              java -jar mmneat.jar task=interleaved method=MMD runs=30             another experiment
              java -jar mmneat.jar status results                                  progress and scores
              java -jar mmneat.jar params                                          all parameters

            task=blended|interleaved|isolated, method=1M|2M|3M|MMD|MT|MT2|MT3. To continue a stopped experiment, give the
            same command again. --help lists all commands.""";

    private FirstPage() {}

    static void print(PrintWriter out) {
        out.println(TEXT);
        out.flush();
    }
}
