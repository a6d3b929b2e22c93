package mmneat;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.domain.JavaModifier;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.dependencies.SlicesRuleDefinition;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;

/**
 * The packages and the directions between them: nothing depends on what stands above it.
 *
 * <p>Plain tests check the rules: as fields for ArchUnit's own engine they were not run by the build, which passed.
 */
class ArchitectureTest {

    private static final JavaClasses OURS = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .importPackages("mmneat", "pacman");

    @Test
    void classes_areThere_andARuleCanFail() {
        assertThat(OURS).hasSizeGreaterThan(300);
        ArchRule untrue = packageUsesOnly("mmneat.neat..", new String[] {"mmneat.random.."});
        assertThatThrownBy(() -> untrue.check(OURS))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("mmneat.neat.Genotype");
        ArchRule ofNobody = packageUsesOnly("mmneat.nowhere..", new String[] {"mmneat.random.."});
        assertThatThrownBy(() -> ofNobody.check(OURS)).isInstanceOf(AssertionError.class);
    }

    @Test
    void random_dependsOnNothingOfOurs() {
        ArchRule rule = packageUsesOnly("mmneat.random..", new String[] {"mmneat.random.."});
        rule.check(OURS);
    }

    @Test
    void simulator_knowsOnlyTheGenerator() {
        ArchRule rule = packageUsesOnly("pacman..", new String[] {"pacman..", "mmneat.random.."});
        rule.check(OURS);
    }

    @Test
    void mazes_knowNoGame() {
        ArchRule rule = packageUsesOnly("pacman.maze..", new String[] {"pacman.maze.."});
        rule.check(OURS);
    }

    /** The classes of 2012 that refer back to {@code pacman.game}: the competition published their signatures. */
    private static final Set<String> COMPETITION_SHELLS = Set.of(
            "pacman.game.internal.AStar",
            "pacman.game.internal.Ghost",
            "pacman.game.internal.Node",
            "pacman.game.internal.PacMan",
            "pacman.game.internal.PathsCache");

    @Test
    void simulator_hasNoCyclesOfPackages() {
        SlicesRuleDefinition.slices()
                .matching("(pacman..)")
                .should()
                .beFreeOfCycles()
                .ignoreDependency(
                        DescribedPredicate.describe(
                                "are shells of the competition",
                                origin -> COMPETITION_SHELLS.contains(origin.getName())),
                        JavaClass.Predicates.resideInAPackage("pacman.game"))
                .check(OURS);
    }

    @Test
    void neat_knowsOnlyTheGenerator() {
        ArchRule rule = packageUsesOnly("mmneat.neat..", new String[] {"mmneat.neat..", "mmneat.random.."});
        rule.check(OURS);
    }

    @Test
    void nsga2_knowsOnlyTheGenerator() {
        ArchRule rule = packageUsesOnly("mmneat.nsga2..", new String[] {"mmneat.nsga2..", "mmneat.random.."});
        rule.check(OURS);
    }

    @Test
    void evolution_knowsNoGame() {
        ArchRule rule = packageUsesOnly(
                "mmneat.evolution..",
                new String[] {"mmneat.evolution..", "mmneat.neat..", "mmneat.nsga2..", "mmneat.random.."});
        rule.check(OURS);
    }

    @Test
    void task_knowsNoExperiment() {
        ArchRule rule = packageUsesOnly("mmneat.mspacman..", new String[] {
            "mmneat.mspacman..", "mmneat.evolution..", "mmneat.neat..", "mmneat.random..", "pacman.."
        });
        rule.check(OURS);
    }

    /** The shells of the competition's interface and the game refer to each other, as entries of 2012 expect. */
    @Test
    void packages_areFreeOfCycles() {
        slices().matching("(mmneat..)").should().beFreeOfCycles().check(OURS);
        slices().matching("(pacman..)")
                .should()
                .beFreeOfCycles()
                .ignoreDependency(
                        JavaClass.Predicates.resideInAPackage("pacman.game"),
                        JavaClass.Predicates.resideInAPackage("pacman.game.internal"))
                .check(OURS);
    }

