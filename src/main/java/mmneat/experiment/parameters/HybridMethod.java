package mmneat.experiment.parameters;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import mmneat.experiment.UserError;
import mmneat.mspacman.TaskVersion;
import mmneat.mspacman.modules.OriginalClassName;

/**
 * A hybrid of the two ways in which the paper chooses modules. A division, a rule written by a human, chooses a group
 * of modules by the situation in the game; of that group, the module whose preference neuron is highest decides.
 *
 * <p>Its short name has one digit for each group, the number of its modules: {@code H21}. {@code H21MMD} adds module
 * mutation by duplication within the groups. On the command line, the groups may also be named: {@code
 * H:threat=2,edible=1,MMD}. The division is that of the multitask method with as many groups, or the user's own ({@code
 * pacmanMultitaskScheme}). It gives the groups their order, and the names of {@link
 * mmneat.mspacman.modules.ModuleDivision}; docs/hybrids.md lists them.
 *
 * @param sizes number of modules of each group at the start, each 1 to 9
 * @param isGrowing whether modules are added by mutation
 */
public record HybridMethod(List<Integer> sizes, boolean isGrowing) {

    private static final String LONG_FORM = "H:";
    private static final String GROWING = "MMD";
    private static final Pattern SHORT_FORM = Pattern.compile("H([1-9]{2,9})(MMD)?");
    private static final Pattern GROUP = Pattern.compile("(\\w+)=([1-9])");
    private static final Pattern SIZES = Pattern.compile("[1-9](,[1-9]){1,8}");

    public HybridMethod {
        sizes = List.copyOf(sizes);
    }

    /** Returns the method with a short name, such as {@code H21}; empty for any other text, also for the long form. */
    public static Optional<HybridMethod> of(String name) {
        Matcher form = SHORT_FORM.matcher(name);
        if (!form.matches()) {
            return Optional.empty();
        }
        return Optional.of(new HybridMethod(
                form.group(1).chars().map(digit -> digit - '0').boxed().toList(), form.group(2) != null));
    }

    /**
     * Whether a value of the parameter {@code method} has the long form, which names the groups. {@link
     * ParameterReader#read} replaces a long form by the short one, so checked {@link Parameters} never contain it.
     */
    public static boolean isLongForm(String value) {
        return value.regionMatches(true, 0, LONG_FORM, 0, LONG_FORM.length());
    }

    /**
     * The short name of a method whose groups are named.
     *
     * @param value {@code H:} and each group of the division once, in any order, {@code MMD} at the end for module
     *     mutation
     * @param version of the task, whose divisions have the names
     * @param division the division that was asked for; empty for the published one. The groups of another division have
     *     numbers instead of names
     * @throws UserError if there is no such method
     */
    static String shortName(String value, Optional<TaskVersion> version, String division) {
        List<String> parts = new ArrayList<>(
                Arrays.asList(value.substring(LONG_FORM.length()).strip().split("\\s*,\\s*", -1)));
        boolean isGrowing = parts.removeIf(GROWING::equalsIgnoreCase);
        boolean isNumbered =
                version.filter(known -> isOther(division, known, parts.size())).isPresent();
        List<String> groups = isNumbered
                ? IntStream.range(0, parts.size()).mapToObj(String::valueOf).toList()
                : version.map(known -> groups(known, parts.size())).orElse(List.of());
        List<Integer> sizes = new ArrayList<>(Collections.nCopies(groups.size(), 0));
        for (String part : parts) {
            Matcher group = GROUP.matcher(part);
            int place = group.matches() ? groups.indexOf(group.group(1).toLowerCase(Locale.ROOT)) : -1;
            if (place < 0 || sizes.get(place) > 0) {
                throw new UserError("method=" + value + ": '" + part + "' is not allowed; "
                        + (isNumbered ? numbers(division) : words(version)));
            }
            sizes.set(place, Integer.parseInt(group.group(2)));
        }
        return name(sizes, isGrowing);
    }

    /** Whether a division was asked for that is not the published one with so many groups. */
    private static boolean isOther(String division, TaskVersion version, int groups) {
        if (division.isBlank()) {
            return false;
        }
        Map<String, String> published = new HybridMethod(Collections.nCopies(groups, 1), false).settings(version);
        return !OriginalClassName.simple(division.strip()).equals(published.get("pacmanMultitaskScheme"));
    }

    private static String numbers(String division) {
        return "give every group of pacmanMultitaskScheme=" + division + " once by its number from 0, such as "
                + LONG_FORM + "0=1,1=1";
    }

    private static String words(Optional<TaskVersion> version) {
        return version.map(known -> "give every group once with its number of modules, 1 to 9, such as "
                        + IntStream.rangeClosed(2, 3)
                                .mapToObj(count -> groups(known, count))
                                .filter(names -> !names.isEmpty())
                                .map(names -> LONG_FORM + String.join("=1,", names) + "=1")
                                .collect(Collectors.joining(" or ")))
                .orElse("only the tasks " + String.join(", ", TaskVersion.labels()) + " have named groups");
    }

    /** The groups of a version's published division with so many modules, in the order of the division. */
    private static List<String> groups(TaskVersion version, int count) {
        if (count == 3) {
            return version == TaskVersion.BLENDED ? List.of("edible", "threat", "both") : List.of();
        }
        if (count != 2) {
            return List.of();
        }
        return version == TaskVersion.ISOLATED ? List.of("pills", "ghosts") : List.of("threat", "edible");
    }

    /**
     * The method that a run's parameters describe.
     *
     * @param moduleGroups the parameter of that name; empty if the run is not a hybrid
     * @param canAddModules whether modules are added by mutation
     */
    static Optional<String> name(String moduleGroups, boolean canAddModules) {
        return SIZES.matcher(moduleGroups).matches()
                ? Optional.of(name(sizes(moduleGroups), canAddModules))
                : Optional.empty();
    }

    /**
     * The numbers of modules that the parameter {@code moduleGroups} names.
     *
     * @throws UserError if it is not such a list
     */
    static List<Integer> sizes(String moduleGroups) {
        if (!SIZES.matcher(moduleGroups).matches()) {
            throw new UserError("moduleGroups=" + moduleGroups
                    + ": must be the number of modules of each group, 2 to 9 numbers from 1 to 9, such as 2,1");
        }
        return Arrays.stream(moduleGroups.split(",")).map(Integer::valueOf).toList();
    }

    private static String name(List<Integer> sizes, boolean isGrowing) {
        return "H" + sizes.stream().map(String::valueOf).collect(Collectors.joining()) + (isGrowing ? GROWING : "");
    }

    /** What the method sets for a version: the published multitask method with as many modules, and the groups. */
    Map<String, String> settings(TaskVersion version) {
        List<String> published = PublishedConfigurations.methodsOf(version);
        String sameNumber = "MT" + sizes.size();
        String model = published.contains(sameNumber) ? sameNumber : published.contains("MT") ? "MT" : "MT2";
        Map<String, String> settings = PublishedConfigurations.settings(version, model);
        settings.put("multitaskModes", String.valueOf(sizes.size()));
        settings.put("moduleGroups", sizes.stream().map(String::valueOf).collect(Collectors.joining(",")));
        if (isGrowing) {
            settings.put(
                    "mmdRate",
                    PublishedConfigurations.settings(version, GROWING).get("mmdRate"));
        }
        return settings;
    }
}
