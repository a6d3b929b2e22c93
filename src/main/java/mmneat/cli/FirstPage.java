package mmneat.cli;

import java.io.PrintWriter;

/** What stands on the screen when the program is started without a word: the few commands that a newcomer needs. */
final class FirstPage {

    private static final String TEXT = """
            MM-NEAT evolves modular neural networks that play Ms. Pac-Man.

              java -jar mmneat.jar task=blended runs=2 mu=10 maxGens=20 trials=2   a first look, a minute or so
              java -jar mmneat.jar task=blended runs=30                            an experiment of the paper, in full
              java -jar mmneat.jar task=interleaved method=MMD runs=30             another one
              java -jar mmneat.jar status results                                  what is done, and what came out
              java -jar mmneat.jar params                                          everything that can be set

            task=blended|interleaved|isolated, method=1M|2M|3M|MMD|MT|MT2|MT3. What is stopped goes on when the same command is
            given again. --help lists all commands.""";

    private FirstPage() {}

    static void print(PrintWriter out) {
        out.println(TEXT);
        out.flush();
    }
}