    @Test
    void publicTypes_haveNamesOfTheirOwn() {
        Map<String, List<JavaClass>> byName = OURS.stream()
                .filter(type -> type.isTopLevelClass()
                        && type.getModifiers().contains(JavaModifier.PUBLIC)
                        && !type.getSimpleName().equals("package-info"))
                .collect(Collectors.groupingBy(JavaClass::getSimpleName));
        assertThat(byName.values()).allSatisfy(types -> assertThat(types).hasSize(1));
    }

    @Test
    void variation_isAboveGenotypes() {
        packageUsesOnly("mmneat.neat", new String[] {"mmneat.neat", "mmneat.random"})
                .check(OURS);
        packageUsesOnly(
                        "mmneat.neat.variation..",
                        new String[] {"mmneat.neat", "mmneat.neat.variation..", "mmneat.random"})
                .check(OURS);
    }

    @Test
    void experiment_isBuiltOnParametersAndStore() {
        for (String below : List.of("", ".parameters", ".store", ".original", ".cluster")) {
            noClasses()
                    .that()
                    .resideInAPackage("mmneat.experiment" + below)
                    .should()
                    .dependOnClassesThat()
                    .resideInAPackage("mmneat.experiment.run")
                    .check(OURS);
        }
        noClasses()
                .that()
                .resideInAPackage("mmneat.experiment.parameters")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(
                        "mmneat.experiment.store", "mmneat.experiment.original", "mmneat.experiment.cluster")
                .check(OURS);
    }

    @Test
    void experiment_knowsNoAnalysis() {
        ArchRule rule = noClasses()
                .that()
                .resideInAPackage("mmneat.experiment..")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("mmneat.analysis..", "mmneat.cli..");
        rule.check(OURS);
    }

    @Test
    void analysis_knowsNoCommands() {
        ArchRule rule = noClasses()
                .that()
                .resideInAPackage("mmneat.analysis..")
                .should()
                .dependOnClassesThat()
                .resideInAPackage("mmneat.cli..");
        rule.check(OURS);
    }

    /**
     * The public variables of the competition's interface, which entries may assign. Nothing of ours depends on them, but
     * for the view, which paints the debug drawing.
     */
    private static final Set<String> COMPETITION_VARIABLES = Set.of(
            "pacman.game.Constants.pathImages",
            "pacman.game.Constants.mazeNames",
            "pacman.game.Game.caches",
            "pacman.game.GameView.debugPointers",
            "pacman.game.GameView.debugLines");

    /** Two games or two experiments in one JVM share nothing that changes. */
    @Test
    void staticFields_areFinal() {
        ArchRule rule = fields().that()
                .areStatic()
                .and(DescribedPredicate.not(DescribedPredicate.describe(
                        "are variables of the competition's interface",
                        field -> COMPETITION_VARIABLES.contains(field.getFullName()))))
                .should()
                .beFinal();
        rule.check(OURS);
    }

    @Test
    void randomness_comesFromTheGeneratorThatIsPassedIn() {
        ArchRule rule = noClasses()
                .that()
                .doNotBelongToAnyOf(ResumableRandom.class)
                .should()
                .dependOnClassesThat()
                .belongToAnyOf(java.util.Random.class, java.util.concurrent.ThreadLocalRandom.class)
                .orShould()
                .callMethod(Math.class, "random");
        rule.check(OURS);
    }

    private static ArchRule packageUsesOnly(String subject, String[] allowed) {
        return classes()
                .that()
                .resideInAPackage(subject)
                .should()
                .onlyDependOnClassesThat(JavaClass.Predicates.resideInAnyPackage(allowed)
                        .or(JavaClass.Predicates.resideOutsideOfPackages("mmneat..", "pacman..")));
    }
}
