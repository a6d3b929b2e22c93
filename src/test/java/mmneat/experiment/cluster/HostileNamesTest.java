package mmneat.experiment.cluster;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.dataformat.yaml.YAMLMapper;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import mmneat.experiment.UserError;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Values with special characters of shells, schedulers or YAML: with the job files of every scheduler they reach the
 * program exactly as typed, or the job file is refused.
 */
@EnabledIf(value = "hasBash", disabledReason = "this machine has no bash")
class HostileNamesTest {

    private static final List<String> ARRIVE = List.of(
            "run=RUN",
            "RUN",
            "run=$run",
            "$run",
            "$(x)",
            "$(run)",
            "$ENV(HOME)",
            "$$",
            "$(DOLLAR)",
            "${HOME}",
            "$HOME",
            "`id`",
            "$(touch injected)",
            "; touch injected",
            "& touch injected",
            "| touch injected",
            "a b",
            "  two  blanks  ",
            "'",
            "''",
            "it's",
            "\"",
            "\"\"",
            "say \"no\"",
            "'\"'",
            "back\\slash",
            "ends\\",
            "\\",
            "\\'",
            "*",
            "?[a]",
            "~",
            "!!",
            "{}",
            "{1..3}",
            "#no comment",
            "a #comment",
            "a: b",
            "- item",
            "&anchor",
            "%A_%a",
            "100%",
            "%1$s%n",
            "@file",
            "<in >out",
            "=",
            "M\u00fchle \u732b \ud83d\ude00",
            "null",
            "(1 2)",
            "",
            "queue 100");

    private static final List<String> REFUSED = List.of(
            "a\nb",
            "a\r\nb",
            "a\rtouch injected",
            "a\tb",
            "nul\0",
            "esc\u001b[2J",
            "next\u0085line",
            "line\u2028separator",
            "half\ud83d",
            "x\nqueue 1000",
            "x\n#SBATCH --uid=0",
            "x\n  privileged: true");

    private static final int RUN = 7;

    @TempDir
    Path folder;

    private JobResources resources;

    static boolean hasBash() {
        return Files.isExecutable(Path.of("/bin/bash"));
    }

    static List<String> thatArrive() {
        return ARRIVE;
    }

    static List<String> thatAreRefused() {
        return REFUSED;
    }

    @BeforeEach
    void makeJava() throws IOException {
        Path java = Files.writeString(
                folder.resolve("java"),
                "#!/bin/bash\nprintf '%s\\0' \"$PWD\" \"$@\" > " + folder.resolve("arguments") + "\n");
        Files.setPosixFilePermissions(java, PosixFilePermissions.fromString("rwxr-xr-x"));
        resources = new JobResources(1, 1024, Duration.ofHours(1), java.toString());
    }

    @ParameterizedTest
    @MethodSource("thatArrive")
    void slurm(String value) throws Exception {
        if (value.contains("\\")) {
            assertThatThrownBy(() -> SlurmScript.of(job(value), resources, Map.of()))
                    .isInstanceOf(UserError.class)
                    .hasMessageContaining("backslash");
        } else {
            List<String> header = slurmOptions(SlurmScript.of(job(value), resources, Map.of("constraint", value)));
            assertThat(header)
                    .contains(
                            "--job-name=n" + value,
                            "--chdir=" + folder,
                            "--constraint=" + value,
                            "--output=" + place(value).replace("%", "%%") + "-%A_%a.log")
                    .hasSize(12);
        }
        String script = SlurmScript.of(jobOfWords(value), resources, Map.of());
        bash(script, Map.of("SLURM_ARRAY_TASK_ID", "" + RUN, "SLURM_ARRAY_JOB_ID", "1"));
        assertThat(arguments()).containsSequence("run=" + RUN, "saveTo=" + value, "task=x", "threads=1");
    }

    @ParameterizedTest
    @MethodSource("thatArrive")
    void commandList(String value) throws Exception {
        bash(CommandList.of(job(value), resources).get(0), Map.of());
        assertThat(arguments()).containsSequence("run=" + RUN, "saveTo=" + value, "task=x", "threads=1");
    }

    @ParameterizedTest
    @MethodSource("thatArrive")
    void kubernetes(String value) throws Exception {
        String manifest = KubernetesManifest.of(job(value), resources, "image" + value, value);
        JsonNode pod = new YAMLMapper().readTree(manifest).at("/spec/template/spec");
        assertThat(pod.at("/containers/0/image").asText()).isEqualTo("image" + value);
        assertThat(pod.at("/volumes/0/persistentVolumeClaim/claimName").asText())
                .isEqualTo(value);
        List<String> command = new ArrayList<>();
        pod.at("/containers/0/command").forEach(word -> command.add(kubernetesExpansion(word.asText())));

        start(command, Map.of("JOB_COMPLETION_INDEX", "0"));

        assertThat(arguments()).containsSequence("run=" + RUN, "saveTo=" + value, "task=x", "threads=1");
    }

    @ParameterizedTest
    @MethodSource("thatArrive")
    void condor(String value) {
        Map<String, String> lines = condorLines(CondorSubmitFile.of(jobOfWords(value), resources));
        assertThat(condorArguments(lines.get("arguments")))
                .containsSequence("run=" + RUN, "saveTo=" + value, "task=x", "threads=1");
        try {
            Map<String, String> named = condorLines(CondorSubmitFile.of(job(value), resources));
            assertThat(named)
                    .containsEntry("output", place(value) + "-" + RUN + ".out")
                    .containsEntry("initialdir", folder.toString());
        } catch (UserError e) {
            assertThat(e.getMessage()).contains("HTCondor");
        }
    }

