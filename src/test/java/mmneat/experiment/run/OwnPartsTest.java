package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import mmneat.CompiledClasses;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Runs with parts of a user's own, in a jar: the examples, and others that are wrong. */
class OwnPartsTest {

    private static final String EXAMPLES = "src/examples/java";

    /** Files with clock times, or with the runs that were requested. */
    private static final Set<String> OF_THE_MOMENT = Set.of(
            "status.json",
            "parameters.properties",
            "checkpoint.json.gz",
            "checkpoint-previous.json.gz",
            "blended-run0_Performance_log.txt");

    @TempDir
    private static Path classes;

    @TempDir
    private Path folder;

    private static Path jar;

    @BeforeAll
    static void compile() throws IOException {
        List<String> sources = new ArrayList<>();
        for (String name : List.of(
                "Sine", "LateGame", "Survival", "TwoChasers", "WeightDecay", "AverageWeights", "BestSum", "Careful")) {
            sources.add(Files.readString(Path.of(EXAMPLES, name + ".java")));
        }
        sources.add("package pacman.controllers.mine; import java.util.EnumMap; import pacman.game.Constants.*;"
                + " public class Legacy extends pacman.controllers.Controller<EnumMap<GHOST, MOVE>> { private int calls;"
                + " public EnumMap<GHOST, MOVE> getMove(pacman.game.Game game, long timeDue) {"
                + " EnumMap<GHOST, MOVE> moves = new EnumMap<>(GHOST.class);"
                + " moves.put(GHOST.INKY, MOVE.values()[calls++ / 7 % 4]); return moves; } }");
        sources.add("package my; public class AnyPillsModeSelector implements mmneat.mspacman.modules.ModuleDivision {"
                + " public int modules() { return 2; }"
                + " public int module(mmneat.mspacman.sensors.Observation observation) {"
                + " return observation.isAtJunction() ? 0 : 1; } }");
        String edible = " { public String label() { return \"edible\"; }"
                + " public int grade(mmneat.mspacman.sensors.Observation observation) {"
                + " return observation.edibleGhosts(); } public int grades() { return 5; }"
                + " public double value(int grade) { return grade / 8.0; } ";
        sources.add("package my; public class Graded implements mmneat.mspacman.sensors.GradedSensor" + edible + "}");
        sources.add("package my; public class Plain implements mmneat.mspacman.sensors.Sensor" + edible
                + "public double sense(mmneat.mspacman.sensors.Observation o) { return value(grade(o)); } }");
        sources.add("package my; public class NoNumber implements mmneat.mspacman.objectives.Objective {"
                + " public double score(pacman.game.Game game) { return Double.NaN; } }");
        sources.add("package my; public class NoName implements mmneat.neat.variation.MutationOperator {"
                + " public String logName() { return \"two words\"; }"
                + " public boolean apply(mmneat.neat.GenotypeDraft offspring, mmneat.neat.GenePool pool,"
                + " mmneat.random.ResumableRandom random) { return false; } }");
        sources.add("package my; public class Gap implements mmneat.neat.NeuronFunction {"
                + " public double of(double sum) { return sum > 1.25 ? Double.NaN : sum; } }");
        sources.add("package my; public class Log implements mmneat.neat.NeuronFunction {"
                + " public double of(double sum) { return Math.log(sum); } }");
        sources.add("package my; public class Lock implements mmneat.neat.NeuronFunction {"
                + " private Lock() {} public double of(double sum) { return sum; } }");
        Path compiled =
                CompiledClasses.compile(classes, System.getProperty("java.class.path"), sources.toArray(String[]::new));
        jar = CompiledClasses.jar(compiled, classes.resolve("my-parts.jar"));
    }

    private RunOutcome run(String base, int generations, String... words) throws Exception {
        List<String> all = new ArrayList<>(List.of(
                "task=blended",
                "saveTo=run",
                "mu=6",
                "trials=1",
                "pacManLevelTimeLimit=300",
                "maxGens=" + generations,
                "jar=" + jar,
                "base=" + folder.resolve(base)));
        all.addAll(Arrays.asList(words));
        ParameterReader reader = new ParameterReader(ParameterCatalogue.load());
        return new ExperimentRunner(ExperimentPlan.of(reader.read(all).parameters()))
                .run()
                .get(0);
    }

    private Map<String, String> files(String base) throws IOException {
        Path of = folder.resolve(base).resolve("run0");
        try (Stream<Path> found = Files.walk(of)) {
            Map<String, String> texts = new TreeMap<>();
            for (Path file : found.filter(Files::isRegularFile).toList()) {
                if (!OF_THE_MOMENT.contains(file.getFileName().toString())) {
                    texts.put(of.relativize(file).toString(), Files.readString(file));
                }
            }
            return texts;
        }
    }

