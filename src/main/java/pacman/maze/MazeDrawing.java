package pacman.maze;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A maze as a person draws it: 29 rows of 28 tiles, and the corridors that do not lie on the tile grid.
 *
 * <p>A tile is {@value #TILE} pixels wide and high and its node lies at pixel (4 column, 4 row), columns counted from 0
 * and rows from 1. Two neighbouring corridor tiles are joined by the three pixels between them. {@code docs/mazes.md}
 * describes the text format. What is wrong inside one line is found here, what is wrong with the maze as a whole by
 * {@link MazeGraph}.
 *
 * <p>Source: docs/specification/simulator.md, section 1.
 */
final class MazeDrawing {

    static final int TILE = 4;
    static final int COLUMNS = 28;
    static final int ROWS = 29;
    /** Pixels from the left to the right border, both included. */
    static final int WIDTH = TILE * (COLUMNS - 1) + 1;
    /** Pixel rows from 0 to the lowest tile row, both included; rows above the first tile row stay empty. */
    static final int HEIGHT = TILE * ROWS + 1;

    private static final String TILES = "#.o-:PGL";
    private static final Pattern CORRIDOR = Pattern.compile("corridor\\s+(column|row)\\s+(\\d+(?:\\.\\d+)?)\\s*,"
            + "\\s*(rows|columns)\\s+(\\d+(?:\\.\\d+)?)\\s+to\\s+(\\d+(?:\\.\\d+)?)\\s*");

    private final String file;
    /** Tile characters, [row - 1][column]. */
    private final char[][] tiles = new char[ROWS][COLUMNS];
    /** Line of the file in which a tile row stands, from 1. */
    private final int[] lineOfRow = new int[ROWS];
    /** Whether a pixel belongs to a corridor, [y][x]. */
    private final boolean[][] corridor = new boolean[HEIGHT][WIDTH];

    private final int[] pacManStart;
    private final int[] ghostStart;
    private final int[] lair;

    private record Line(int number, String text) {}

    /**
     * Reads a drawing.
     *
     * @param file name for error messages
     * @throws MazeFormatException if a line is not understood or a start is missing
     */
    MazeDrawing(String file, String text) {
        this.file = file;
        List<Line> corridorLines = readTiles(text);
        drawTiles();
        boolean[][] offGrid = new boolean[HEIGHT][WIDTH];
        for (Line line : corridorLines) {
            drawCorridor(line, offGrid);
        }
        checkOffGridMarks(offGrid);
        pacManStart = place('P', "Ms. Pac-Man's start", true);
        ghostStart = place('G', "the node where ghosts leave the lair", true);
        lair = place('L', "the lair", false);
    }

    private List<Line> readTiles(String text) {
        List<Line> corridors = new ArrayList<>();
        int row = 0;
        int number = 0;
        for (String line : text.split("\\R", -1)) {
            number++;
            String trimmed = line.stripTrailing();
            if (trimmed.isEmpty() || trimmed.startsWith(";")) {
                continue;
            }
            if (trimmed.startsWith("corridor")) {
                corridors.add(new Line(number, trimmed));
                continue;
            }
            if (row == ROWS) {
                throw errorAt(number, 1, "one row too many: a maze has " + ROWS + " rows of tiles; remove this line");
            }
            readRow(trimmed, number, row);
            row++;
        }
        if (row < ROWS) {
            throw errorAt(
                    number,
                    1,
                    "row " + (row + 1) + ", column 0: missing; a maze has " + ROWS + " rows of tiles, found " + row);
        }
        return corridors;
    }

    private void readRow(String line, int number, int row) {
        for (int column = 0; column < Math.min(line.length(), COLUMNS); column++) {
            char tile = line.charAt(column);
            if (TILES.indexOf(tile) < 0) {
                throw errorAt(
                        number,
                        column + 1,
                        where(row + 1, column) + ": unknown character '" + tile + "'; use one of " + TILES);
            }
            tiles[row][column] = tile;
        }
        if (line.length() != COLUMNS) {
            throw errorAt(
                    number,
                    Math.min(line.length(), COLUMNS) + 1,
                    where(row + 1, Math.min(line.length(), COLUMNS)) + ": ragged line with " + line.length()
                            + " tiles; every row has " + COLUMNS);
        }
        lineOfRow[row] = number;
    }

    private void drawTiles() {
        for (int row = 1; row <= ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                if (!isCorridorTile(row, column)) {
                    continue;
                }
                corridor[TILE * row][TILE * column] = true;
                for (int step = 1; step < TILE; step++) {
                    if (column + 1 < COLUMNS && isCorridorTile(row, column + 1)) {
                        corridor[TILE * row][TILE * column + step] = true;
                    }
                    if (row < ROWS && isCorridorTile(row + 1, column)) {
                        corridor[TILE * row + step][TILE * column] = true;
                    }
                }
            }
        }
    }

    private void drawCorridor(Line line, boolean[][] offGrid) {
        Matcher matcher = CORRIDOR.matcher(line.text());
        if (!matcher.matches()
                || matcher.group(1).equals("column") != matcher.group(3).equals("rows")) {
            throw errorAt(
                    line.number(),
                    1,
                    "corridor not understood; write for example \"corridor column 6.25, rows 11.25 to 14\""
                            + " or \"corridor row 14.5, columns 6.25 to 8.75\"");
        }
        boolean vertical = matcher.group(1).equals("column");
        int across = pixel(line, matcher, 2, vertical);
        int from = pixel(line, matcher, 4, !vertical);
        int to = pixel(line, matcher, 5, !vertical);
        if (from > to) {
            throw errorAt(line.number(), matcher.start(4) + 1, "the corridor ends before it begins; swap the numbers");
        }
        for (int along = from; along <= to; along++) {
            int x = vertical ? across : along;
            int y = vertical ? along : across;
            corridor[y][x] = true;
            offGrid[y][x] = true;
        }
    }

    /** A column or row of the grid, in quarters, as pixels. */
    private int pixel(Line line, Matcher matcher, int group, boolean isColumn) {
        double pixels = Double.parseDouble(matcher.group(group)) * TILE;
        int first = isColumn ? 0 : TILE;
        int last = isColumn ? WIDTH - 1 : HEIGHT - 1;
        if (pixels != Math.rint(pixels) || pixels < first || pixels > last) {
            throw errorAt(
                    line.number(),
                    matcher.start(group) + 1,
                    (isColumn ? "column " : "row ") + matcher.group(group) + " is not a multiple of 0.25 from "
                            + first / TILE + " to " + last / TILE);
        }
        return (int) pixels;
    }

    /** A tile marked ':' must have an off-grid corridor within its square. */
    private void checkOffGridMarks(boolean[][] offGrid) {
        for (int row = 1; row <= ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                if (tiles[row - 1][column] == ':' && !anyNear(offGrid, TILE * row, TILE * column)) {
                    throw errorAtTile(
                            row,
                            column,
                            "':' marks a corridor off the grid, but no corridor line below the drawing leads through it");
                }
            }
        }
    }

    private static boolean anyNear(boolean[][] pixels, int y, int x) {
        for (int row = y - TILE + 1; row < y + TILE; row++) {
            for (int column = x - TILE + 1; column < x + TILE; column++) {
                if (row >= 0 && row < HEIGHT && column >= 0 && column < WIDTH && pixels[row][column]) {
                    return true;
                }
            }
        }
        return false;
    }

    /** The pixel (x, y) that one mark, or midway two neighbouring ones, stand for. */
    private int[] place(char mark, String meaning, boolean onCorridor) {
        List<int[]> found = new ArrayList<>();
        for (int row = 1; row <= ROWS; row++) {
            for (int column = 0; column < COLUMNS; column++) {
                if (tiles[row - 1][column] == mark) {
                    found.add(new int[] {TILE * column, TILE * row});
                }
            }
        }
        if (found.isEmpty()) {
            throw errorAtTile(1, 0, "missing start: no '" + mark + "' (" + meaning + ") in the drawing");
        }
        int[] first = found.get(0);
        int[] last = found.get(found.size() - 1);
        boolean together = found.size() == 1
                || found.size() == 2 && Math.abs(first[0] - last[0]) + Math.abs(first[1] - last[1]) == TILE;
        if (!together) {
            throw errorAtTile(
                    last[1] / TILE,
                    last[0] / TILE,
                    "'" + mark + "' (" + meaning + ") occurs more than once; use one tile or two neighbouring tiles");
        }
        int[] pixel = {(first[0] + last[0]) / 2, (first[1] + last[1]) / 2};
        if (corridor[pixel[1]][pixel[0]] != onCorridor) {
            throw errorAtTile(
                    first[1] / TILE,
                    first[0] / TILE,
                    meaning + " must" + (onCorridor ? "" : " not") + " be on a corridor");
        }
        return pixel;
    }

    private boolean isCorridorTile(int row, int column) {
        return ".o-PG".indexOf(tiles[row - 1][column]) >= 0;
    }

    String file() {
        return file;
    }

    boolean isCorridor(int x, int y) {
        return x >= 0 && x < WIDTH && y >= 0 && y < HEIGHT && corridor[y][x];
    }

    boolean isPill(int x, int y) {
        return isTile(x, y, '.');
    }

    boolean isPowerPill(int x, int y) {
        return isTile(x, y, 'o');
    }

    private boolean isTile(int x, int y, char tile) {
        return x % TILE == 0 && y % TILE == 0 && y >= TILE && tiles[y / TILE - 1][x / TILE] == tile;
    }

    /** Pixel (x, y) at which Ms. Pac-Man starts. */
    int[] pacManStart() {
        return pacManStart;
    }

    /** Pixel (x, y) at which ghosts leave the lair. */
    int[] ghostStart() {
        return ghostStart;
    }

    /** Pixel (x, y) of the lair. */
    int[] lair() {
        return lair;
    }

    /** An error about the corridor at a pixel, reported at the tile that holds it. */
    MazeFormatException errorAtPixel(int x, int y, String message) {
        return errorAtTile(Math.max(1, (y + TILE / 2 - 1) / TILE), (x + TILE / 2 - 1) / TILE, message);
    }

    private MazeFormatException errorAtTile(int row, int column, String message) {
        return errorAt(lineOfRow[row - 1], column + 1, where(row, column) + ": " + message);
    }

    private static String where(int row, int column) {
        return "row " + row + ", column " + column;
    }

    private MazeFormatException errorAt(int line, int column, String message) {
        return new MazeFormatException(file + ":" + line + ":" + column + ": " + message);
    }
}
