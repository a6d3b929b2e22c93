package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import mmneat.CompiledClasses;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.neat.BadPartException;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Parts of the user's own that throw or give something invalid: one line says which part, and what is wrong. */
class OwnPartsFailingTest {

    private static final String THROW = "throw new IllegalStateException(\"no idea\");";

    /** Throws a checked exception that no method declares. */
    private static final String SNEAK = "throw Sneaks.sneak(new java.io.IOException(\"two\\nlines\"));";

    private static final String SNEAKS =
            "package my; public class Sneaks { static RuntimeException sneak(Throwable t) {"
                    + " return Sneaks.<RuntimeException>as(t); } @SuppressWarnings(\"unchecked\")"
                    + " static <T extends Throwable> T as(Throwable t) throws T { throw (T) t; } }";

    @TempDir
    private static Path classes;

    @TempDir
    private Path folder;

    private static Path jar;

    @BeforeAll
    static void compile() throws IOException {
        List<String> sources = new ArrayList<>();
        sources.add(SNEAKS);
        sources.addAll(selections());
        sources.addAll(variations());
        sources.addAll(partsOfTheGame());
        jar = CompiledClasses.jar(
                CompiledClasses.compile(classes, System.getProperty("java.class.path"), sources.toArray(String[]::new)),
                classes.resolve("my-parts.jar"));
    }

    private static List<String> selections() {
        String survivors =
                "public int[] survivors(double[][] scores, int count, mmneat.random.ResumableRandom random) {";
        String parents =
                "public java.util.function.ToIntFunction<mmneat.random.ResumableRandom> parents(double[][] s) {";
        return Stream.of(
                        "Twins " + survivors + "return new int[count]; }",
                        "Few " + survivors + "return new int[] {0, 1}; }",
                        "Outside " + survivors + "return java.util.stream.IntStream.range(1, count).map(i -> 2 * i + 3)"
                                + ".limit(count).boxed().collect(java.util.stream.Collectors.collectingAndThen("
                                + "java.util.stream.Collectors.toList(), l -> { l.add(scores.length); return"
                                + " l.stream().mapToInt(i -> i).toArray(); })); }",
                        "Nothing " + survivors + "return null; }",
                        "SurvivorThrower " + survivors + THROW + "}",
                        "SurvivorSneak " + survivors + SNEAK + "}",
                        "NoParents " + parents + "return null; }",
                        "ParentOutside " + parents + "return random -> -1; }",
                        "ParentThrower " + parents + "return random -> { " + THROW + "}; }")
                .map(each -> source(each, "implements mmneat.nsga2.Selection"))
                .toList();
    }

