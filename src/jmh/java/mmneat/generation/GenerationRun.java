package mmneat.generation;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Runs the program in this process and prints the processor time at the end of each generation.
 *
 * <p>The program is the version on the class path. It is started by its main method; the files of the run show when a
 * generation is over. A line of output is {@code generation NUMBER NANOSECONDS STEPS}: processor time of all threads
 * since the process started, and steps played by the process.
 */
final class GenerationRun {

    private static final long POLL_MILLISECONDS = 20;
    private static final Pattern RATE = Pattern.compile("\"stepsPerSecond\" : ([\\d.E]+)");
    private static final Pattern PACE = Pattern.compile("\"secondsPerGeneration\" : ([\\d.E]+)");

    private final Path folder;
    private final int first;
    private int seen;

    private GenerationRun(Path folder, int first) {
        this.folder = folder;
        this.first = first;
        seen = first;
    }

    /**
     * Executes a run.
     *
     * @param arguments the run's folder, its first generation, and the program's arguments
     */
    public static void main(String[] arguments) throws Exception {
        GenerationRun run = new GenerationRun(Path.of(arguments[0]), Integer.parseInt(arguments[1]));
        Thread watcher = new Thread(run::watch, "watcher");
        watcher.setDaemon(true);
        watcher.start();
        Runtime.getRuntime().addShutdownHook(new Thread(run::look));
        String[] rest = java.util.Arrays.copyOfRange(arguments, 2, arguments.length);
        // By name, because the class is in the measured jar.
        Class.forName("mmneat.cli.Main").getMethod("main", String[].class).invoke(null, (Object) rest);
    }

    private void watch() {
        try {
            while (true) {
                look();
                Thread.sleep(POLL_MILLISECONDS);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /**
     * Prints a line if a generation has ended since the last check. The status is the last file that a generation
     * writes.
     */
    private synchronized void look() {
        long time = processorTime();
        String status;
        try {
            status = Files.readString(folder.resolve("status.json"), StandardCharsets.UTF_8);
        } catch (IOException e) {
            // The file does not exist yet, or is just being replaced.
            return;
        }
        int generation = (int) number(Pattern.compile("\"generation\" : (\\d+)"), status);
        if (generation > seen) {
            seen = generation;
            double steps = number(RATE, status) * number(PACE, status) * (generation - first);
            System.out.printf(Locale.ROOT, "generation %d %d %d%n", generation, time, Math.round(steps));
        }
    }

    private static double number(Pattern pattern, String text) {
        Matcher matcher = pattern.matcher(text);
        return matcher.find() ? Double.parseDouble(matcher.group(1)) : 0;
    }

    private static long processorTime() {
        return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
                .getProcessCpuTime();
    }
}
