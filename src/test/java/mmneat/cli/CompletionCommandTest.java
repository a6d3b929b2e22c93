package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The completion script, run by bash. */
class CompletionCommandTest extends CommandTest {

    @TempDir
    private Path folder;

    private List<String> complete(String line, String wordBreaks) throws IOException, InterruptedException {
        assumeThat(new File("/bin/bash")).exists();
        assertThat(execute("completion")).isZero();
        Path script = Files.writeString(folder.resolve("completion.sh"), out.toString());
        Process bash = new ProcessBuilder(
                        "/bin/bash",
                        "-c",
                        "source \"$1\"; COMP_LINE=$2 COMP_POINT=${#2} COMP_WORDBREAKS=$3; _mmneat;"
                                + " printf '%s\\n' \"${COMPREPLY[@]}\"",
                        "bash",
                        script.toString(),
                        line,
                        wordBreaks)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .start();
        String completions = new String(bash.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(bash.waitFor()).isZero();
        return completions.lines().toList();
    }

    @Test
    void commands_optionsAndValues_areCompleted() throws IOException, InterruptedException {
        assertThat(complete("mmneat pl", "=")).containsExactly("play");
        assertThat(complete("mmneat task=bl", "=")).containsExactly("blended");
        assertThat(complete("mmneat ", "=")).contains("play", "completion", "task=", "--help");
        assertThat(complete("mmneat play ga", "=")).containsExactly("games=");
        assertThat(complete("mmneat play rules=bl", "=")).containsExactly("blended");
        assertThat(complete("mmneat play rules=bl", " ")).containsExactly("rules=blended");
        assertThat(complete("mmneat play view=", "=")).containsExactly("true", "false");
        assertThat(complete("mmneat submit task=blended engine=s", "=")).containsExactly("slurm");
        assertThat(complete("mmneat submit crossoverR", "=")).containsExactly("crossoverRate=");
    }

    @Test
    void filesAreCompleted_whereNothingElseFits() throws IOException, InterruptedException {
        Files.createDirectories(folder.resolve("results"));
        assertThat(complete("mmneat compare res", "=")).containsExactly("results");
        assertThat(complete("mmneat watch out=res", "=")).containsExactly("results");
        assertThat(complete("mmneat watch out=res", " ")).containsExactly("out=results");
    }
}
