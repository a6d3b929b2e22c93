package mmneat.generation;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Measures whole generations of real runs: evaluation, reproduction, selection and commit, resumed from checkpoints.
 *
 * <p>Each checkpoint is continued in a new process. Its first generation is the warm-up. The following generations are
 * measured by processor time, which other work on the machine affects less than elapsed time. With a second jar, both
 * jars alternate, and must reach the same scores in the same number of steps.
 */
final class GenerationBenchmark {

    /** Columns of {@code generations.csv} that are compared. */
    private static final int RESULTS = 8;

    private static final String NEW = "this version";

    private final Map<String, String> options = new HashMap<>(Map.of("turns", "3", "generations", "2", "only", ""));
    private final Map<String, String> classPaths = new LinkedHashMap<>();

    private GenerationBenchmark(String[] arguments) {
        for (String argument : arguments) {
            String[] parts = argument.split("=", 2);
            if (parts.length < 2
                    || !List.of("turns", "generations", "only", "against").contains(parts[0])) {
                throw new IllegalArgumentException(
                        argument + ": give turns=N, generations=N, only=PATTERN or against=JAR");
            }
            options.put(parts[0], parts[1]);
        }
        String classPath = System.getProperty("java.class.path");
        classPaths.put(NEW, classPath);
        String against = options.get("against");
        if (against != null) {
            if (!Files.isRegularFile(Path.of(against))) {
                throw new IllegalArgumentException("against=" + against + ": there is no such file");
            }
            classPaths.put(against, against + File.pathSeparator + ownClasses());
        }
    }

    private static Path ownClasses() {
        try {
            return Path.of(GenerationBenchmark.class
                    .getProtectionDomain()
                    .getCodeSource()
                    .getLocation()
                    .toURI());
        } catch (URISyntaxException e) {
            throw new IllegalStateException(e);
        }
    }

    /**
     * Measures all checkpoints.
     *
     * @param arguments the folder of the checkpoints, and options as {@code name=value}
     */
    public static void main(String[] arguments) throws Exception {
        try {
            new GenerationBenchmark(Arrays.copyOfRange(arguments, 1, arguments.length)).measure(Path.of(arguments[0]));
        } catch (IllegalArgumentException e) {
            System.err.println("benchmark: " + e.getMessage());
            System.exit(2);
        }
    }

    private void measure(Path checkpoints) throws IOException, InterruptedException {
        List<Path> files;
        try (Stream<Path> all = Files.list(checkpoints)) {
            Pattern only = Pattern.compile(options.get("only"));
            files = all.filter(file -> file.toString().endsWith(".json.gz"))
                    .filter(file -> only.matcher(file.getFileName().toString()).find())
                    .sorted()
                    .toList();
        }
        System.out.println("Thousand steps per second of processor time: lower quartile, median, upper quartile");
        for (Path file : files) {
            measureOne(file);
        }
    }

    private void measureOne(Path checkpoint) throws IOException, InterruptedException {
        Map<String, List<Double>> rates = new HashMap<>();
        List<Double> ratios = new ArrayList<>();
        String results = null;
        for (int turn = 0; turn < Integer.parseInt(options.get("turns")); turn++) {
            Map<String, Double> ofTurn = new HashMap<>();
            for (Map.Entry<String, String> version : classPaths.entrySet()) {
                Path base = Files.createTempDirectory("mmneat-generation");
                try {
                    ofTurn.put(version.getKey(), run(checkpoint, base, version.getValue()));
                    String reached = results(base.resolve(runName(checkpoint)));
                    if (results != null && !results.equals(reached)) {
                        throw new IllegalStateException(checkpoint + ": " + version.getKey()
                                + " reached other results:\n" + reached + "\ninstead of\n" + results);
                    }
                    results = reached;
                } finally {
                    delete(base);
                }
            }
            ofTurn.forEach((version, rate) ->
                    rates.computeIfAbsent(version, missing -> new ArrayList<>()).add(rate));
            if (ofTurn.size() > 1) {
                ratios.add(ofTurn.get(NEW) / ofTurn.get(options.get("against")));
            }
        }
        String name = checkpoint.getFileName().toString().replace(".json.gz", "");
        classPaths
                .keySet()
                .forEach(version -> System.out.println(line(name, version, rates.get(version), "%6.0f %6.0f %6.0f")));
        if (!ratios.isEmpty()) {
            System.out.println(line(name, "ratio", ratios, "%6.3f %6.3f %6.3f"));
        }
    }

    private static String line(String name, String what, List<Double> values, String format) {
        double[] sorted =
                values.stream().mapToDouble(Double::doubleValue).sorted().toArray();
        return String.format(Locale.ROOT, "%-22s %-14s ", name, Path.of(what).getFileName())
                + String.format(
                        Locale.ROOT, format, quantile(sorted, 0.25), quantile(sorted, 0.5), quantile(sorted, 0.75));
    }

    private static double quantile(double[] sorted, double portion) {
        double place = portion * (sorted.length - 1);
        int below = (int) place;
        int above = Math.min(below + 1, sorted.length - 1);
        return sorted[below] + (place - below) * (sorted[above] - sorted[below]);
    }

    /** Continues a checkpoint in a separate process, and returns thousand steps per second of processor time. */
    private double run(Path checkpoint, Path base, String classPath) throws IOException, InterruptedException {
        String[] words =
                checkpoint.getFileName().toString().replace(".json.gz", "").split("-");
        int first = Integer.parseInt(words[2]);
        int last = first + 1 + Integer.parseInt(options.get("generations"));
        Path folder = base.resolve(runName(checkpoint));
        Files.createDirectories(folder);
        Files.copy(checkpoint, folder.resolve("checkpoint.json.gz"), StandardCopyOption.REPLACE_EXISTING);
        List<String> command = new ArrayList<>(List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Xmx600m",
                "-XX:+UseSerialGC",
                "-cp",
                classPath,
                GenerationRun.class.getName(),
                folder.toString(),
                Integer.toString(first)));
        command.addAll(List.of("task=" + words[0], "method=" + words[1], "runs=1", "base=" + base, "maxGens=" + last));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        List<String> output;
        try (BufferedReader reader = process.inputReader()) {
            output = reader.lines().toList();
        }
        if (process.waitFor() != 0) {
            throw new IllegalStateException(String.join("\n", output));
        }
        List<long[]> ends = output.stream()
                .filter(line -> line.startsWith("generation "))
                .map(line -> Arrays.stream(line.split(" "))
                        .skip(1)
                        .mapToLong(Long::parseLong)
                        .toArray())
                .toList();
        if (ends.size() < 2) {
            throw new IllegalStateException(String.join("\n", output));
        }
        long[] warm = ends.get(0);
        long[] end = ends.get(ends.size() - 1);
        return (end[2] - warm[2]) * 1e6 / (end[1] - warm[1]);
    }

    /** Name of the run's folder below the base. */
    private static String runName(Path checkpoint) {
        return checkpoint.getFileName().toString().split("-")[1] + "0";
    }

    /** The columns of the generations up to the links of the champion; versions count steps in different ways. */
    private static String results(Path folder) throws IOException {
        return Files.readAllLines(folder.resolve("generations.csv")).stream()
                .map(line -> Arrays.stream(line.split(",")).limit(RESULTS).collect(Collectors.joining(",")))
                .collect(Collectors.joining("\n"));
    }

    private static void delete(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
                Files.delete(file);
            }
        }
    }
}