    private static List<String> variations() {
        String apply = "public boolean apply(mmneat.neat.GenotypeDraft offspring, mmneat.neat.GenePool pool,"
                + " mmneat.random.ResumableRandom random) {";
        String cross = "public void cross(mmneat.neat.GenotypeDraft first, mmneat.neat.GenotypeDraft second,"
                + " mmneat.neat.Archetype archetype, mmneat.random.ResumableRandom random) {";
        Stream<String> mutations = Stream.of(
                        "LostInput " + apply + "offspring.nodes().remove(0); return true; }",
                        "NullLink " + apply + "offspring.links().set(0, null); return true; }",
                        "NullUsage " + apply + "offspring.setModuleUsage(null); return true; }",
                        "NoWeight " + apply + "offspring.links().replaceAll(link -> link.withWeight(0.0 / 0));"
                                + " return true; }",
                        "Stranger " + apply + "offspring.nodes().add(offspring.inputs(), new mmneat.neat.NodeGene("
                                + "7_000_000, mmneat.neat.NodeType.HIDDEN, mmneat.neat.ActivationFunction.TANH));"
                                + " return false; }",
                        "OtherFunction " + apply + "offspring.nodes().replaceAll(node -> node.withActivation("
                                + "mmneat.neat.ActivationFunction.own(\"my.Sine\", Math::sin))); return true; }",
                        "MutationThrower " + apply + THROW + "}",
                        "MutationSneak " + apply + SNEAK + "}",
                        "MutationCycle " + apply + "RuntimeException a = new RuntimeException(\"round\"), b = new"
                                + " RuntimeException(a); a.initCause(b); throw a; }")
                .map(each -> each.replaceFirst(" ", " public String logName() { return \"Own\"; } "))
                .map(each -> source(each, "implements mmneat.neat.variation.MutationOperator"));
        Stream<String> crossovers = Stream.of(
                        "NoOutput " + cross + "second.nodes().remove(second.nodes().size() - 1); }",
                        "NullLinkSecond " + cross + "second.links().add(null); }",
                        "NullNode " + cross + "first.nodes().set(0, null); }",
                        "CrossoverThrower " + cross + THROW + "}",
                        "CrossoverSneak " + cross + SNEAK + "}")
                .map(each -> source(each, "implements mmneat.neat.variation.CrossoverOperator"));
        String late = apply + "late = true; return true; } private boolean late; public String logName() { if (late) {";
        Stream<String> names = Stream.of(
                        "LateName " + late + "return null; } return \"Own\"; }",
                        "LateNameThrower " + late + THROW + "} return \"Own\"; }")
                .map(each -> source(each, "implements mmneat.neat.variation.MutationOperator"));
        return Stream.of(mutations, crossovers, names).flatMap(each -> each).toList();
    }

    private static List<String> partsOfTheGame() {
        String module = "public int modules() { return 2; }"
                + " public int module(mmneat.mspacman.sensors.Observation observation) {";
        String score = "public double score(pacman.game.Game game) {";
        String sense = "public double sense(mmneat.mspacman.sensors.Observation observation) {";
        String move = "public java.util.EnumMap<pacman.game.Constants.GHOST, pacman.game.Constants.MOVE> getMove("
                + "pacman.game.Game game, long timeDue) {";
        List<String> sources = new ArrayList<>();
        Stream.of(
                        "NegativeModule " + module + "return -1; }",
                        "ThirdModule " + module + "return 2; }",
                        "ModuleThrower " + module + THROW + "}",
                        "ModuleSneak " + module + SNEAK + "}",
                        "Unlabelled " + module + "return 0; } public String observation(int module) { return null; }",
                        "LabelThrower " + module + "return 0; } public String observation(int module) {" + THROW + "}")
                .map(each -> source(each, "implements mmneat.mspacman.modules.ModuleDivision"))
                .forEach(sources::add);
        Stream.of(
                        "NoScore " + score + "return Double.NaN; }",
                        "Endless " + score + "return Double.NEGATIVE_INFINITY; }",
                        "ScoreThrower " + score + THROW + "}",
                        "ScoreSneak " + score + SNEAK + "}",
                        "NameThrower " + score + "return 0; } public String name() {" + THROW + "}")
                .map(each -> source(each, "implements mmneat.mspacman.objectives.Objective"))
                .forEach(sources::add);
        Stream.of(
                        "Blind public String label() { return \"x\"; }" + sense + "return 0.0 / 0; }",
                        "Undirected public String label() { return \"x\"; } public boolean isDirectional() { return"
                                + " false; }" + sense + "return 1.0 / 0; }",
                        "SenseThrower public String label() { return \"x\"; }" + sense + THROW + "}",
                        "SenseSneak public String label() { return \"x\"; }" + sense + SNEAK + "}",
                        "SideThrower public String label() { return \"x\"; } public boolean isDirectional() {" + THROW
                                + "}" + sense + "return 0; }",
                        "SenseLabel public String label() {" + THROW + "}" + sense + "return 0; }",
                        "SenseLabelSneak public String label() {" + SNEAK + "}" + sense + "return 0; }")
                .map(each -> source(each, "implements mmneat.mspacman.sensors.Sensor"))
                .forEach(sources::add);
        String grade = "public String label() { return \"x\"; }"
                + " public int grade(mmneat.mspacman.sensors.Observation observation) {";
        String values = "public int grades() { return 4; } public double value(int grade) {";
        Stream.of(
                        "GradeOutside " + grade + "return 4; }" + values + "return grade; }",
                        "EndlessGrade " + grade + "return 1; }" + values + "return 1.0 / (grade - 3); }",
                        "GradeThrower " + grade + THROW + "}" + values + "return grade; }",
                        "NoGrades " + grade + "return 0; } public int grades() { return 0; }"
                                + " public double value(int grade) { return 0; }")
                .map(each -> source(each, "implements mmneat.mspacman.sensors.GradedSensor"))
                .forEach(sources::add);
        String controller = "extends pacman.controllers.Controller<"
                + "java.util.EnumMap<pacman.game.Constants.GHOST, pacman.game.Constants.MOVE>>";
        sources.add(source("MoveThrower " + move + THROW + "}", controller));
        sources.add(source("MoveSneak " + move + SNEAK + "}", controller));
        sources.add(source(
                "LateTeam private static int teams; public LateTeam() { if (++teams == 3) {" + SNEAK + "} }" + move
                        + "return null; }",
                controller));
        sources.add(source(
                "TextMoves " + move
                        + "java.util.EnumMap moves = new java.util.EnumMap(pacman.game.Constants.GHOST.class);"
                        + " moves.put(pacman.game.Constants.GHOST.SUE, \"left\"); return moves; }",
                controller));
        sources.add(source("NoMoves " + move + "return null; }", controller));
        sources.add(source(
                "AnyMoves " + move + "var moves = new java.util.EnumMap<pacman.game.Constants.GHOST,"
                        + " pacman.game.Constants.MOVE>(pacman.game.Constants.GHOST.class); for (var ghost :"
                        + " pacman.game.Constants.GHOST.values()) moves.put(ghost, ghost.ordinal() == 0 ? null :"
                        + " pacman.game.Constants.MOVE.values()[game.getTotalTime() % 5]); return moves; }",
                controller));
        sources.add("package my; class Hidden implements mmneat.nsga2.Selection { public Hidden() {} }");
        sources.add(source("MadeSneak public MadeSneak() {" + SNEAK + "}", "extends SurvivorThrower"));
        sources.add("package my; public abstract class Abstract implements mmneat.nsga2.Selection { }");
        sources.add("package my; public class Static implements mmneat.nsga2.Selection {"
                + " static final int NUMBER = Integer.parseInt(\"x\"); }");
        return sources;
    }

