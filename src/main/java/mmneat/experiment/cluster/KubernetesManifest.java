package mmneat.experiment.cluster;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.dataformat.yaml.YAMLFactory;
import com.fasterxml.jackson.dataformat.yaml.YAMLGenerator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;

/**
 * The manifest of one experiment for Kubernetes: an Indexed Job (batch/v1) with one pod per run.
 *
 * <p>The jar and the results are on a persistent volume that every pod mounts at the job's working folder. A pod that
 * is evicted gets SIGTERM, saves, and is replaced without counting as a failure; exit code 2 (an error in the
 * parameters) fails the run immediately; other failures are tried again three times per run.
 */
public final class KubernetesManifest {

    private static final ObjectMapper YAML = new ObjectMapper(YAMLFactory.builder()
            .enable(YAMLGenerator.Feature.MINIMIZE_QUOTES)
            .enable(YAMLGenerator.Feature.ALWAYS_QUOTE_NUMBERS_AS_STRINGS)
            .disable(YAMLGenerator.Feature.SPLIT_LINES)
            .build());

    private KubernetesManifest() {}

    /**
     * Returns the manifest in YAML.
     *
     * @param image container image with a Java 17 or newer
     * @param claim name of the persistent volume claim that holds the working folder
     * @throws UserError if a name cannot be written in a manifest
     */
    public static String of(ExperimentJob job, JobResources resources, String image, String claim) {
        PlainText.require("image", image);
        PlainText.require("claim", claim);
        if (job.workingFolder().toString().contains(":")) {
            throw new UserError(job.workingFolder()
                    + ": Kubernetes cannot mount a volume at a path with a colon; start in another folder");
        }
        try {
            return "# " + job.name()
                    + ": one pod per run. Written by \"mmneat submit\"; submit it with\n#   kubectl apply -f "
                    + job.file("yaml") + "\n" + YAML.writeValueAsString(manifest(job, resources, image, claim));
        } catch (JsonProcessingException e) {
            throw new IllegalStateException("a map of texts and numbers cannot fail to be written", e);
        }
    }

    private static Map<String, Object> manifest(ExperimentJob job, JobResources resources, String image, String claim) {
        return fields(
                "apiVersion",
                "batch/v1",
                "kind",
                "Job",
                "metadata",
                fields("name", dnsName(job.name()), "labels", fields("app", "mmneat")),
                "spec",
                fields(
                        "completionMode", "Indexed",
                        "completions", job.runs().size(),
                        "parallelism", job.runs().size(),
                        "backoffLimitPerIndex", 3,
                        "maxFailedIndexes", job.runs().size(),
                        "podFailurePolicy", fields("rules", failureRules()),
                        "template", fields("spec", pod(job, resources, image, claim))));
    }

    private static List<Map<String, Object>> failureRules() {
        return List.of(
                fields(
                        "action",
                        "FailIndex",
                        "onExitCodes",
                        fields("containerName", "run", "operator", "In", "values", List.of(2))),
                // 3: the lock of the killed predecessor is not stale yet. 143: terminated by a signal, and saved.
                fields(
                        "action",
                        "Ignore",
                        "onExitCodes",
                        fields("containerName", "run", "operator", "In", "values", List.of(3, 143))),
                fields(
                        "action",
                        "Ignore",
                        "onPodConditions",
                        List.of(fields("type", "DisruptionTarget", "status", "True"))));
    }

    private static Map<String, Object> pod(ExperimentJob job, JobResources resources, String image, String claim) {
        String memory = resources.memoryMebibytes() + "Mi";
        Map<String, Object> amounts = fields("cpu", Integer.toString(resources.cpus()), "memory", memory);
        return fields(
                "restartPolicy",
                "Never",
                "terminationGracePeriodSeconds",
                30,
                "containers",
                List.of(fields(
                        "name", "run",
                        "image", image,
                        "workingDir", job.workingFolder().toString(),
                        "command", List.of("/bin/sh", "-c", shell(job, resources)),
                        "resources", fields("requests", amounts, "limits", fields("memory", memory)),
                        "volumeMounts",
                                List.of(fields(
                                        "name",
                                        "study",
                                        "mountPath",
                                        job.workingFolder().toString())))),
                "volumes",
                List.of(fields("name", "study", "persistentVolumeClaim", fields("claimName", claim))));
    }

    /**
     * Returns the shell command. Completion index i is the i-th unfinished run; "exec" makes Java receive the signals.
     */
    private static String shell(ExperimentJob job, JobResources resources) {
        String runs = job.runs().stream().map(String::valueOf).collect(Collectors.joining(" "));
        List<String> command = job.command(resources, KubernetesManifest::quote, "\"run=$run\"");
        return "set -- " + runs + "; shift \"$JOB_COMPLETION_INDEX\"; run=$1; exec " + String.join(" ", command);
    }

    /** Quotes a word for the shell. Kubernetes first replaces {@code $(NAME)}, and turns two dollar signs into one. */
    private static String quote(String word) {
        return ShellWord.quote(word).replace("$", "$$");
    }

    /** Kubernetes names are lower case letters, digits and dashes, at most 63. */
    private static String dnsName(String name) {
        String dashed = ("mmneat-" + name).toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "-");
        String shortened = dashed.substring(0, Math.min(50, dashed.length()));
        return shortened.replaceAll("-+$", "");
    }

    private static Map<String, Object> fields(Object... namesAndValues) {
        Map<String, Object> fields = new LinkedHashMap<>();
        for (int i = 0; i < namesAndValues.length; i += 2) {
            fields.put((String) namesAndValues[i], namesAndValues[i + 1]);
        }
        return fields;
    }
}
