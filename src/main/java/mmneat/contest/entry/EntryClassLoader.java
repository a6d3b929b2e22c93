package mmneat.contest.entry;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.security.CodeSource;
import java.security.cert.Certificate;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.objectweb.asm.ClassReader;
import org.objectweb.asm.ClassVisitor;
import org.objectweb.asm.ClassWriter;
import org.objectweb.asm.Opcodes;
import org.objectweb.asm.commons.ClassRemapper;
import org.objectweb.asm.commons.Remapper;
import pacman.controllers.Controller;

/**
 * The class loader of one entry of the competition. It loads the entry's classes from its jar or class folder, and the
 * programming interface from this program.
 *
 * <p>An entry is often packed together with the simulator for which it was written. With its own copy of {@code
 * pacman.game.Game} it could not play our games. So every class that this program has below {@code pacman} is taken
 * from this program, except in {@code pacman.entries}, the package of the entries. Everything else is searched in the
 * entry first, so that two entries, or an entry and this program, can use different versions of a library.
 *
 * <p>The copy of the simulator may also have been moved to another package. For example, an entry may extend {@code
 * edu.example.pacman.controllers.Controller}, where this program has {@code pacman.controllers.Controller}. The entry's
 * superclasses are searched for such a name: one that ends like the name of a class of this program from {@code
 * controllers} on. The part before it, here {@code edu.example.pacman}, is the package of the copy. All names of
 * classes below this package that this program also has below {@code pacman} are then renamed in the entry's byte code
 * during loading. (ASM does this, the library that the JDK and most build tools use; it is small and supports every
 * Java version.) Names inside strings, as for {@code Class.forName}, are not renamed.
 *
 * <p>Calls that end the program become errors of the controller: {@link ExitCalls}.
 */
final class EntryClassLoader extends URLClassLoader {

    /** Package of the programming interface, in the form of class files. */
    private static final String API = "pacman/";

    private static final String ENTRIES = "pacman.entries.";

    private static final ClassLoader OURS = Controller.class.getClassLoader();

    private final String entryName;

    /**
     * Package in which the entry expects the programming interface, in the form of class files, with a slash at the
     * end.
     */
    private final String expectedApi;

    EntryClassLoader(URL[] places, String entryName) {
        super("entry " + entryName, places, ClassLoader.getPlatformClassLoader());
        this.entryName = entryName;
        expectedApi = findExpectedApi().orElse(API);
    }

    /** Whether a class is part of our programming interface and therefore never loaded from an entry. */
    static boolean isOurs(String className) {
        boolean ourPackage =
                className.startsWith("pacman.") && !className.startsWith(ENTRIES) || className.startsWith("mmneat.");
        return ourPackage && OURS.getResource(fileOf(className)) != null;
    }

    /** Whether a class is one of our skeletons, whose names entries also use. */
    static boolean isSkeleton(String className) {
        return className.startsWith(ENTRIES);
    }

    Class<?> loadEntry() {
        return load(entryName);
    }

    /** Loads another class of the entry. */
    Class<?> load(String className) {
        try {
            return loadClass(className);
        } catch (ClassNotFoundException e) {
            throw new NoClassDefFoundError(e.getMessage());
        }
    }

    /** Whether the entry can be a controller: according to its class files, it extends one and is not abstract. */
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

    /** Loads a class from the JDK, from the entry, or, if the entry extends our skeletons, from this program. */
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

    /** Returns the jar or folder of a class, which an entry may use to find its files. */
    private @Nullable URL placeOf(String className) {
        String resource = findResource(fileOf(className)).toString();
        for (URL place : getURLs()) {
            if (resource.startsWith(place.toString()) || resource.startsWith("jar:" + place)) {
                return place;
            }
        }
        return null;
    }

    /** Renames classes that this program also has; the entry's own classes keep their names. */
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

    /** Searches the entry's superclasses for the first whose name ends like a controller of ours. */
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

    /**
     * Returns the superclass in the form of class files; null if there is none, or the class is not part of the entry.
     */
    private @Nullable String superclassOf(String className) {
        return header(className).map(ClassReader::getSuperName).orElse(null);
    }

    /**
     * Returns the header of a class file; empty if the entry has no such class, or the file is damaged or too new. The
     * JVM reports that when it loads the class.
     */
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