    @Test
    void gradedSensor_equalsAPlainOneWithTheSameValues() throws Exception {
        run("graded", 3, "ownSensors=my.Graded");
        run("plain", 3, "ownSensors=my.Plain");
        run("without", 3);

        assertThat(files("graded")).isEqualTo(files("plain")).isNotEqualTo(files("without"));
    }

    private void assertMistake(String message, String... words) {
        assertThatThrownBy(() -> run("mistake", 1, words))
                .isInstanceOf(UserError.class)
                .hasMessage(message);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "method=MT2 pacmanMultitaskScheme=LateGame",
                "activation=Sine",
                "method=MMD activation=Sine",
                "objectives=Survival,GameScore[Max],GhostRegretScore",
                "ghostTeam=TwoChasers",
                "ghostTeam=pacman.controllers.mine.Legacy",
                "mutations=WeightDecay:0.5",
                "crossover=AverageWeights",
                "selection=BestSum",
            })
    void interruptedRun_equalsAnUninterruptedOne_andDiffersFromOneWithoutThePart(String words) throws Exception {
        String[] parts = words.split(" ");
        for (int generations = 1; generations <= 3; generations++) {
            assertThat(run("interrupted", generations, parts).isComplete()).isTrue();
        }
        run("whole", 3, parts);
        run("plain", 3, parts.length > 1 ? parts[0] : "method=2M");

        assertThat(files("interrupted")).isEqualTo(files("whole")).isNotEqualTo(files("plain"));
    }

    @Test
    void classWithTheNameOfABuiltInOne_isTheUsersOwn() throws Exception {
        run("own", 2, "method=MT2", "pacmanMultitaskScheme=my.AnyPillsModeSelector");
        run("builtIn", 2, "method=MT2", "pacmanMultitaskScheme=AnyPillsModeSelector");
        assertThat(files("own")).isNotEqualTo(files("builtIn"));
        assertThat(Files.readString(folder.resolve("own/run0/parameters.properties")))
                .contains("pacmanMultitaskScheme=my.AnyPillsModeSelector");
    }

    @Test
    void publishedObjectivesByName_giveTheFilesOfTheDefault() throws Exception {
        run("named", 2, "objectives=GhostScore, PillScore");
        run("default", 2);
        assertThat(files("named")).isEqualTo(files("default"));
    }

    @Test
    void recordedScoreAsObjective_isTheRecordedNumber() throws Exception {
        run("recorded", 1, "objectives=GameScore[Max],SurvivalAndSpeedTimeScore,LevelGameScore#2", "trials=2");
        Map<String, String> files = files("recorded");
        List<String> objectives =
                files.get("blended-run0_parents_gen0.txt").lines().toList();
        List<String> others =
                files.get("blended-run0_parents_other_scores_gen0.txt").lines().toList();
        assertThat(files.get("generations.csv"))
                .contains("\"best GameScore[Max]\",\"best SurvivalAndSpeedTimeScore\",\"best LevelGameScore#2\"");
        assertThat(objectives).hasSize(6);
        for (int i = 0; i < objectives.size(); i++) {
            String[] selected = objectives.get(i).split("\t");
            String[] recorded = others.get(i).split("\t");
            // Number and id come first; the places are those of docs/specification/mspacman-task.md, section 5.
            assertThat(selected[2]).isEqualTo(recorded[3]);
            assertThat(selected[3]).isEqualTo(recorded[20]);
            assertThat(selected[4]).isEqualTo(recorded[23]);
        }
    }

    @Test
    void mutationOfOnesOwn_isInTheLogOfMutations() throws Exception {
        run("logged", 1, "mutations=WeightDecay:1");
        assertThat(files("logged").get("blended-run0_Mutations_log.txt").lines())
                .filteredOn(line -> !line.startsWith("---"))
                .hasSize(6)
                .allMatch(line -> line.endsWith(" WeightDecay "));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "pacmanMultitaskScheme=java.lang.String method=MT2 | mmneat.mspacman.modules.ModuleDivision",
                "objectives=java.lang.String | mmneat.mspacman.objectives.Objective",
                "mutations=java.lang.String:0.1 | mmneat.neat.variation.MutationOperator",
                "activation=java.lang.String | mmneat.neat.NeuronFunction",
                "crossover=java.lang.String | mmneat.neat.variation.CrossoverOperator",
                "selection=java.lang.String | mmneat.nsga2.Selection",
            })
    void wrongClass_isAMistakeThatNamesTheInterface(String words, String type) {
        String asked = words.split(" ")[0].replace(":0.1", "");
        assertMistake(asked + ": the class must implement " + type, words.split(" "));
        String missing = asked.replace("java.lang.String", "my.Nothing");
        assertMistake(
                missing + ": there is no such class in " + jar,
                words.replace("java.lang.String", "my.Nothing").split(" "));
    }

    @Test
    void otherUnusableParts_areMistakesThatSayWhatIsWrong() throws Exception {
        assertMistake(
                "ghostTeam=java.lang.String: the class must extend pacman.controllers.Controller",
                "ghostTeam=java.lang.String");
        assertMistake("ghostTeam=Careful: is a controller of Ms. Pac-Man, not of the ghosts", "ghostTeam=Careful");
        assertMistake(
                "mutations=WeightDecay:0.1,: a name is missing; separate the names by single commas",
                "mutations=WeightDecay:0.1,");
        assertMistake(
                "mutations=WeightDecay: must be the name of a class and its rate from 0 to 1, such as my.Operator:0.1",
                "mutations=WeightDecay");
        assertMistake(
                "mutations=WeightDecay:2: must be the name of a class and its rate from 0 to 1, such as my.Operator:0.1",
                "mutations=WeightDecay:2");
        assertMistake("mutations=my.NoName:1: logName() must be one word, is 'two words'", "mutations=my.NoName:1");
        assertMistake(
                "activation=Sine cannot be combined with ftype=2; leave one of them out", "activation=Sine", "ftype=2");
        assertMistake("activation=my.Lock: needs a public constructor without arguments", "activation=my.Lock");
        assertMistake(
                "activation function my.Log: gave -Infinity for the sum 0.0; it must give a finite number",
                "activation=my.Log");
        assertMistake("two objectives are called Survival", "objectives=Survival,Survival");
        assertMistake(
                "selection=BestSum cannot be combined with ea=TUGNSGA2; leave one of them out",
                "selection=BestSum",
                "ea=TUGNSGA2");
        assertThatThrownBy(() -> run("mistake", 1, "objectives=PilScore"))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith("objectives=PilScore: must be one of GameScore, GameScore[Max], PillScore, ")
                .hasMessageEndingWith("(did you mean 'PillScore'?)");
        assertThat(run("scores", 1, "objectives=my.NoNumber").message())
                .contains("NoNumber", "task=blended")
                .doesNotContain("\n");
        RunOutcome gap = run("gap", 1, "activation=my.Gap");
        assertThat(gap.message())
                .startsWith(
                        "task=blended: genotype 1 in generation 0, trial 1 of 1: activation function my.Gap: gave NaN for")
                .doesNotContain("\n");
        assertThat(gap.failure()).isNull();
    }

    @ParameterizedTest
    @ValueSource(strings = {"ghostTeam=Legasy", "pacmanMultitaskScheme=AnyPils", "crossover=TWEANCrossover"})
    void misspelledChoice_isAMistakeThatListsTheChoices(String word) {
        ParameterReader reader = new ParameterReader(ParameterCatalogue.load());
        assertThatThrownBy(() -> reader.read(List.of("task=blended", "method=MT2", word)))
                .isInstanceOf(UserError.class)
                .hasMessageStartingWith(word + ": must be ")
                .hasMessageContaining("or a class of your own");
    }

    @Test
    void checkpointOfAnotherActivationFunction_isNotContinued() throws Exception {
        run("other", 1, "activation=Sine");
        Path parameters = folder.resolve("other/run0/parameters.properties");
        Files.writeString(parameters, Files.readString(parameters).replace("activation=Sine", "activation="));
        assertThat(run("other", 2).message())
                .contains("has a neuron with the activation function Sine, but the settings have tanh")
                .doesNotContain("\n");
    }

    /** The folder of a run may come from another person. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "pacmanMultitaskScheme=LateGame multitaskModes=2",
                "objectives=Survival",
                "ghostTeam=TwoChasers",
                "activation=Sine",
                "mutations=WeightDecay:0.5",
                "crossover=AverageWeights",
                "selection=BestSum"
            })
    void partThatAFileNames_needsTheJarOnTheCommandLine(String words) throws Exception {
        String lines = Stream.of(("task=blended startingModes=1 jar=" + jar + " " + words).split(" "))
                .collect(Collectors.joining("\n"));
        Path file = Files.writeString(folder.resolve("parameters.properties"), lines);
        ParameterReader reader = new ParameterReader(ParameterCatalogue.load());
        assertThatThrownBy(() -> reader.read(List.of("config=" + file)))
                .isInstanceOf(UserError.class)
                .hasMessageContaining(words.split(" ")[0] + " is code from jar=" + jar);
        assertThat(reader.read(List.of("config=" + file, "jar=" + jar)).parameters())
                .isNotNull();
    }
}
