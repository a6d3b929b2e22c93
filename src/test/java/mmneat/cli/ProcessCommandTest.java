package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ProcessCommandTest extends CommandTest {

    private static final String TASK = "task=mmneat.evolution.SchafferTask";

    @TempDir
    private Path base;

    @Test
    void startedRuns_areSummarised() throws IOException {
        assertThat(execute(TASK, "base=" + base, "saveTo=A", "log=X", "runs=2", "mu=4", "maxGens=3", "quiet=true"))
                .as(errors.toString())
                .isZero();

        assertThat(execute("process", TASK, "base=" + base, "saveTo=A", "log=X", "runs=5"))
                .as(errors.toString())
                .isZero();

        assertThat(out.toString()).contains("2 of 5 runs summarised");
        List<String> averages = Files.readAllLines(base.resolve("XAVG_parents_log.txt"));
        assertThat(averages).hasSize(4);
        assertThat(averages.get(3)).startsWith("3.0\t0.0\t");
        assertThat(Files.readString(base.resolve("XAll_parents_genHV.plot")))
                .contains("\"A1/X1_parents_genHV.txt\" u 1:2 t \"A1\"");
        assertThat(hypervolumes("A0/X0_parents_genHV.txt")).hasSize(3).allSatisfy(volume -> assertThat(volume)
                .isBetween(0.0, 9.0));
    }

    @Test
    void runsMadeWithOtherParameters_areRemarked() {
        assertThat(execute(TASK, "base=" + base, "saveTo=A", "log=X", "runs=2", "mu=4", "maxGens=1", "quiet=true"))
                .isZero();
        assertThat(execute("process", TASK, "base=" + base, "saveTo=A", "log=X", "runs=2", "mu=77", "mating=true"))
                .isZero();
        assertThat(errors.toString())
                .isEqualToIgnoringNewLines("mmneat: run(s) 0, 1 begun with mu=4 (now 77), mating=false (now true);"
                        + " the summaries are of the runs as they are");
        assertThat(execute("process", TASK, "base=" + base, "saveTo=A", "log=X", "runs=2", "mu=4"))
                .isZero();
        assertThat(errors.toString()).isEmpty();
    }

    @Test
    void emptyFolder_isReported() {
        assertThat(execute("process", TASK, "base=" + base, "saveTo=A", "log=X"))
                .isEqualTo(2);
        assertThat(errors.toString())
                .isEqualToIgnoringNewLines(
                        "mmneat: " + base.resolve("A0")
                                + ": no run has the logs of a complete generation (io=false writes none); give the parameters that the runs were made with");
    }

    @Test
    void damagedLog_isNamed() throws IOException {
        assertThat(execute(TASK, "base=" + base, "saveTo=A", "log=X", "mu=4", "maxGens=1", "quiet=true"))
                .isZero();
        Path log = Files.writeString(base.resolve("A0/X0_parents_log.txt"), "0\t1.0\tmuch\t\n");

        assertThat(execute("process", TASK, "base=" + base, "saveTo=A", "log=X"))
                .isEqualTo(2);

        assertThat(errors.toString()).startsWith("mmneat: " + log + ", line 1: not a row of numbers: 0\t1.0\tmuch");
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "0\t1\t2.0\t\n", "0\t1\tNaN\t\n1\t2\t1.0\t\n2\t3\t1.0\t\n3\t4\t1.0\t\n"})
    void damagedScores_areNamed_insteadOfBeingSummarised(String content) throws IOException {
        assertThat(execute(TASK, "base=" + base, "saveTo=A", "log=X", "mu=4", "maxGens=2", "quiet=true"))
                .isZero();
        Path scores = Files.writeString(base.resolve("A0/X0_parents_gen1.txt"), content);

        assertMistake(scores + ": is damaged: ", "process", TASK, "base=" + base, "saveTo=A", "log=X");
    }

    @Test
    void emptyLog_isNamed() throws IOException {
        assertThat(execute(TASK, "base=" + base, "saveTo=A", "log=X", "mu=4", "maxGens=2", "quiet=true"))
                .isZero();
        Path log = Files.writeString(base.resolve("A0/X0_parents_log.txt"), "");

        assertMistake(log + ": is damaged: it is empty", "process", TASK, "base=" + base, "saveTo=A", "log=X");
    }

    @Test
    void logsThatCannotBeRead_areNamedWithTheReason() throws IOException {
        assertThat(execute(TASK, "base=" + base, "saveTo=A", "log=X", "mu=4", "maxGens=2", "quiet=true"))
                .isZero();
        String[] command = {"process", TASK, "base=" + base, "saveTo=A", "log=X"};
        Path log = Files.write(base.resolve("A0/X0_parents_log.txt"), new byte[] {(byte) 0xFF, '\n'});
        assertMistake(log + ": cannot be read: it is not a text in UTF-8", command);
        Files.delete(log);
        assertMistake(log + ": cannot be read: there is no such file", command);
    }

    @Test
    void statusOfAFile_isAnError() throws IOException {
        Path file = base.resolve("notes.txt");
        assertMistake(file + ": there is no such folder", "status", file.toString());
        Files.writeString(file, "x");
        assertMistake(file + ": is a file; give the folder of a run or an experiment", "status", file.toString());
    }

    private List<Double> hypervolumes(String file) throws IOException {
        try (Stream<String> lines = Files.lines(base.resolve(file))) {
            return lines.map(line -> Double.valueOf(line.split("\t")[1])).toList();
        }
    }
}
