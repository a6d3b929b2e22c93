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

    private static void evaluate(Path base, String version, int runs) throws IOException {
        for (int run = 0; run < runs; run++) {
            RunFixture.evaluation(base.resolve(version + "/1M" + run), 9000 + run, 1);
            RunFixture.evaluation(base.resolve(version + "/2M" + run), 15000 + 10 * run, 1, 2);
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
    void csvAndLatex_areTwoFiles_andNotThoseOfARun() throws IOException {
        twoMethods();
        String experiment = base.resolve("blended").toString();
        Path file = base.resolve("s.txt");
        assertMistake("this is also the file of csv=", "compare", experiment, "csv=" + file, "latex=" + file);
        assertThat(file).doesNotExist();
        Path parameters = base.resolve("blended/2M0/parameters.properties");
        String before = Files.readString(parameters);
        assertMistake("belongs to the run in", "compare", experiment, "csv=" + parameters);
        assertMistake("belongs to the run in", "compare", experiment, "latex=" + parameters);
        assertMistake("belongs to the run in", "report", experiment, "out=" + parameters);
        assertMistake("standard output is not possible here", "report", experiment, "out=-");
        assertThat(parameters).hasContent(before);
    }

    @Test
    void versionsOfTheTask_areComparedEachForItself() throws IOException {
        twoMethods();
        for (int run = 0; run < 8; run++) {
            RunFixture.run(base, "isolated", "1M", run, 100, 40000 + run);
            RunFixture.run(base, "isolated", "2M", run, 100, 42000 + run);
        }
        evaluate(base, "blended", 8);
        evaluate(base, "isolated", 8);
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
                        "games after evolution, blended task",
                        "df = 1",
                        "blended 1M - blended 2M",
                        "(2 comparisons)",
                        "games after evolution, isolated task",
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
        evaluate(base, "blended", 8);
        assertThat(execute("compare", base.resolve("blended").toString(), "paper=true"))
                .isZero();
        assertThat(out.toString())
                .contains("1M (paper)")
                .contains("2M (paper)")
                .contains("Ours against the paper's champions (2 comparisons)")
                .containsPattern("2M .*(no difference shown|ours lower) +maxGens=1, in the paper 200");
    }

    @Test
    void paper_withoutEvaluatedRuns_hasNoVerdict_andTheTableNamesMissingRuns() throws IOException {
        twoMethods();
        assertThat(execute("compare", base.resolve("blended").toString(), "paper=true"))
                .isZero();
        assertThat(out.toString())
                .contains("(0 comparisons)")
                .containsPattern("2M +- +- +- +- +- +none: no evaluated run")
                .contains("Run evaluate on the experiments before comparing them with the paper.")
                .doesNotContainPattern("no difference shown|ours lower|ours higher");
    }

    @Test
    void runsThatAreNotFinishedOrNotEvaluated_areListedAndLeftOut() throws IOException {
        twoMethods();
        evaluate(base, "blended", 7);
        Path unfinished = base.resolve("blended/2M0/parameters.properties");
        Files.writeString(unfinished, Files.readString(unfinished).replace("maxGens=1", "maxGens=200"));
        assertThat(execute("compare", base.resolve("blended").toString())).isZero();
        assertThat(out.toString())
                .contains("games after evolution")
                .containsPattern("1M +7 +9,003")
                .containsPattern("2M +6 +15,035")
                .contains("Left out of 1M: run 7 (not evaluated).")
                .contains("Left out of 2M: run 0 (not finished: generation 1 of 200), run 7 (not evaluated).");
    }

    @Test
    void methodWithoutAnyEvaluation_leadsToTheLastGeneration_ofAllRuns() throws IOException {
        twoMethods();
        RunFixture.evaluation(base.resolve("blended/2M0"), 15000, 1, 2);
        assertThat(execute("compare", base.resolve("blended").toString())).isZero();
        assertThat(out.toString())
                .contains("Best score in the last generation")
                .containsPattern("1M +8 ")
                .containsPattern("2M +8 ")
                .contains("because no champion of 1M was evaluated.")
                .contains("Run evaluate for 1,000 games each")
                .doesNotContain("Left out");
    }

    @Test
    void unfinishedMethod_doesNotPreventTheComparisonOfEvaluations() throws IOException {
        twoMethods();
        evaluate(base, "blended", 8);
        Path unfinished = RunFixture.run(base, "blended", "3M", 0, 100, 9000).resolve("parameters.properties");
        Files.writeString(unfinished, Files.readString(unfinished).replace("maxGens=1", "maxGens=200"));
        assertThat(execute("compare", base.resolve("blended").toString())).isZero();
        assertThat(out.toString())
                .contains("games after evolution")
                .contains("Left out of 3M: run 0 (not finished: generation 1 of 200).");
    }

    @Test
    void differentSettings_areNoted_withinAndBetweenMethods() throws IOException {
        twoMethods();
        assertThat(execute("compare", base.resolve("blended").toString())).isZero();
        assertThat(out.toString()).doesNotContain("different settings", "evaluated differently");
        Path odd = base.resolve("blended/2M3/parameters.properties");
        Files.writeString(odd, Files.readString(odd).replace("mu=100", "mu=10").replace("trials=10", "trials=2"));
        for (int run = 0; run < 8; run++) {
            Path parameters = base.resolve("blended/1M" + run + "/parameters.properties");
            Files.writeString(parameters, Files.readString(parameters) + "edibleTime=100\n");
        }
        assertThat(execute("compare", base.resolve("blended").toString())).isZero();
        assertThat(out.toString())
                .contains("Note: The runs of 2M have different settings: mu=100 (7 of them), mu=10 (run 3);"
                        + " trials=10 (7 of them), trials=2 (run 3).")
                .contains(
                        "Note: The methods have different settings: edibleTime=100 (1M), edibleTime=(not given) (2M).");
    }

    @Test
    void differentEvaluations_areNoted_withGamesAndSeeds() throws IOException {
        twoMethods();
        evaluate(base, "blended", 8);
        assertThat(execute("compare", base.resolve("blended").toString())).isZero();
        assertThat(out.toString()).doesNotContain("evaluated differently");
        Path odd = base.resolve("blended/2M3/evaluation-training.json");
        String whole = Files.readString(odd);
        Files.writeString(odd, whole.replace("\"seed\":0", "\"seed\":7"));
        assertThat(execute("compare", base.resolve("blended").toString())).isZero();
        assertThat(out.toString())
                .contains("Note: The champions were evaluated differently: 1000 games with seed 0 (15 of them), ")
                .contains("1000 games with seed 7 (2M run 3).");

        // A file of an earlier program does not name the seed.
        Files.writeString(odd, whole.replace("\"seed\":0,", ""));
        assertThat(execute("compare", base.resolve("blended").toString())).isZero();
        assertThat(out.toString()).doesNotContain("evaluated differently");
        Files.writeString(odd, whole.replace("\"seed\":0,", "").replace("1000,", "2000,"));
        assertThat(execute("compare", base.resolve("blended").toString())).isZero();
        assertThat(out.toString()).contains("2000 games with an unknown seed (2M run 3).");
    }

    @Test
    void runThatStopAtEnded_isFinished_andComparedWithOthers() throws IOException {
        twoMethods();
        Path stopped = base.resolve("blended/2M0/parameters.properties");
        String parameters = Files.readString(stopped).replace("maxGens=1", "maxGens=200");
        Files.writeString(stopped, parameters + "stopAt=1\n");
        assertThat(execute("compare", base.resolve("blended").toString())).isZero();
        assertThat(out.toString()).containsPattern("2M +8 ").doesNotContain("not finished");

        Files.writeString(stopped, parameters + "stopAt=1e9\n");
        assertThat(execute("compare", base.resolve("blended").toString())).isZero();
        assertThat(out.toString()).containsPattern("2M +7 ").contains("run 0 (not finished: generation 1 of 200)");
    }

    @Test
    void variant_isComparedWithOurs_butNotWithThePaper() throws IOException {
        twoMethods();
        evaluate(base, "blended", 8);
        for (int run = 0; run < 8; run++) {
            Path parameters = base.resolve("blended/2M" + run + "/parameters.properties");
            Files.writeString(parameters, Files.readString(parameters) + "mmdRate=0.2\n");
            Files.move(base.resolve("blended/2M" + run), base.resolve("blended/2Mplus-" + run));
        }
        assertThat(execute("compare", base.resolve("blended").toString(), "paper=true"))
                .isZero();
        assertThat(out.toString())
                .contains("1M - 2Mplus ")
                .contains("(1 comparison)")
                .doesNotContain("2Mplus (paper)");
    }

    @Test
    void evaluationsWanted_butMissing_isOneLine() throws IOException {
        twoMethods();
        assertThat(execute("compare", base.resolve("blended").toString(), "scores=evaluation"))
                .isEqualTo(2);
        assertThat(errors.toString().lines()).singleElement().asString().contains("run evaluate on it first");
    }

    @Test
    void filesThatCannotBeWritten_areRefusedAtOnce() throws IOException {
        twoMethods();
        String experiment = base.resolve("blended").toString();
        Path file = Files.createFile(base.resolve("file"));
        Path below = file.resolve("below");
        assertMistake("csv=" + base + ": this is a folder; name a file in it", "compare", experiment, "csv=" + base);
        assertMistake("latex=" + below + ": cannot be written", "compare", experiment, "latex=" + below);
        assertMistake("out=" + base + ": this is a folder; name a file in it", "report", experiment, "out=" + base);
        assertMistake("figures=" + below + ": " + file + " is a file", "report", experiment, "figures=" + below);
        assertThat(base).isDirectoryNotContaining("glob:**report*");
    }

    @Test
    void missingFolder_isToldFromOneWithoutFinishedRuns() {
        Path missing = base.resolve("missing");
        assertMistake(missing + ": there is no such folder", "compare", missing.toString());
        assertMistake(base + ": no finished run is found there", "compare", base.toString());
    }

    @Test
    void fileInsteadOfAFolder_isToldAsAFile() throws IOException {
        Path file = Files.createFile(base.resolve("file"));
        assertMistake(file + ": is a file; give the folder of an experiment", "compare", file.toString());
        assertMistake(file + ": is a file; give the folder of an experiment", "report", file.toString());
        Path below = file.resolve("runs");
        String mistake = "base=" + below + ": " + file + " is a file; name a folder";
        assertMistake(mistake, "task=blended", "base=" + below);
        assertMistake(mistake, "process", "task=blended", "base=" + below);
        assertMistake(mistake, "submit", "task=blended", "base=" + below, "engine=parallel");
    }

    @Test
    void oneExperiment_isDescribed() throws IOException {
        RunFixture.run(base, "blended", "1M", 0, 100, 9000);
        assertThat(execute("compare", base.resolve("blended/1M").toString())).isZero();
        assertThat(out.toString()).contains("9,000").contains("there is only one group");
    }

    @Test
    void emptiedFiles_areNamedWithARemedy() throws IOException {
        twoMethods();
        evaluate(base, "blended", 8);
        String experiment = base.resolve("blended").toString();
        Path run = base.resolve("blended/2M3");
        String report = "out=" + base.resolve("report.html");
        Path champion = Files.writeString(run.resolve("champion.json"), "");
        String empty = champion + ": is damaged (the file is empty); restore it or leave the run out";
        assertMistake(empty, "compare", experiment);
        assertMistake(empty, "report", experiment, report);
        for (String json : new String[] {"[]", "1", "{\"id\":null}"}) {
            Files.writeString(champion, json);
            assertMistake(champion + ": is damaged (the network has no id)", "compare", experiment);
        }
        Files.writeString(champion, "");
        Files.delete(run.resolve("evaluation-training.json"));
        assertMistake(champion + ": is empty; restore it", "evaluate", run.toString());
        assertMistake(champion + ": is empty; restore it", "report", experiment, report);
        Files.writeString(champion, "{\n");
        assertMistake(champion + ": ", "evaluate", run.toString());
        assertThat(errors.toString()).doesNotContain("Source", "`");
        Files.delete(champion);

        Path evaluation = base.resolve("blended/1M2/evaluation-training.json");
        String whole = Files.readString(evaluation);
        Files.writeString(evaluation, "{\n");
        assertMistake(
                evaluation + ": is damaged (the file ends too early); remove it and run evaluate again",
                "compare",
                experiment);
        Files.writeString(evaluation, whole);

        Path parameters = run.resolve("parameters.properties");
        String all = Files.readString(parameters);
        for (String name : new String[] {"runNumber", "maxGens", "startingModes"}) {
            Files.writeString(parameters, all.replaceFirst("(?m)^" + name + "=.*$", name + "=-3"));
            assertMistake(parameters + ": " + name + "=-3: must not be negative", "compare", experiment);
        }
        for (String text : new String[] {"", "# All parameters of this run\n", "mu=100\n"}) {
            Files.writeString(parameters, text);
            String problem = parameters + (text.startsWith("mu") ? ": does not name the task" : ": is empty");
            assertMistake(problem + "; restore it or leave the run out", "compare", experiment);
            assertMistake(problem + "; restore it or leave the run out", "report", experiment, report);
            assertMistake(problem + "; restore it or leave the run out", "evaluate", experiment);
        }
    }
}