    private static String source(String nameAndBody, String type) {
        String[] parts = nameAndBody.split(" ", 2);
        return "package my; public class " + parts[0] + " " + type + " { " + parts[1] + " }";
    }

    private RunOutcome run(String... words) throws Exception {
        List<String> all = new ArrayList<>(List.of(
                "task=blended",
                "saveTo=run",
                "mu=6",
                "trials=1",
                "pacManLevelTimeLimit=200",
                "maxGens=2",
                "jar=" + jar,
                "base=" + folder));
        all.addAll(Arrays.asList(words));
        ParameterReader reader = new ParameterReader(ParameterCatalogue.load());
        return new ExperimentRunner(ExperimentPlan.of(reader.read(all).parameters()))
                .run()
                .get(0);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                selection=my.Twins                | selection my.Twins: the selection must name 6 different survivors of 12, 0 to 11; it named number 0 twice
                selection=my.Few                  | selection my.Few: the selection must name 6 different survivors of 12, 0 to 11; it named 2
                selection=my.Outside              | selection my.Outside: the selection must name 6 different survivors of 12, 0 to 11; it named number 13
                selection=my.Nothing              | selection my.Nothing: the selection must name 6 different survivors of 12, 0 to 11; it named null
                selection=my.SurvivorThrower      | selection my.SurvivorThrower: threw java.lang.IllegalStateException: no idea at my.SurvivorThrower.survivors
                selection=my.NoParents            | selection my.NoParents: parents gave null
                selection=my.ParentOutside        | selection my.ParentOutside: chose parent -1; parents are 0 to 5
                selection=my.ParentThrower        | selection my.ParentThrower: threw java.lang.IllegalStateException: no idea
                mutations=my.LostInput:1          | mutation my.LostInput: made an invalid network: nodes
                mutations=my.NullLink:1           | mutation my.NullLink: made an invalid network: contains a null link
                mutations=my.NoWeight:1           | mutation my.NoWeight: made an invalid network: links[0]: weight must be finite, is NaN
                mutations=my.Stranger:1           | this pool: nodes[30] of innovation 7000000 is not in its archetype
                mutations=my.OtherFunction:1      | mutation my.OtherFunction: made an invalid network: a neuron has the activation function my.Sine; it must be built in or that of the evolution, tanh
                mutations=my.MutationThrower:1    | mutation my.MutationThrower: threw java.lang.IllegalStateException: no idea at my.MutationThrower.apply
                crossover=my.NoOutput             | crossover my.NoOutput: made an invalid network: nodes: 33 are too few for 30 inputs and 4 outputs
                crossover=my.NullNode             | crossover my.NullNode: made an invalid network: contains a null node
                mutations=my.NullUsage:1          | mutation my.NullUsage: made an invalid network: moduleUsage is null
                crossover=my.NullLinkSecond       | crossover my.NullLinkSecond: made an invalid network: contains a null link
                mutations=my.LateName:1           | mutation my.LateName: logName gave null
                mutations=my.LateNameThrower:1    | mutation my.LateNameThrower: threw java.lang.IllegalStateException: no idea at my.LateNameThrower.logName
                crossover=my.CrossoverThrower     | crossover my.CrossoverThrower: threw java.lang.IllegalStateException: no idea
                objectives=my.NoScore             | objective my.NoScore: gave NaN; it must give a finite number
                objectives=my.Endless             | objective my.Endless: gave -Infinity; it must give a finite number
                objectives=my.ScoreThrower        | objective my.ScoreThrower: threw java.lang.IllegalStateException: no idea at my.ScoreThrower.score
                ownSensors=my.Blind               | sensor my.Blind: gave NaN; it must give a finite number
                ownSensors=my.Undirected          | sensor my.Undirected: gave Infinity; it must give a finite number
                ownSensors=my.SenseThrower        | sensor my.SenseThrower: threw java.lang.IllegalStateException: no idea at my.SenseThrower.sense
                ownSensors=my.GradeOutside        | sensor my.GradeOutside: gave grade 4; it must be 0 to 3
                ownSensors=my.GradeThrower        | sensor my.GradeThrower: threw java.lang.IllegalStateException: no idea at my.GradeThrower.grade
                ghostTeam=my.MoveThrower          | ghost team my.MoveThrower: threw java.lang.IllegalStateException: no idea at my.MoveThrower.getMove
                ghostTeam=my.TextMoves            | ghost team my.TextMoves: threw java.lang.ClassCastException: Cannot cast java.lang.String
                pacmanMultitaskScheme=my.NegativeModule | division my.NegativeModule: gave module -1; it must be 0 to 1
                pacmanMultitaskScheme=my.ThirdModule    | division my.ThirdModule: gave module 2; it must be 0 to 1
                pacmanMultitaskScheme=my.ModuleThrower  | division my.ModuleThrower: threw java.lang.IllegalStateException: no idea at my.ModuleThrower.module
                selection=my.SurvivorSneak        | selection my.SurvivorSneak: threw java.io.IOException: two?lines at my.
                mutations=my.MutationSneak:1      | mutation my.MutationSneak: threw java.io.IOException: two?lines at my.
                crossover=my.CrossoverSneak       | crossover my.CrossoverSneak: threw java.io.IOException: two?lines at my.
                objectives=my.ScoreSneak          | objective my.ScoreSneak: threw java.io.IOException: two?lines at my.
                ownSensors=my.SenseSneak          | sensor my.SenseSneak: threw java.io.IOException: two?lines at my.
                ghostTeam=my.MoveSneak            | ghost team my.MoveSneak: threw java.io.IOException: two?lines at my.
                pacmanMultitaskScheme=my.ModuleSneak | division my.ModuleSneak: threw java.io.IOException: two?lines at my.
                mutations=my.MutationCycle:1      | mutation my.MutationCycle: threw java.lang.RuntimeException: round at my.MutationCycle.apply
                """)
    void partThatFailsDuringARun_endsItWithOneLine(String word, String message) throws Exception {
        for (String way : List.of("parallelEvaluations=false", "parallelEvaluations=true")) {
            RunOutcome outcome = run(
                    word,
                    way,
                    "saveTo=" + way.replace('=', '-'),
                    word.startsWith("pacmanMulti") ? "method=MT2" : "method=2M");
            assertThat(outcome.message()).contains(message).doesNotContain("\n", "Exception: mmneat", "\tat ");
            assertThat(outcome.failure()).isNull();
            assertThat(outcome.isComplete()).isFalse();
        }
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                pacmanMultitaskScheme=my.Unlabelled   | pacmanMultitaskScheme=my.Unlabelled: observation(0) must not be null
                pacmanMultitaskScheme=my.LabelThrower | pacmanMultitaskScheme=my.LabelThrower: observation(0) threw java.lang.IllegalStateException: no idea
                objectives=my.NameThrower             | objectives=my.NameThrower: name() threw java.lang.IllegalStateException: no idea
                ownSensors=my.SenseLabel              | ownSensors=my.SenseLabel: label() threw java.lang.IllegalStateException: no idea
                selection=my.Hidden                   | selection=my.Hidden: the class must be public
                selection=my.Abstract                 | selection=my.Abstract: the class must not be abstract
                selection=my.Static                   | selection=my.Static: cannot be created: java.lang.NumberFormatException: For input string: "x"
                ownSensors=my.SenseLabelSneak         | ownSensors=my.SenseLabelSneak: label() threw java.io.IOException: two?lines
                selection=my.MadeSneak                | selection=my.MadeSneak: cannot be created: java.io.IOException: two?lines
                """)
    void partThatFailsWhenItIsMade_isAMistake(String word, String message) {
        assertThatThrownBy(() -> run(word, word.startsWith("pacmanMulti") ? "method=MT2" : "method=2M"))
                .isInstanceOf(UserError.class)
                .hasMessage(message);
    }

