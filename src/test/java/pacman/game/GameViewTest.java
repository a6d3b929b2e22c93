package pacman.game;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.image.BufferedImage;
import java.util.stream.IntStream;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.internal.Node;

/** The picture of a game, painted off screen: docs/specification/controllers.md, section 7. */
class GameViewTest {

    private final Game game = new Game(0);
    private final GameView view = new GameView(game);

    @BeforeEach
    void forgetDebugDrawing() {
        GameView.debugPointers.clear();
        GameView.debugLines.clear();
    }

    private BufferedImage painted() {
        return painted(view);
    }

    private static BufferedImage painted(GameView view) {
        BufferedImage image = new BufferedImage(228, 280, BufferedImage.TYPE_INT_RGB);
        Graphics graphics = image.createGraphics();
        view.paintComponent(graphics);
        graphics.dispose();
        return image;
    }

    private static Color colour(BufferedImage image, int x, int y) {
        return new Color(image.getRGB(x, y));
    }

    @Test
    void size_isTheMazeAndALineOfText() {
        assertThat(view.getPreferredSize()).isEqualTo(new Dimension(228, 280));
    }

    private BufferedImage painted(int width, int height) {
        view.setSize(width, height);
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        Graphics graphics = image.createGraphics();
        view.paintComponent(graphics);
        graphics.dispose();
        return image;
    }

    @Test
    void picture_isSharp_inWindowsOfWholeMultiples() {
        BufferedImage plain = painted();
        BufferedImage large = painted(2 * 228 + 60, 2 * 280);
        for (int y = 0; y < 2 * 280; y++) {
            for (int x = 0; x < 2 * 228; x++) {
                assertThat(large.getRGB(30 + x, y)).isEqualTo(plain.getRGB(x / 2, y / 2));
            }
        }
        assertThat(colour(large, 29, 100)).isEqualTo(Color.BLACK);
        assertThat(colour(large, 29, 400)).isEqualTo(Color.BLACK);
    }

