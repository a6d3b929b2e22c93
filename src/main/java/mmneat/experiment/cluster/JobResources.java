package mmneat.experiment.cluster;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;

/**
 * The resources that one run requests from the scheduler.
 *
 * @param cpus processors, at least 1; a run uses one unless {@code parallelEvaluations=true}
 * @param memoryMebibytes memory of the whole process, in MiB, at least 256
 * @param time time limit of the job; at the limit the run saves, and the job is queued again
 * @param java path of the Java program on the machines that run the jobs
 */
public record JobResources(int cpus, int memoryMebibytes, Duration time, String java) {

    private static final Pattern MEMORY = Pattern.compile("(\\d+)\\s*([MG])(?:i?B)?", Pattern.CASE_INSENSITIVE);
    private static final Pattern TIME = Pattern.compile("(?:(\\d+)-)?(\\d+):(\\d{2})(?::(\\d{2}))?");

    private static final Pattern ASSIGNMENT = Pattern.compile("\\w+=");

    /** Minimum memory with which a run starts, in MiB. */
    private static final int LEAST_MEMORY = 256;

    /** Share of a job's memory that is Java's heap; the rest is for code, threads and the collector. */
    private static final double HEAP_SHARE = 0.75;

    public JobResources {
        PlainText.require("java", java);
        if (java.isBlank() || ASSIGNMENT.matcher(java).lookingAt()) {
            throw new UserError("java=" + java + ": must be the name or path of a program");
        }
        if (cpus < 1) {
            throw new UserError("cpus=" + cpus + ": a run needs at least one processor");
        }
        if (memoryMebibytes < LEAST_MEMORY) {
            throw new UserError("memory=" + memoryMebibytes + "M: a run needs at least " + LEAST_MEMORY + "M");
        }
        if (time.isNegative() || time.isZero()) {
            throw new UserError("time must be longer than zero");
        }
    }

    /** Reads {@code 800M}, {@code 1G} or {@code 2GiB} as MiB. */
    public static int parseMemory(String text) {
        Matcher memory = MEMORY.matcher(text.strip());
        if (!memory.matches() || memory.group(1).length() > 6) {
            throw new UserError("memory=" + text + ": write megabytes or gigabytes, for instance memory=1G");
        }
        int number = Integer.parseInt(memory.group(1));
        return memory.group(2).toUpperCase(Locale.ROOT).equals("G") ? Math.multiplyExact(number, 1024) : number;
    }

    /** Reads {@code hours:minutes:seconds}, {@code hours:minutes} or {@code days-hours:minutes:seconds}. */
    public static Duration parseTime(String text) {
        Matcher time = TIME.matcher(text.strip());
        if (!time.matches()) {
            throw new UserError("time=" + text + ": write hours:minutes:seconds, for instance time=12:00:00");
        }
        try {
            return Duration.ofDays(number(time.group(1)))
                    .plusHours(number(time.group(2)))
                    .plusMinutes(number(time.group(3)))
                    .plusSeconds(number(time.group(4)));
        } catch (ArithmeticException | NumberFormatException e) {
            throw new UserError("time=" + text + ": too large; give a shorter time", e);
        }
    }

    private static long number(String text) {
        return text == null ? 0 : Long.parseLong(text);
    }

    /** Returns the time in hours, minutes and seconds, as schedulers read it: {@code 36:00:00}. */
    String clockTime() {
        return String.format(Locale.ROOT, "%d:%02d:%02d", time.toHours(), time.toMinutesPart(), time.toSecondsPart());
    }

    /**
     * Returns the Java command with a heap that fits into the requested memory. By default Java would size its heap by
     * the whole machine.
     */
    List<String> javaCommand() {
        String collector = cpus == 1 ? "-XX:+UseSerialGC" : "-XX:+UseParallelGC";
        return List.of(
                java,
                collector,
                "-XX:ActiveProcessorCount=" + cpus,
                "-Xmx" + (int) (memoryMebibytes * HEAP_SHARE) + "m");
    }
}
