package mmneat.contest.entry;

import java.io.File;
import java.io.IOException;
import java.net.MalformedURLException;
import java.net.URL;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.TreeMap;
import java.util.jar.JarFile;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import mmneat.experiment.ClassPlace;
import mmneat.experiment.UserError;

/** The user's class path: jars and class folders, and the classes in them. */
final class EntryPath {

    private static final String CLASS_FILE = ".class";

    private final String option;
    private final List<Path> places;

    /** The jars and folders of all classes, by class name. */
    private final TreeMap<String, List<Path>> placesOfClasses = new TreeMap<>();

    EntryPath(String option, List<Path> places) {
        this.option = option;
        this.places = places.stream().distinct().toList();
        for (Path place : this.places) {
            for (String name : classesIn(place)) {
                placesOfClasses.computeIfAbsent(name, none -> new ArrayList<>()).add(place);
            }
        }
    }

    boolean isEmpty() {
        return places.isEmpty();
    }

    /**
     * Returns the classes on this path that {@code name} may mean: the class with exactly this name, or those with this
     * name without the package or the enclosing class. Copies of our own interface and examples are excluded.
     */
    List<String> classesNamed(String name) {
        List<String> candidates = placesOfClasses.keySet().stream()
                .filter(found -> !EntryClassLoader.isOurs(found))
                .toList();
        return candidates.contains(name)
                ? List.of(name)
                : candidates.stream()
                        .filter(found -> simpleName(found).equals(name) || found.endsWith("." + name))
                        .toList();
    }

    /**
     * Loads a class of this path in a separate class loader. Other classes that it needs are searched in the same jar
     * or folder first, because other entries may have classes with the same names.
     *
     * @throws UserError if the class is in several jars or folders
     */
    Class<?> load(String className) {
        List<Path> holders = placesOf(className);
        if (holders.size() > 1) {
            throw new UserError("'" + className + "' is in "
                    + holders.stream().map(Path::toString).collect(Collectors.joining(" and in "))
                    + "; give each side a class path of its own, pacmanClasspath= and ghostsClasspath=");
        }
        return loader(className).loadEntry();
    }

    /** Returns the jar or folder of a class of this path. */
    String placeOf(String className) {
        return placesOf(className).get(0).toString();
    }

    private List<Path> placesOf(String className) {
        return Objects.requireNonNull(placesOfClasses.get(className), className);
    }

    private EntryClassLoader loader(String className) {
        Path own = placesOf(className).get(0);
        URL[] urls = Stream.concat(Stream.of(own), places.stream().filter(place -> !place.equals(own)))
                .map(this::url)
                .toArray(URL[]::new);
        return new EntryClassLoader(urls, className);
    }

    private URL url(Path place) {
        try {
            return place.toUri().toURL();
        } catch (MalformedURLException e) {
            throw new UserError(option + ": cannot use " + place + ": " + e.getMessage(), e);
        }
    }

    /** Returns the classes on this path that extend our Controller, in order. */
    List<String> controllerNames() {
        return placesOfClasses.keySet().stream()
                .filter(name -> !EntryClassLoader.isOurs(name))
                .filter(name -> loader(name).isController())
                .toList();
    }

    /** Returns the end of a message about a missing class if a place has its source code; else empty. */
    String sourceHint(String className) {
        return places.stream()
                .map(place -> ClassPlace.sourceHint(place, className))
                .filter(hint -> !hint.isEmpty())
                .findFirst()
                .orElse("");
    }

    @Override
    public String toString() {
        return places.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator));
    }

    /** Returns the name without package and enclosing class, as in reports. */
    private static String simpleName(String className) {
        return className.substring(Math.max(className.lastIndexOf('.'), className.lastIndexOf('$')) + 1);
    }

    private List<String> classesIn(Path place) {
        if (!Files.exists(place)) {
            throw new UserError(option + ": there is no file or folder " + place);
        }
        ClassPlace.require(option + "=" + place, place);
        try {
            return Files.isDirectory(place) ? classesInFolder(place) : classesInJar(place);
        } catch (IOException e) {
            throw new UserError(option + ": " + place + " is not a readable jar or class folder: " + e.getMessage(), e);
        }
    }

    private static List<String> classesInFolder(Path folder) throws IOException {
        try (Stream<Path> files = Files.walk(folder)) {
            return files.map(file -> folder.relativize(file).toString().replace(File.separatorChar, '/'))
                    .filter(EntryPath::isClassFile)
                    .map(EntryPath::className)
                    .toList();
        }
    }

    private static List<String> classesInJar(Path jar) throws IOException {
        try (JarFile file = new JarFile(jar.toFile())) {
            return file.stream()
                    .map(ZipEntry::getName)
                    .filter(EntryPath::isClassFile)
                    .map(EntryPath::className)
                    .toList();
        }
    }

    private static boolean isClassFile(String path) {
        return path.endsWith(CLASS_FILE)
                && !path.startsWith("META-INF/")
                && !path.endsWith("module-info.class")
                && !path.endsWith("package-info.class");
    }

    private static String className(String path) {
        return path.substring(0, path.length() - CLASS_FILE.length()).replace('/', '.');
    }
}
