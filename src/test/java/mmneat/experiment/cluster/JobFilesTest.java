package mmneat.experiment.cluster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.dataformat.yaml.YAMLMapper;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class JobFilesTest {

    private static final JobResources RESOURCES = new JobResources(1, 1024, Duration.ofHours(36), "java");

    private static ExperimentJob job(List<Integer> runs) {
        return new ExperimentJob(
                "blended-2M",
                Path.of("results/blended"),
                Path.of("/home/ann/my study"),
                Path.of("/home/ann/my study/mmneat.jar"),
                List.of("task=blended", "method=2M", "maxGens=50"),
                runs);
    }

    @Test
    void slurmScript_requestsResources_andNamesTheUnfinishedRuns() {
        String script = SlurmScript.of(job(List.of(0, 1, 2, 5, 7, 8)), RESOURCES, Map.of("partition", "long"));

        assertThat(script.lines())
                .startsWith("#!/bin/bash")
                .contains(
                        "#SBATCH --job-name=blended-2M",
                        "#SBATCH --array=0-2,5,7-8",
                        "#SBATCH --cpus-per-task=1",
                        "#SBATCH --mem=1024M",
                        "#SBATCH --time=36:00:00",
                        "#SBATCH --partition=long",
                        "#SBATCH --requeue",
                        "#SBATCH --chdir='/home/ann/my study'",
                        "#SBATCH --output=results/blended/blended-2M-%A_%a.log",
                        "java -XX:+UseSerialGC -XX:ActiveProcessorCount=1 -Xmx768m -jar"
                                + " '/home/ann/my study/mmneat.jar' \"run=$run\" task=blended method=2M maxGens=50"
                                + " threads=1 &");
    }

    @Test
    void submitCommands_splitAtTheArrayLimit_withTheOffsetInTheEnvironment() {
        List<Integer> runs = IntStream.of(0, 998, 999, 1000, 1001, 2500).boxed().toList();

        assertThat(SlurmScript.submitCommands(job(runs), 1000))
                .containsExactly(
                        List.of("sbatch", "--parsable", "--array=0,998-999", "results/blended/blended-2M.slurm"),
                        List.of(
                                "sbatch",
                                "--parsable",
                                "--array=0-1",
                                "--export=ALL,MMNEAT_FIRST_RUN=1000",
                                "results/blended/blended-2M.slurm"),
                        List.of(
                                "sbatch",
                                "--parsable",
                                "--array=500",
                                "--export=ALL,MMNEAT_FIRST_RUN=2000",
                                "results/blended/blended-2M.slurm"));
    }

    @Test
    void commandList_hasOneCompleteCommandPerRun() {
        assertThat(CommandList.of(job(List.of(3, 4)), RESOURCES))
                .hasSize(2)
                .first()
                .isEqualTo("cd '/home/ann/my study' && java -XX:+UseSerialGC -XX:ActiveProcessorCount=1 -Xmx768m"
                        + " -jar '/home/ann/my study/mmneat.jar' run=3 task=blended method=2M maxGens=50 threads=1");
    }

    @Test
    void condorFile_quotesWordsAsItsSyntaxDemands_andQueuesEveryRun() {
        assertThat(CondorSubmitFile.of(job(List.of(0, 4)), RESOURCES).lines())
                .contains(
                        "executable              = java",
                        "arguments               = \"-XX:+UseSerialGC -XX:ActiveProcessorCount=1 -Xmx768m -jar"
                                + " '/home/ann/my study/mmneat.jar' run=$(run) task=blended method=2M maxGens=50"
                                + " threads=1\"",
                        "kill_sig                = SIGTERM",
                        "queue run in (0 4)");
    }

    @Test
    void kubernetesManifest_isAnIndexedJob_withOnePodPerRun() throws Exception {
        String text = KubernetesManifest.of(
                job(List.of(2, 9)), RESOURCES, "docker.io/library/eclipse-temurin:17-jre", "study");
        JsonNode manifest = new YAMLMapper().readTree(text);

        assertThat(manifest.at("/kind").asText()).isEqualTo("Job");
        assertThat(manifest.at("/metadata/name").asText()).isEqualTo("mmneat-blended-2m");
        assertThat(manifest.at("/spec/completionMode").asText()).isEqualTo("Indexed");
        assertThat(manifest.at("/spec/completions").asInt()).isEqualTo(2);
        JsonNode pod = manifest.at("/spec/template/spec");
        assertThat(pod.at("/restartPolicy").asText()).isEqualTo("Never");
        assertThat(pod.at("/containers/0/command/2").asText())
                .startsWith("set -- 2 9; shift \"$JOB_COMPLETION_INDEX\"; run=$1; exec java ")
                .contains(" \"run=$run\" task=blended method=2M ");
        assertThat(pod.at("/containers/0/resources/requests/cpu").isTextual()).isTrue();
        assertThat(pod.at("/containers/0/resources/limits/memory").asText()).isEqualTo("1024Mi");
    }

    @ParameterizedTest
    @CsvSource({"1G, 1024", "800M, 800", "2GiB, 2048", "1024mb, 1024"})
    void memory_isReadInTheUsualForms(String text, int mebibytes) {
        assertThat(JobResources.parseMemory(text)).isEqualTo(mebibytes);
    }

    @ParameterizedTest
    @CsvSource({"12:00:00, PT12H", "0:30, PT30M", "2-06:00:00, PT54H"})
    void time_isReadAsSchedulersWriteIt(String text, Duration time) {
        assertThat(JobResources.parseTime(text)).isEqualTo(time);
    }

    @ParameterizedTest
    @ValueSource(strings = {"12", "noon", "12:0:0", ""})
    void invalidTime_isRefusedWithAnExample(String text) {
        assertThatThrownBy(() -> JobResources.parseTime(text))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("time=12:00:00");
    }

    @ParameterizedTest
    @ValueSource(strings = {"1", "much", "1T", "-1G"})
    void invalidMemory_isRefusedWithAnExample(String text) {
        assertThatThrownBy(() -> JobResources.parseMemory(text))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("memory=1G");
    }

    @Test
    void memoryTooSmallForARun_isRefused() {
        assertThatThrownBy(() -> new JobResources(1, 100, Duration.ofHours(1), "java"))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("256M");
    }
}
