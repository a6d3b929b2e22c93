package mmneat.analysis.evaluation;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;

/**
 * Short names for the sensors of the Ms.&nbsp;Pac-Man task, close to the paper's, for pictures and explanations.
 *
 * <p>One name uses other words than the original's label: the original calls a sensor "trapped" that is 1 if no
 * junction lies on the path between Ms.&nbsp;Pac-Man and the sensed ghost. Here it is called "no way out". Source:
 * docs/specification/mspacman-task.md, section 11.
 */
public final class SensorNames {

    private static final Pattern DIRECTION = Pattern.compile(" in dir -?\\d+$");
    private static final Map<Pattern, String> NAMES = names();

    private SensorNames() {}

    private static Map<Pattern, String> names() {
        Map<Pattern, String> names = new LinkedHashMap<>();
        names.put(Pattern.compile("Distance to 0 Nearest (\\d+) Closest Ghost"), "Ghost %d distance");
        names.put(Pattern.compile("(\\d+) Closest Ghost Incoming"), "Ghost %d approaching");
        names.put(Pattern.compile("(\\d+) Closest Ghost Trapped"), "Ghost %d no way out");
        names.put(Pattern.compile("(\\d+) Closest Ghost Edible"), "Ghost %d edible");
        names.put(
                Pattern.compile("Edible Time Vs Distance to 0 Nearest (\\d+) Closest Ghost"), "Ghost %d time to spare");
        names.put(Pattern.compile("Distance to 0 Nearest (\\d+) Closest Threat Ghost"), "Threat %d distance");
        names.put(Pattern.compile("(\\d+) Closest Threat Ghost Incoming"), "Threat %d approaching");
        names.put(Pattern.compile("(\\d+) Closest Threat Ghost Trapped"), "Threat %d no way out");
        names.put(Pattern.compile("Distance to 0 Nearest (\\d+) Closest Edible Ghost"), "Edible ghost %d distance");
        names.put(Pattern.compile("(\\d+) Closest Edible Ghost Incoming"), "Edible ghost %d approaching");
        names.put(Pattern.compile("(\\d+) Closest Edible Ghost Trapped"), "Edible ghost %d no way out");
        names.put(Pattern.compile("Distance to 0 Nearest Pill"), "Pill distance");
        names.put(Pattern.compile("Distance to 0 Nearest Power Pill"), "Power pill distance");
        names.put(Pattern.compile("Distance to 0 Nearest Junction"), "Junction distance");
        names.put(Pattern.compile("Max Num Pill 30 Steps Ahead"), "Pills in 30 steps");
        names.put(Pattern.compile("Max Num Junction 30 Steps Ahead"), "Junctions in 30 steps");
        names.put(Pattern.compile("Portion Power Pill Remaining"), "Power pills left");
        names.put(Pattern.compile("Portion Pill Remaining"), "Pills left");
        names.put(Pattern.compile("Portion Edible Ghost Remaining"), "Edible ghosts");
        names.put(Pattern.compile("\\d Highest Edible Time"), "Edible time");
        names.put(Pattern.compile("Some Ghost Edible"), "Any ghost edible");
        names.put(Pattern.compile("All Threats Present"), "All ghosts threaten");
        names.put(Pattern.compile("Within .* of Power Pill\\?"), "Near a power pill");
        names.put(Pattern.compile("Options After Junction"), "Ways out at junction");
        return names;
    }

    /** Short names for a task's input labels, in their order; a label that is not known stays as it is. */
    public static List<String> of(List<String> labels) {
        List<String> plain = labels.stream()
                .map(label -> DIRECTION.matcher(label).replaceFirst(""))
                .toList();
        return IntStream.range(0, plain.size())
                .mapToObj(i -> of(withKind(plain, i)))
                .toList();
    }

    /** The original gives one label to the threat and to the edible ghost, in this order. */
    private static String withKind(List<String> labels, int i) {
        String label = labels.get(i);
        boolean isFirst = i + 1 < labels.size() && label.equals(labels.get(i + 1));
        boolean isSecond = i > 0 && label.equals(labels.get(i - 1));
        return isFirst || isSecond
                ? label.replace("Closest Ghost", isFirst ? "Closest Threat Ghost" : "Closest Edible Ghost")
                : label;
    }

    private static String of(String plain) {
        for (Map.Entry<Pattern, String> name : NAMES.entrySet()) {
            Matcher matcher = name.getKey().matcher(plain);
            if (matcher.matches()) {
                // Ghosts are counted from 1, nearest first.
                return matcher.groupCount() == 0
                        ? name.getValue()
                        : String.format(java.util.Locale.ROOT, name.getValue(), Integer.parseInt(matcher.group(1)) + 1);
            }
        }
        return plain;
    }
}
