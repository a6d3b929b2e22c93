package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import mmneat.CompiledClasses;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.sensors.Observation;
import mmneat.neat.ActivationFunction;
import mmneat.neat.Genotype;
import mmneat.neat.io.GenotypeJson;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Folders of runs that name classes: a command loads them only if its own words name the jar. */
class CodeOfFoldersTest extends CommandTest {

    @TempDir
    Path base;

    private Path folder;
    private Path classes;
    private Path trace;

    @BeforeEach
    void folderOfSomeoneElse() throws IOException {
        trace = base.resolve("was-here");
        String body = " static { try { java.nio.file.Files.writeString(java.nio.file.Path.of(\"" + trace
                + "\"), \"x\"); } catch (java.io.IOException e) { throw new RuntimeException(e); } }";
        classes = CompiledClasses.compile(
                base,
                System.getProperty("java.class.path"),
                "public final class Evil implements mmneat.mspacman.sensors.Sensor {" + body
                        + " public String label() { return \"Evil\"; }"
                        + " public double sense(mmneat.mspacman.sensors.Observation observation) { return 0; } }",
                "public final class Bad implements mmneat.neat.NeuronFunction {" + body
                        + " public double of(double sum) { return sum; } }",
                "public final class Other {" + body + "}");
        folder = Files.createDirectories(base.resolve("runs/2M0"));
        Files.writeString(
                folder.resolve("champion.json"),
                GenotypeJson.write(ShippedChampions.read("blended").genotype()));
        Files.writeString(folder.resolve("generations.csv"), "generation,best\n0,1000\n");
        parameters("task=blended", "ownSensors=Evil", "jar=" + classes);
    }

    static Stream<List<String>> commands() {
        return Stream.of(
                List.of("watch", "RUN", "out=OUT.html"),
                List.of("evaluate", "RUN", "games=1"),
                List.of("report", "RUN", "out=OUT.html", "replays=true"),
                List.of("report", "RUN", "out=OUT.html"),
                List.of("play", "pacman=RUN", "view=false"),
                List.of("network", "RUN", "format=svg", "out=OUT.svg"),
                List.of("network", "RUN", "out=-"),
                List.of("tasks", "players=RUN", "games=1"),
                List.of("record-ghosts", "RUN", "out=OUT.txt"),
                List.of("compare", "RUN"),
                List.of("status", "RUN"),
                List.of("config=RUN/parameters.properties", "mu=4", "maxGens=1", "trials=1", "quiet=true", "base=OUT"),
                List.of("process", "config=RUN/parameters.properties"),
                List.of("submit", "config=RUN/parameters.properties", "engine=parallel"));
    }

    @ParameterizedTest
    @MethodSource("commands")
    void sensorsOfAFolder_areNotLoaded(List<String> command) {
        run(command);
        assertThat(trace).doesNotExist();
    }

    @ParameterizedTest
    @MethodSource("commands")
    void taskOfAFolder_isNotLoaded(List<String> command) throws IOException {
        parameters("task=my.Evil", "jar=" + classes);
        run(command);
        parameters("task=Evil", "jar=" + classes);
        run(command);
        assertThat(trace).doesNotExist();
    }

    @ParameterizedTest
    @MethodSource("commands")
    void activationFunctionOfAFolder_isNotLoaded(List<String> command) throws IOException {
        for (String name : List.of("Bad", Near.class.getName())) {
            champion(name);
            parameters("task=blended", "activation=" + name, "jar=" + classes);
            run(command);
            parameters("task=blended", "jar=" + classes);
            run(command);
        }
        assertThat(trace).doesNotExist();
        assertThat(System.getProperty("mmneat.test.loaded")).isNull();
    }