    /** The program prints the message of this exception alone, as it does for a user's mistake. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
                ownSensors=my.SideThrower         | sensor my.SideThrower: threw java.lang.IllegalStateException: no idea at my.SideThrower.isDirectional
                ownSensors=my.EndlessGrade        | sensor my.EndlessGrade: gave Infinity; it must give a finite number
                ownSensors=my.NoGrades            | sensor my.NoGrades: has 0 grades; it must have at least 1
                """)
    void sensorThatFailsBeforeTheFirstGame_isNamed(String word, String message) {
        assertThatThrownBy(() -> run(word))
                .isInstanceOf(BadPartException.class)
                .hasMessageStartingWith(message)
                .hasMessageNotContaining("\n");
    }

    /** A new team is created for each game. */
    @Test
    void ghostTeamThatCannotBeCreatedLater_endsTheRunWithOneLine() throws Exception {
        RunOutcome outcome = run("ghostTeam=my.LateTeam");
        assertThat(outcome.message())
                .contains("ghost team my.LateTeam: cannot be created: java.io.IOException: two?lines")
                .doesNotContain("UserError");
        assertThat(outcome.failure()).isNull();
    }

    /** By the rules of the game, a ghost without a move or with an impossible one goes on. */
    @Test
    void ghostTeamWithoutMoves_orWithImpossibleOnes_plays() throws Exception {
        assertThat(run("ghostTeam=my.NoMoves").isComplete()).isTrue();
        assertThat(run("ghostTeam=my.AnyMoves", "saveTo=any").isComplete()).isTrue();
    }
}
