package mmneat.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.jar.JarFile;
import java.util.stream.Stream;

/** A jar or class folder that the user names, and the usual mistakes with it, such as source code in its place. */
public final class ClassPlace {

    private ClassPlace() {}

    /**
     * Checks that a file is a jar or a folder. Anything else, such as a pipe, is left to its reader.
     *
     * @param word the word that names it, for messages
     * @throws UserError if it is source code, a single class, or not a jar; the message says what to give
     */
    public static void require(String word, Path place) {
        if (!Files.isRegularFile(place)) {
            return;
        }
        if (place.toString().endsWith(".java")) {
            throw new UserError(
                    word + ": is source code; compile it first, and give the jar or the folder of its classes");
        }
        if (place.toString().endsWith(".class")) {
            throw new UserError(word + ": is a single class; give the folder of its package, or a jar");
        }
        try {
            new JarFile(place.toFile()).close();
        } catch (IOException e) {
            throw new UserError(word + ": is not a readable jar or class folder: " + e.getMessage(), e);
        }
    }

    /**
     * Returns the end of a message about a missing class if a folder has its source code; else empty.
     *
     * @param place a jar or folder
     * @param className name of the class; its package may be missing
     */
    public static String sourceHint(Path place, String className) {
        String simple = className.substring(className.lastIndexOf('.') + 1);
        return Stream.of(className.replace('.', '/'), simple)
                .map(name -> place.resolve(name + ".java"))
                .filter(Files::isRegularFile)
                .map(file -> ", but its source code, " + file + "; compile it first")
                .findFirst()
                .orElse("");
    }
}
