package mmneat;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.fields;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import java.util.Set;

/** The packages and the directions between them: nothing depends on what stands above it. */
@AnalyzeClasses(
        packages = {"mmneat", "pacman"},
        importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {

    @ArchTest
    static final ArchRule random_dependsOnNothingOfOurs =
            packageUsesOnly("mmneat.random..", new String[] {"mmneat.random.."});

    @ArchTest
    static final ArchRule simulator_knowsOnlyTheGenerator =
            packageUsesOnly("pacman..", new String[] {"pacman..", "mmneat.random.."});

    @ArchTest
    static final ArchRule neat_knowsOnlyTheGenerator =
            packageUsesOnly("mmneat.neat..", new String[] {"mmneat.neat..", "mmneat.random.."});

    @ArchTest
    static final ArchRule nsga2_knowsOnlyTheGenerator =
            packageUsesOnly("mmneat.nsga2..", new String[] {"mmneat.nsga2..", "mmneat.random.."});

    @ArchTest
    static final ArchRule evolution_knowsNoGame = packageUsesOnly(
            "mmneat.evolution..",
            new String[] {"mmneat.evolution..", "mmneat.neat..", "mmneat.nsga2..", "mmneat.random.."});

    @ArchTest
    static final ArchRule task_knowsNoExperiment = packageUsesOnly(
            "mmneat.mspacman..",
            new String[] {"mmneat.mspacman..", "mmneat.evolution..", "mmneat.neat..", "mmneat.random..", "pacman.."});

    @ArchTest
    static final ArchRule experiment_knowsNoAnalysis = noClasses()
            .that()
            .resideInAPackage("mmneat.experiment..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("mmneat.analysis..", "mmneat.cli..")
            .allowEmptyShould(true);

    @ArchTest
    static final ArchRule analysis_knowsNoCommands = noClasses()
            .that()
            .resideInAPackage("mmneat.analysis..")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("mmneat.cli..")
            .allowEmptyShould(true);

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
    @ArchTest
    static final ArchRule staticFields_areFinal = fields().that()
            .areStatic()
            .and()
            .areNotFinal()
            .and(DescribedPredicate.not(DescribedPredicate.describe(
                    "are variables of the competition's interface",
                    field -> COMPETITION_VARIABLES.contains(field.getFullName()))))
            .should()
            .notBeStatic()
            .allowEmptyShould(true);

    @ArchTest
    static final ArchRule randomness_comesFromTheGeneratorThatIsPassedIn = noClasses()
            .should()
            .dependOnClassesThat()
            .belongToAnyOf(java.util.Random.class, java.util.concurrent.ThreadLocalRandom.class)
            .orShould()
            .callMethod(Math.class, "random");

    private static ArchRule packageUsesOnly(String subject, String[] allowed) {
        return classes()
                .that()
                .resideInAPackage(subject)
                .should()
                .onlyDependOnClassesThat(
                        com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage(allowed)
                                .or(com.tngtech.archunit.core.domain.JavaClass.Predicates.resideOutsideOfPackages(
                                        "mmneat..", "pacman..")))
                .allowEmptyShould(true);
    }
}
