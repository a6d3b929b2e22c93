package mmneat.experiment;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/** The place in the file system at which a file or folder is or will be made. */
public final class FolderPlace {

    private FolderPlace() {}

    /**
     * Checks that neither a folder nor one above it is a file. It may be missing or read only.
     *
     * @param word the option or parameter with this folder, for messages
     * @throws UserError if one of them is a file
     */
    public static void requireNoFile(String word, Path folder) {
        Path place = existing(folder.toAbsolutePath());
        if (place != null && !Files.isDirectory(place)) {
            throw new UserError(word + "=" + folder + ": " + place + " is a file; name a folder");
        }
    }

    /**
     * The file or folder itself, without the links that lead to it.
     *
     * @throws UserError if it cannot be read, for example because it is missing
     */
    public static Path real(Path file) {
        try {
            return file.toRealPath();
        } catch (IOException e) {
            throw FileErrors.unreadable(file, e);
        }
    }

    /** The path of a file without symbolic links; of a missing file as far as its folders exist. */
    public static Path withoutLinks(Path file) throws IOException {
        Path absolute = file.toAbsolutePath();
        Path place = existing(absolute);
        return place == null
                ? absolute.normalize()
                : place.toRealPath().resolve(place.relativize(absolute)).normalize();
    }

    /** The path, or the nearest folder above it that exists; null if there is none. */
    public static @Nullable Path existing(@Nullable Path path) {
        Path place = path;
        while (place != null && !Files.exists(place)) {
            place = place.getParent();
        }
        return place;
    }
}
