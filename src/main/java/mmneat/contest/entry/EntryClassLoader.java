package mmneat.contest.entry;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.security.CodeSource;
import java.security.cert.Certificate;
import java.util.Optional;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.commons.ClassRemapper;
import org.objectweb.asm.commons.Remapper;
import pacman.controllers.Controller;

/**
 * Loads one entry of the competition: its own classes from its jar or class folder, the programming interface from us.
 *
 * <p>An entry is often packed together with the simulator that it was written for. Were its own copy of {@code
 * pacman.game.Game} used, the entry would not fit our games; so every class that we have below {@code pacman} is ours,
 * except {@code pacman.entries}, where the entries themselves live. Everything else comes from the entry first, so that
 * two entries, or an entry and this program, may use different versions of a library.
 *
 * <p>A copy of the simulator may also stand in another package, say {@code edu.example.pacman.controllers.Controller}.
 * The entry's superclasses tell: a superclass whose name ends as one of ours does gives away the package, and all names
 * below it that we have too are renamed in the entry's byte code as it is loaded. (By ASM, the library that the JDK and
 * most build tools use for this; it is small, and follows every Java version.) Names inside strings, as for {@code
 * Class.forName}, are not renamed.
 *
 * <p>Calls that end the program become errors of the controller: {@link ExitCalls}.
 */
final class EntryClassLoader extends URLClassLoader {

    /** Package of the programming interface, in the form of class files. */
    private static final String API = "pacman/";

    private static final String ENTRIES = "pacman.entries.";

    private static final ClassLoader OURS = Controller.class.getClassLoader();

    private final String entryName;

    /** Package in which the entry expects the programming interface, in the form of class files, with a slash behind. */
    private final String expectedApi;

    EntryClassLoader(URL[] places, String entryName) {
        super("entry " + entryName, places, ClassLoader.getPlatformClassLoader());
        this.entryName = entryName;
        expectedApi = findExpectedApi().orElse(API);
    }

    /** Whether a class is part of our programming interface and so never taken from an entry. */
    static boolean isOurs(String className) {
        boolean ourPackage =
                className.startsWith("pacman.") && !className.startsWith(ENTRIES) || className.startsWith("mmneat.");
        return ourPackage && OURS.getResource(fileOf(className)) != null;
    }

    /** Whether a class is one of our skeletons, whose names entries have too. */
    static boolean isSkeleton(String className) {
        return className.startsWith(ENTRIES);
    }

    Class<?> loadEntry() {
        return load(entryName);
    }

    /** Another class of the entry. */
    Class<?> load(String className) {
        try {
            return loadClass(className);
        } catch (ClassNotFoundException e) {
            throw new NoClassDefFoundError(e.getMessage());
        }
    }

    /** Whether the entry can be a controller: it extends one, as far as its class files tell, and is not abstract. */
    boolean isController() {
        return findExpectedApi().isPresent() && !isAbstract();
    }

    private boolean isAbstract() {
        return header(entryName)
                .map(file -> (file.getAccess() & Opcodes.ACC_ABSTRACT) != 0)
                .orElse(false);
    }

    @Override
    protected Class<?> loadClass(String name, boolean resolve) throws ClassNotFoundException {
        synchronized (getClassLoadingLock(name)) {
            Class<?> type = findLoadedClass(name);
            if (type == null) {
                type = isOurs(name) ? OURS.loadClass(name) : loadOther(name);
            }
            if (resolve) {
                resolveClass(type);
            }
            return type;
        }
    }

    /** From the JDK, from the entry, or, if the entry builds on our skeletons, from us. */
    private Class<?> loadOther(String name) throws ClassNotFoundException {
        try {
            return super.loadClass(name, false);
        } catch (ClassNotFoundException e) {
            if (name.startsWith(ENTRIES)) {
                return OURS.loadClass(name);
            }
            throw e;
        }
    }

    @Override
    protected Class<?> findClass(String name) throws ClassNotFoundException {
        ClassReader original = header(name).orElse(null);
        boolean isRenamed = !expectedApi.equals(API);
        if (original == null || !isRenamed && !ExitCalls.areIn(original)) {
            return super.findClass(name);
        }
        ClassWriter changed = new ClassWriter(0);
        ClassVisitor exitCalls = new ExitCalls(changed);
        original.accept(isRenamed ? new ClassRemapper(exitCalls, new ToOurs()) : exitCalls, 0);
        byte[] bytes = changed.toByteArray();
        return defineClass(name, bytes, 0, bytes.length, new CodeSource(placeOf(name), (Certificate[]) null));
    }

    /** The jar or folder of a class, which an entry may ask for to find its files. */
    private URL placeOf(String className) {
        String resource = findResource(fileOf(className)).toString();
        for (URL place : getURLs()) {
            if (resource.startsWith(place.toString()) || resource.startsWith("jar:" + place)) {
                return place;
            }
        }
        return null;
    }

    /** Renames what we have too; the entry's own classes keep their names. */
    private final class ToOurs extends Remapper {
        @Override
        public String map(String internalName) {
            if (internalName.startsWith(expectedApi)) {
                String ours = API + internalName.substring(expectedApi.length());
                if (isOurs(ours.replace('/', '.'))) {
                    return ours;
                }
            }
            return internalName;
        }
    }

    /** Climbs the entry's superclasses to the first that is named like a controller of ours. */
    private Optional<String> findExpectedApi() {
        String name = superclassOf(entryName);
        while (name != null && !name.startsWith("java/")) {
            int end = name.lastIndexOf("controllers/");
            boolean wholeWord = end == 0 || end > 0 && name.charAt(end - 1) == '/';
            if (wholeWord && isOurs((API + name.substring(end)).replace('/', '.'))) {
                return Optional.of(name.substring(0, end));
            }
            name = superclassOf(name.replace('/', '.'));
        }
        return Optional.empty();
    }

    /** In the form of class files; null if there is none, or the class is not the entry's. */
    private String superclassOf(String className) {
        return header(className).map(ClassReader::getSuperName).orElse(null);
    }

    /** Empty if the entry has no such class, or its file is damaged or too new to be read: the JVM will say so when it is loaded. */
    private Optional<ClassReader> header(String className) {
        try {
            return classFile(className).map(ClassReader::new);
        } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
            return Optional.empty();
        }
    }

    private Optional<byte[]> classFile(String className) {
        URL resource = findResource(fileOf(className));
        if (resource == null) {
            return Optional.empty();
        }
        try (InputStream file = resource.openStream()) {
            return Optional.of(file.readAllBytes());
        } catch (IOException e) {
            throw new UncheckedIOException("could not read " + resource, e);
        }
    }

    private static String fileOf(String className) {
        return className.replace('.', '/') + ".class";
    }
}
