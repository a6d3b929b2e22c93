package mmneat.cli;

import picocli.CommandLine;
import picocli.CommandLine.Command;

/** Entry point of {@code mmneat.jar}: finds the command and runs it. */
@Command(
        name = "mmneat",
        mixinStandardHelpOptions = true,
        versionProvider = Main.Version.class,
        description = "Modular Multiobjective NEAT for Ms. Pac-Man.")
public final class Main {

    public static void main(String[] arguments) {
        System.exit(new CommandLine(new Main()).execute(arguments));
    }

    /** The version that the build wrote into the jar. */
    static final class Version implements CommandLine.IVersionProvider {
        @Override
        public String[] getVersion() {
            String version = Main.class.getPackage().getImplementationVersion();
            return new String[] {"MM-NEAT " + (version == null ? "(not packaged)" : version)};
        }
    }
}
