package pacman.game.util;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/** Text files of an entry, below {@link #DIRECTORY}. Part of the competition's programming interface. */
public class IO {

    /** The folder of an entry's files, relative to the working directory. It is not created. */
    public static final String DIRECTORY = "myData/";

    /**
     * Writes data and a line end.
     *
     * @param fileName name below {@link #DIRECTORY}
     * @param append whether to append to an existing file
     * @return whether the file was written; an error is printed
     */
    public static boolean saveFile(String fileName, String data, boolean append) {
        try {
            Files.writeString(
                    Path.of(DIRECTORY + fileName),
                    data + System.lineSeparator(),
                    StandardCharsets.UTF_8,
                    StandardOpenOption.CREATE,
                    append ? StandardOpenOption.APPEND : StandardOpenOption.TRUNCATE_EXISTING,
                    StandardOpenOption.WRITE);
            return true;
        } catch (IOException e) {
            System.err.println("Could not save " + DIRECTORY + fileName + ": " + e);
            return false;
        }
    }

    /**
     * Reads all non-empty lines.
     *
     * @param fileName name below {@link #DIRECTORY}
     * @return the lines, each followed by {@code \n}; empty after an error, which is printed
     */
    public static String loadFile(String fileName) {
        StringBuilder data = new StringBuilder();
        try {
            for (String line : Files.readAllLines(Path.of(DIRECTORY + fileName), StandardCharsets.UTF_8)) {
                if (!line.isEmpty()) {
                    data.append(line).append('\n');
                }
            }
            return data.toString();
        } catch (IOException e) {
            System.err.println("Could not load " + DIRECTORY + fileName + ": " + e);
            return "";
        }
    }
}