    @Test
    void activationFunctionOfANetworkAlone_needsTheJar() throws IOException {
        champion("Bad");
        Path alone = Files.copy(folder.resolve("champion.json"), base.resolve("alone.json"));
        String refusal =
                alone + ": activation=Bad is code from a jar that the file does not name, and code is loaded only"
                        + " if the command line names its jar; if you trust it, give jar=FILE";
        assertMistake(refusal, "watch", alone.toString(), "task=blended", "out=" + base.resolve("out.html"));
        assertMistake(refusal, "play", "pacman=" + alone, "view=false");
        execute("network", alone.toString(), "out=" + base.resolve("out.svg"));
        assertThat(base.resolve("out.svg")).exists();
        assertThat(trace).doesNotExist();

        execute("play", "pacman=" + alone, "view=false", "jar=" + classes);
        assertThat(trace).exists();
        assertThat(out.toString()).contains("score: mean");
    }

    /** Replaces the champion of the folder by one with an activation function that is a class. */
    private void champion(String activation) throws IOException {
        Genotype network = ShippedChampions.read("blended").genotype();
        Files.writeString(
                folder.resolve("champion.json"),
                GenotypeJson.write(network.withFunctions(tanh -> ActivationFunction.ofClass(activation))));
    }

    @ParameterizedTest
    @MethodSource("commands")
    void classesOfOurOwnClassPath_areNotLoadedByName(List<String> command) throws IOException {
        parameters("task=blended", "ownSensors=mmneat.cli.CodeOfFoldersTest$Near");
        run(command);
        parameters("task=mmneat.cli.CodeOfFoldersTest$Near");
        run(command);
        assertThat(System.getProperty("mmneat.test.loaded")).isNull();
    }

    /** A class on the class path that records its initialisation. */
    static final class Near {
        static {
            System.setProperty("mmneat.test.loaded", "yes");
        }
    }

    @Test
    void refusal_saysWhichJarTheRunNeeds_andHowToAllowIt() {
        assertMistake(
                "ownSensors=Evil is code from jar=" + classes
                        + ", and code is loaded only if the command line names its jar; if you trust it, give jar="
                        + classes,
                "evaluate",
                folder.toString(),
                "games=1");
    }

    @Test
    void jarOnTheCommandLine_allowsTheClasses() {
        execute("evaluate", folder.toString(), "games=1", "jar=" + classes);
        assertThat(trace).exists();
        // The champion was evolved without this sensor.
        assertThat(errors.toString()).contains("the network has 30 inputs").doesNotContain("code");
    }

    /** The division of a test is on the class path, as in a project that uses the libraries. */
    @Test
    void emptyJar_allowsClassesOnTheClassPath() throws IOException {
        String[] evolution = {
            "task=blended",
            "method=MT2",
            "pacmanMultitaskScheme=" + NoPowerPills.class.getName(),
            "base=" + base.resolve("own"),
            "mu=4",
            "maxGens=1",
            "trials=1"
        };
        assertThat(execute(evolution)).isZero();
        String run = base.resolve("own/MT20").toString();
        assertThat(out.toString()).contains(" watch " + run + " jar=\n", " network " + run + "/champion.json jar=\n");

        assertMistake("(jar= if it is on the class path)", "evaluate", run, "games=1");
        assertThat(execute("evaluate", run, "games=1", "jar=")).isZero();
        assertThat(execute("network", run, "out=-", "jar=")).isZero();
    }

    /** A division on the class path of the tests. */
    public static final class NoPowerPills implements ModuleDivision {
        @Override
        public int modules() {
            return 2;
        }

        @Override
        public int module(Observation observation) {
            return observation.powerPillsLeft() > 0 ? 0 : 1;
        }
    }

    @Test
    void namedClassThatIsNoSensor_doesNotRun() throws IOException {
        parameters("task=blended", "ownSensors=Other");
        assertMistake("must implement", "evaluate", folder.toString(), "games=1", "jar=" + classes);
        assertThat(trace).doesNotExist();
    }

    private void run(List<String> command) {
        String[] words = command.stream()
                .map(word -> word.replace("RUN", folder.toString())
                        .replace("OUT", base.resolve("out").toString()))
                .toArray(String[]::new);
        execute(words);
        assertThat(errors.toString()).doesNotContain("\tat ");
    }

    private void parameters(String... lines) throws IOException {
        Files.writeString(folder.resolve("parameters.properties"), String.join("\n", lines) + "\n");
    }
}
