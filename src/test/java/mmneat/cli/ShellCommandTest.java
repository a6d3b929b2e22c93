package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;

class ShellCommandTest {

    @Test
    void calledWithTheJar_theSameJarIsNamed() {
        assertThat(ShellCommand.line("", "target/mmneat.jar", List.of("status", "results")))
                .isEqualTo("java -jar target/mmneat.jar status results");
    }

    @Test
    void calledByAScript_theScriptIsNamed() {
        assertThat(ShellCommand.line("scripts/mmneat", "/home/ann/target/mmneat.jar", List.of("status")))
                .isEqualTo("scripts/mmneat status");
    }

    @Test
    void calledWithMoreOnTheClassPath_allOfItIsNamed() {
        String classPath = "mmneat.jar" + File.pathSeparator + "my.jar";
        assertThat(ShellCommand.line("", classPath, List.of("task=blended", "ownSensors=my.NearExit")))
                .isEqualTo("java -cp " + classPath + " mmneat.cli.Main task=blended ownSensors=my.NearExit");
    }

    @Test
    void calledWithTheClassPathOfABuildTool_aWordStandsForIt() {
        String classPath = String.join(File.pathSeparator, Collections.nCopies(40, "repository/library.jar"));
        assertThat(ShellCommand.line("", classPath, List.of("status")))
                .isEqualTo("java -cp CLASSPATH mmneat.cli.Main status");
    }

    @Test
    void blanks_areQuoted() {
        assertThat(ShellCommand.line("", "my tools/mmneat.jar", List.of("watch", "my results/2M0")))
                .isEqualTo("java -jar 'my tools/mmneat.jar' watch 'my results/2M0'");
    }
}
