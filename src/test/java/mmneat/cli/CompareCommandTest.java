package mmneat.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import mmneat.analysis.results.RunFixture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CompareCommandTest extends CommandTest {

    @TempDir
    Path base;

    private void twoMethods() throws IOException {
        for (int run = 0; run < 8; run++) {
            RunFixture.run(base, "blended", "1M", run, 100, 9000 + run);
            RunFixture.run(base, "blended", "2M", run, 100, 15000 + 10 * run);
        }
    }

    @Test
    void twoMethods_areCompared_andWrittenAsCsvAndLatex() throws IOException {
        twoMethods();
        Path csv = base.resolve("new/pairs.csv");
        Path latex = base.resolve("pairs.tex");
        assertThat(execute("compare", base.resolve("blended").toString(), "csv=" + csv, "latex=" + latex))
                .isZero();
        assertThat(out.toString())
                .contains("last generation")
                .contains("Kruskal-Wallis: H = 11.294, df = 1, p = 0.00078")
                .containsPattern("1M - 2M +0\\.0 +0\\.00016 +0\\.00016 +exact +0\\.000 +large +\\*")
                .contains("Run evaluate for 1,000 games each");
        assertThat(Files.readString(csv)).contains("Mann-Whitney,1M,2M,0.0,1.554");
        assertThat(Files.readString(latex)).contains("\\begin{tabular}").contains("1M - 2M & 0.0 & ");
    }

    @Test
    void versionsOfTheTask_areComparedEachForItself() throws IOException {
        twoMethods();
        for (int run = 0; run < 8; run++) {
            RunFixture.run(base, "isolated", "1M", run, 100, 40000 + run);
            RunFixture.run(base, "isolated", "2M", run, 100, 42000 + run);
        }
        Path csv = base.resolve("pairs.csv");
        assertThat(execute(
                        "compare",
                        base.resolve("blended").toString(),
                        base.resolve("isolated").toString(),
                        "paper=true",
                        "csv=" + csv))
                .isZero();
        assertThat(out.toString())
                .containsSubsequence(
                        "evolution, blended task",
                        "df = 1",
                        "blended 1M - blended 2M",
                        "(2 comparisons)",
                        "evolution, isolated task",
                        "df = 1",
                        "isolated 1M - isolated 2M",
                        "(2 comparisons)")
                .doesNotContain("blended 1M - isolated");
        assertThat(Files.readString(csv))
                .contains("Kruskal-Wallis,\"blended 1M; blended 2M\"", "Kruskal-Wallis,\"isolated 1M; isolated 2M\"");
    }

    @Test
    void paper_standsBesideOurs_withAVerdict() throws IOException {
        twoMethods();
        assertThat(execute("compare", base.resolve("blended").toString(), "paper=true"))
                .isZero();
        assertThat(out.toString())
                .contains("1M (paper)")
                .contains("2M (paper)")
                .contains("Ours against the paper's champions (2 comparisons)")
                .containsPattern("2M .*(no difference shown|ours lower)");
    }

    @Test
    void evaluationsWanted_butMissing_isOneLine() throws IOException {
        twoMethods();
        assertThat(execute("compare", base.resolve("blended").toString(), "scores=evaluation"))
                .isEqualTo(2);
        assertThat(errors.toString().lines()).singleElement().asString().contains("run evaluate on it first");
    }

    @Test
    void oneExperiment_isDescribed() throws IOException {
        RunFixture.run(base, "blended", "1M", 0, 100, 9000);
        assertThat(execute("compare", base.resolve("blended/1M").toString())).isZero();
        assertThat(out.toString()).contains("9,000").contains("One group only");
    }
}
