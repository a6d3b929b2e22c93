package mmneat.mspacman.modules;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * The divisions by their names in the parameter {@code pacmanMultitaskScheme} of the command line. {@link #named} finds
 * every division, {@link #find} only those that the original has.
 */
public final class ModuleDivisions {

    /** The original's class names, without package and without "ModeSelector". */
    private static final Map<String, ModuleDivision> KNOWN = known();

    private ModuleDivisions() {}

    private static Map<String, ModuleDivision> known() {
        Map<String, ModuleDivision> known = new LinkedHashMap<>();
        known.put("AnyGhostEdible", new AnyGhostEdible());
        known.put("GhostThreatEdibleOrBoth", new ThreatEdibleOrBoth());
        known.put("AnyPills", new AnyPills());
        known.put("AnyGhostThreat", new AnyGhostThreat());
        known.put("NumberThreatGhosts", new NumberOfThreats());
        known.put("GhostsThenPills", new GhostsThenPills());
        known.put("Maze", new EachMaze());
        return known;
    }

    /**
     * Returns the division with a name: a class name of the original, with or without its package, or the full name of
     * a class of your own on the class path.
     *
     * @throws IllegalArgumentException if there is none; the message lists the known names
     */
    public static ModuleDivision named(String name) {
        return find(name).orElseGet(() -> load(name));
    }

    /**
     * Returns the division of the original with a class name, with or without its package. Use it where classes of the
     * user's own must not be loaded; {@link #named} loads them too.
     *
     * @return empty if the original has no division of this name
     */
    public static Optional<ModuleDivision> find(String name) {
        String simple = OriginalClassName.simple(name);
        return Optional.ofNullable(KNOWN.get(
                simple.endsWith("ModeSelector")
                        ? simple.substring(0, simple.length() - "ModeSelector".length())
                        : simple));
    }

    private static ModuleDivision load(String name) {
        try {
            return Class.forName(name, false, ModuleDivisions.class.getClassLoader())
                    .asSubclass(ModuleDivision.class)
                    .getConstructor()
                    .newInstance();
        } catch (ClassNotFoundException e) {
            throw new IllegalArgumentException(
                    "pacmanMultitaskScheme: " + name + " is neither a class on the class path nor one of "
                            + KNOWN.keySet().stream()
                                    .map(known -> known + "ModeSelector")
                                    .collect(Collectors.joining(", ")),
                    e);
        } catch (ClassCastException e) {
            throw new IllegalArgumentException(
                    "pacmanMultitaskScheme: " + name + " does not implement " + ModuleDivision.class.getName(), e);
        } catch (NoSuchMethodException e) {
            throw new IllegalArgumentException(
                    "pacmanMultitaskScheme: " + name + " needs a public constructor without arguments", e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalArgumentException(
                    "pacmanMultitaskScheme: " + name + " cannot be created: " + e.getMessage(), e);
        }
    }
}
