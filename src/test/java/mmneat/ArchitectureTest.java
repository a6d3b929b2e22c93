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
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import mmneat.random.ResumableRandom;
import org.jspecify.annotations.NullMarked;
import org.junit.jupiter.api.Test;

/**
 * The rules of the architecture: a package depends only on packages below it.
 *
 * <p>The rules are plain JUnit tests, because the build does not run rules that are fields for ArchUnit's engine.
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

    /**
     * The packages of this program that each package uses, from the lowest up. A package that is missing here is an
     * error.
     */
    private static final Map<String, List<String>> USES = Map.ofEntries(
            uses("mmneat.random"),
            uses("pacman.maze"),
            uses("pacman..", "pacman..", "mmneat.random"),
            uses("mmneat.neat"),
            uses("mmneat.neat.variation", "mmneat.neat", "mmneat.random"),
            uses("mmneat.neat.network", "mmneat.neat", "mmneat.random"),
            uses("mmneat.neat.io", "mmneat.neat"),
            uses("mmneat.nsga2", "mmneat.random"),
            uses("mmneat.evolution", "mmneat.neat", "mmneat.neat.variation", "mmneat.nsga2", "mmneat.random"),
            uses("mmneat.mspacman.sensors", "pacman.."),
            uses("mmneat.mspacman.sensors.suite", "mmneat.mspacman.sensors", "mmneat.neat.network", "pacman.."),
            uses("mmneat.mspacman.modules", "mmneat.mspacman.sensors", "pacman.."),
            uses("mmneat.mspacman.objectives", "mmneat.evolution", "pacman.."),
            uses(
                    "mmneat.mspacman",
                    "mmneat.mspacman..",
                    "mmneat.evolution",
                    "mmneat.neat..",
                    "mmneat.random",
                    "pacman.."),
            uses("mmneat.experiment", "mmneat.neat"),
            uses(
                    "mmneat.experiment.parameters",
                    "mmneat.experiment",
                    "mmneat.mspacman..",
                    "mmneat.evolution",
                    "mmneat.neat..",
                    "mmneat.nsga2",
                    "pacman.."),
            uses(
                    "mmneat.experiment.store",
                    "mmneat.experiment",
                    "mmneat.experiment.parameters",
                    "mmneat.mspacman",
                    "mmneat.evolution",
                    "mmneat.neat..",
                    "pacman.game"),
            uses(
                    "mmneat.experiment.original",
                    "mmneat.experiment",
                    "mmneat.experiment.store",
                    "mmneat.evolution",
                    "mmneat.neat..",
                    "mmneat.nsga2"),
            uses(
                    "mmneat.experiment.run",
                    "mmneat.experiment",
                    "mmneat.experiment.parameters",
                    "mmneat.experiment.store",
                    "mmneat.experiment.original",
                    "mmneat.mspacman",
                    "mmneat.evolution",
                    "mmneat.neat.."),
            uses("mmneat.experiment.cluster", "mmneat.experiment"),
            uses(
                    "mmneat.analysis..",
                    "mmneat.analysis..",
                    "mmneat.experiment..",
                    "mmneat.mspacman..",
                    "mmneat.evolution",
                    "mmneat.neat..",
                    "mmneat.random",
                    "pacman.."),
            uses(
                    "mmneat.contest..",
                    "mmneat.contest..",
                    "mmneat.experiment",
                    "mmneat.neat",
                    "mmneat.random",
                    "pacman.."),
            uses(
                    "mmneat.cli.options",
                    "mmneat.analysis..",
                    "mmneat.experiment",
                    "mmneat.mspacman",
                    "pacman.game",
                    "pacman.maze"),
            uses("mmneat.cli.output", "mmneat.analysis..", "mmneat.experiment..", "mmneat.evolution"));

    private static Map.Entry<String, List<String>> uses(String subject, String... others) {
        return Map.entry(subject, List.of(others));
    }

    @Test
    void packages_useOnlyThoseBelow() {
        USES.forEach((subject, others) -> {
            List<String> allowed = new ArrayList<>(others);
            allowed.add(subject);
            packageUsesOnly(subject, allowed.toArray(String[]::new)).check(OURS);
        });
    }

    /** The commands are the highest package. */
    @Test
    void packages_dependOnlyOnPackagesBelow() {
        String[] known =
                Stream.concat(USES.keySet().stream(), Stream.of("mmneat.cli")).toArray(String[]::new);
        assertThat(OURS.stream().filter(type -> !JavaClass.Predicates.resideInAnyPackage(known)
                        .test(type)))
                .isEmpty();
    }

    /** The classes of the competition that refer back to {@code pacman.game}, as their published signatures require. */
    private static final Set<String> COMPETITION_SHELLS = Set.of(
            "pacman.game.internal.AStar",
            "pacman.game.internal.Ghost",
            "pacman.game.internal.Node",
            "pacman.game.internal.PacMan",
            "pacman.game.internal.PathsCache");

    /** Only competition entries use these classes; our own code uses {@code pacman.maze}. */
    @Test
    void competitionShells_areUsedByEntriesOnly() {
        noClasses()
                .that()
                .resideInAPackage("mmneat..")
                .should()
                .dependOnClassesThat()
                .resideInAPackage("pacman.game.internal")
                .check(OURS);
    }

    @Test
    void packages_areFreeOfCycles() {
        slices().matching("(mmneat..)").should().beFreeOfCycles().check(OURS);
        slices().matching("(pacman..)")
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
    void publicTypes_haveUniqueNames() {
        Map<String, List<JavaClass>> byName = OURS.stream()
                .filter(type -> type.isTopLevelClass()
                        && type.getModifiers().contains(JavaModifier.PUBLIC)
                        && !type.getSimpleName().equals("package-info"))
                .collect(Collectors.groupingBy(JavaClass::getSimpleName));
        assertThat(byName.values()).allSatisfy(types -> assertThat(types).hasSize(1));
    }

    /**
     * The public variables of the competition's interface, which entries may assign. Of our own code, only the view
     * depends on them, for the debug drawing.
     */
    private static final Set<String> COMPETITION_VARIABLES = Set.of(
            "pacman.game.Constants.pathImages",
            "pacman.game.Constants.mazeNames",
            "pacman.game.Game.caches",
            "pacman.game.GameView.debugPointers",
            "pacman.game.GameView.debugLines");

    /** Two games or two experiments in one JVM share no mutable state. */
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

    /** NullAway checks only packages that are marked. */
    @Test
    void packages_areNullMarked() {
        Set<String> marked = OURS.stream()
                .filter(type -> type.getSimpleName().equals("package-info") && type.isAnnotatedWith(NullMarked.class))
                .map(JavaClass::getPackageName)
                .collect(Collectors.toSet());
        assertThat(OURS.stream().map(JavaClass::getPackageName).distinct()).isSubsetOf(marked);
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