    /** Returns the first and last column and row in which something is drawn. */
    private static int[] drawnPart(BufferedImage image) {
        int[] part = {image.getWidth(), image.getHeight(), -1, -1};
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                if ((image.getRGB(x, y) & 0xffffff) != 0) {
                    part = new int[] {
                        Math.min(part[0], x), Math.min(part[1], y), Math.max(part[2], x), Math.max(part[3], y)
                    };
                }
            }
        }
        return part;
    }

    @Test
    void picture_growsAndShrinksWithTheWindow() {
        int[] plain = drawnPart(painted(228, 280));
        for (double scale : new double[] {0.6, 1.25, 1.5, 2.7}) {
            int[] part = drawnPart(painted((int) (228 * scale), (int) (280 * scale)));
            for (int side = 0; side < 4; side++) {
                assertThat((double) part[side]).isCloseTo(plain[side] * scale, within(2 * scale + 2));
            }
        }
    }

    @Test
    void labels_areWords_andLeaveRoomForTheLives() {
        BufferedImage image = painted();
        for (int[] place : new int[][] {{4, 76}, {76, 122}, {122, 180}}) {
            assertThat(whiteColumns(image, place[0], place[1])).isGreaterThan(20);
        }
        assertThat(whiteColumns(image, 172, 180)).isZero();
    }

    /** Returns the number of columns of the text line that have white pixels. */
    private static long whiteColumns(BufferedImage image, int from, int to) {
        return IntStream.range(from, to)
                .filter(x -> IntStream.range(262, 274)
                        .anyMatch(y -> colour(image, x, y).equals(Color.WHITE)))
                .count();
    }

    @Test
    void announcement_isPainted_untilItIsTakenAway() {
        BufferedImage before = painted();
        view.announce("Press an arrow key");
        assertThat(isSame(before, painted())).isFalse();
        view.announce("");
        assertThat(isSame(before, painted())).isTrue();
    }

    private static boolean isSame(BufferedImage first, BufferedImage second) {
        return IntStream.range(0, 228 * 280)
                .allMatch(i -> first.getRGB(i % 228, i / 228) == second.getRGB(i % 228, i / 228));
    }

    @Test
    void withoutADisplay_nothingIsShown() {
        assertThat(view.showGame()).isSameAs(view);
        assertThat(view.getFrame()).isNull();
        view.repaint();
    }

    @Test
    void debugPoint_isASquareOfTenPixels_forOnePainting() {
        // A corridor node without a pill, away from all actors: the one in front of the lair.
        int node = game.getGhostInitialNodeIndex();
        int x = 2 * game.getNodeXCoord(node) + 1;
        int y = 2 * game.getNodeYCoord(node) + 5;
        assertThat(colour(painted(), x, y)).isEqualTo(Color.BLACK);
        GameView.addPoints(game, Color.GREEN, node);
        BufferedImage image = painted();
        assertThat(colour(image, x, y)).isEqualTo(Color.GREEN);
        assertThat(colour(image, x + 9, y + 9)).isEqualTo(Color.GREEN);
        assertThat(colour(image, x - 1, y)).isNotEqualTo(Color.GREEN);
        assertThat(colour(image, x + 10, y + 9)).isNotEqualTo(Color.GREEN);
        assertThat(colour(painted(), x, y)).isEqualTo(Color.BLACK);
    }

    @Test
    void debugLine_joinsTwoNodes() {
        int node = game.getGhostInitialNodeIndex();
        int next = game.getNeighbour(node, MOVE.LEFT);
        GameView.addLines(game, Color.RED, new int[] {node}, new int[] {next});
        BufferedImage image = painted();
        assertThat(colour(image, 2 * game.getNodeXCoord(node) + 5, 2 * game.getNodeYCoord(node) + 10))
                .isEqualTo(Color.RED);
    }

    @Test
    void debugDrawing_isBounded() {
        for (int i = 0; i < 30_000; i++) {
            GameView.addPoints(game, Color.RED, 0);
            GameView.addLines(game, Color.RED, 0, 1);
        }
        assertThat(GameView.debugPointers).hasSize(20_000);
        assertThat(GameView.debugLines).hasSize(20_000);
        painted();
        assertThat(GameView.debugPointers).isEmpty();
        assertThat(GameView.debugLines).isEmpty();
    }

    @Test
    void pills_disappearWhenTheyAreEaten() {
        int node = game.getPillIndices()[0];
        int x = 2 * game.getNodeXCoord(node) + 5;
        int y = 2 * game.getNodeYCoord(node) + 9;
        assertThat(colour(painted(), x, y)).isEqualTo(Color.WHITE);
        String[] fields = game.getGameState().split(",");
        for (int i = 0; i < fields.length; i++) {
            if (fields[i].length() == game.getNumberOfPills()) {
                fields[i] = "0".repeat(fields[i].length());
            }
        }
        game.setGameState(String.join(",", fields));
        assertThat(colour(painted(), x, y)).isEqualTo(Color.BLACK);
    }

    @Test
    void afterTheLastLevel_theMazeOfTheActors_isPainted() {
        for (int seed = 0; seed < 20; seed++) {
            ResumableRandom random = new ResumableRandom(seed);
            Game ended = new Game(seed, GameRules.isolatedGhosts(seed % 4, GhostLocations.shipped()), random);
            int pacMan = 0;
            while (!ended.gameOver()) {
                ended.advanceGame(MOVE.values()[random.nextInt(4)], GhostMoves.NONE);
                pacMan = ended.getPacmanCurrentNodeIndex();
            }
            assertThat(ended.getMazeIndex()).isNotEqualTo(3);
            Node node = new Game(0, 3).getCurrentMaze().graph[pacMan];
            BufferedImage around = painted(new GameView(ended)).getSubimage(2 * node.x - 1, 2 * node.y + 3, 14, 14);
            assertThat(around.getRGB(0, 0, 14, 14, null, 0, 14)).contains(new Color(255, 230, 0).getRGB());
        }
    }

    @Test
    void everyMaze_isDrawn_andEveryActorFacesItsWay() {
        GameView.Images images = view.new Images();
        for (int maze = 0; maze < Constants.NUM_MAZES; maze++) {
            BufferedImage picture = images.getMaze(maze);
            assertThat(picture.getWidth()).isEqualTo(224);
            assertThat(picture.getHeight()).isEqualTo(248);
            Game inMaze = new Game(0, maze);
            int start = inMaze.getPacmanCurrentNodeIndex();
            int x = 2 * inMaze.getNodeXCoord(start) + 4;
            int y = 2 * inMaze.getNodeYCoord(start) + 4;
            assertThat(new Color(picture.getRGB(x, y), true)).isEqualTo(Color.BLACK);
            assertThat(new Color(picture.getRGB(x, y - 7), true)).isNotEqualTo(Color.BLACK);
        }
        assertThat(pixels(images.getPacMan(MOVE.LEFT, 0))).isNotEqualTo(pixels(images.getPacMan(MOVE.RIGHT, 0)));
        assertThat(pixels(images.getPacMan(MOVE.LEFT, 0))).isNotEqualTo(pixels(images.getPacMan(MOVE.LEFT, 2)));
        assertThat(pixels(images.getGhost(GHOST.SUE, MOVE.LEFT, 0)))
                .isNotEqualTo(pixels(images.getGhost(GHOST.SUE, MOVE.RIGHT, 0)));
        assertThat(pixels(images.getGhost(GHOST.SUE, MOVE.UP, 0)))
                .isEqualTo(pixels(images.getGhost(GHOST.SUE, MOVE.NEUTRAL, 0)));
        assertThat(pixels(images.getEdibleGhost(true, 0))).isNotEqualTo(pixels(images.getEdibleGhost(false, 0)));
        assertThat(pixels(images.getEdibleGhost(true, 3))).isEqualTo(pixels(images.getEdibleGhost(false, 3)));
        assertThat(pixels(images.getPacManForExtraLives())).isEqualTo(pixels(images.getPacMan(MOVE.RIGHT, 0)));
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }
}