    @ParameterizedTest
    @MethodSource("thatAreRefused")
    void controlCharacters_areRefusedInEveryPart(String value) {
        assertThatThrownBy(() -> jobOfWords(value)).isInstanceOf(UserError.class);
        assertThatThrownBy(() -> new ExperimentJob(value, folder, folder, folder, List.of(), List.of(1)))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("control characters")
                .satisfies(e -> assertThat(e.getMessage().lines()).hasSize(1));
        ExperimentJob job = jobOfWords("x");
        assertThatThrownBy(() -> SlurmScript.of(job, resources, Map.of("partition", value)))
                .isInstanceOf(UserError.class);
        assertThatThrownBy(() -> KubernetesManifest.of(job, resources, value, "claim"))
                .isInstanceOf(UserError.class);
        assertThatThrownBy(() -> new JobResources(1, 1024, Duration.ofHours(1), value))
                .isInstanceOf(UserError.class);
    }

    /** Returns a job with the value in a word, in the name of the experiment and in its folder. */
    private ExperimentJob job(String value) {
        return new ExperimentJob(
                "n" + value,
                Path.of("results", value),
                folder,
                folder.resolve("mmneat.jar"),
                List.of("saveTo=" + value, "task=x"),
                List.of(RUN));
    }

    private static String place(String value) {
        return Path.of("results", value, "n" + value).toString();
    }

    private ExperimentJob jobOfWords(String value) {
        return new ExperimentJob(
                "name",
                Path.of("results"),
                folder,
                folder.resolve("mmneat.jar"),
                List.of("saveTo=" + value, "task=x"),
                List.of(RUN));
    }

    private void bash(String script, Map<String, String> environment) throws Exception {
        start(
                List.of(
                        "/bin/bash",
                        Files.writeString(folder.resolve("script"), script).toString()),
                environment);
    }

    private void start(List<String> command, Map<String, String> environment) throws Exception {
        ProcessBuilder builder = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .redirectOutput(folder.resolve("output").toFile());
        builder.environment().putAll(environment);
        assertThat(builder.start().waitFor()).isZero();
        assertThat(folder.resolve("injected")).doesNotExist();
    }

    private List<String> arguments() throws IOException {
        String written = Files.readString(folder.resolve("arguments"), StandardCharsets.UTF_8);
        return Arrays.asList(written.split("\0", -1));
    }

    /**
     * Reads the options in the lines of a script by Slurm's rules: both kinds of quotes, and a backslash before any
     * character.
     */
    private static List<String> slurmOptions(String script) {
        return script.lines()
                .filter(line -> line.startsWith("#SBATCH "))
                .map(line -> slurmWord(line.substring("#SBATCH ".length())))
                .toList();
    }

    private static String slurmWord(String line) {
        StringBuilder word = new StringBuilder();
        char quote = 0;
        for (int i = 0; i < line.length(); i++) {
            char c = line.charAt(i);
            if (c == '\\') {
                i++;
                word.append(line.charAt(i));
            } else if (c == quote) {
                quote = 0;
            } else if (quote == 0 && (c == '\'' || c == '"')) {
                quote = c;
            } else {
                assertThat(quote != 0 || !Character.isWhitespace(c) && c != '#').isTrue();
                word.append(c);
            }
        }
        assertThat(quote).isEqualTo((char) 0);
        return word.toString();
    }

    /**
     * Applies Kubernetes' rule: two dollar signs become one, {@code $(NAME)} is a variable, everything else is literal.
     */
    private static String kubernetesExpansion(String text) {
        Matcher sign = Pattern.compile("\\$\\$|\\$\\([^)]*\\)").matcher(text);
        return sign.replaceAll(found -> found.group().equals("$$") ? "\\$" : "EXPANDED");
    }

    /**
     * Reads the values of a submit file by HTCondor's rules: lines continue after a backslash, values are trimmed and
     * expanded.
     */
    private static Map<String, String> condorLines(String file) {
        Map<String, String> values = new java.util.HashMap<>();
        List<String> lines = file.replace("\\\n", "").lines().toList();
        assertThat(lines.stream().filter(line -> line.matches("\\s*queue.*"))).hasSize(1);
        lines.stream().filter(line -> line.matches("[a-z_]+ +=.*")).forEach(line -> {
            int sign = line.indexOf('=');
            values.put(
                    line.substring(0, sign).strip(),
                    condorExpansion(line.substring(sign + 1).strip()));
        });
        assertThat(values).hasSize(16);
        return values;
    }

    private static String condorExpansion(String text) {
        Matcher macro = Pattern.compile("\\$[A-Z]*\\(([^)]*)\\)").matcher(text);
        String expanded = macro.replaceAll(found -> switch (found.group()) {
            case "$(run)" -> "" + RUN;
            case "$(DOLLAR)" -> "\\$";
            default -> "EXPANDED";
        });
        assertThat(expanded).doesNotContain("$$(", "$$[");
        return expanded;
    }

    private static List<String> condorArguments(String line) {
        assertThat(line).startsWith("\"").endsWith("\"");
        String inner = line.substring(1, line.length() - 1);
        assertThat(inner.replace("\"\"", "")).doesNotContain("\"");
        Matcher word =
                Pattern.compile("\\G((?:[^\\s']|'(?:[^']|'')*')+|$)(?:\\s+|$)").matcher(inner.replace("\"\"", "\""));
        return Stream.generate(() -> word.find() && !word.group(1).isEmpty() ? word.group(1) : null)
                .takeWhile(found -> found != null)
                .map(HostileNamesTest::withoutSingleQuotes)
                .toList();
    }

    private static String withoutSingleQuotes(String word) {
        Matcher part = Pattern.compile("'((?:[^']|'')*)'").matcher(word);
        return part.replaceAll(found -> Matcher.quoteReplacement(found.group(1).replace("''", "'")));
    }
}
