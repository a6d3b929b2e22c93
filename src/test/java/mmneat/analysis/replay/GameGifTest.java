package mmneat.analysis.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageInputStream;
import mmneat.analysis.evaluation.Champion;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import pacman.game.Game;
import pacman.game.GameView;
import pacman.game.GhostLocations;

/** The animated picture shows the game that the champion plays. */
class GameGifTest {

    private static final int MOST_BYTES = 3_000_000;

    private static MsPacManTaskSettings settings(String version) {
        return switch (version) {
            case "blended" -> MsPacManTaskSettings.blended();
            case "interleaved" -> MsPacManTaskSettings.interleaved();
            default -> MsPacManTaskSettings.isolated(GhostLocations.shipped());
        };
    }

    @ParameterizedTest
    @ValueSource(strings = {"blended", "interleaved", "isolated"})
    void picture_endsAsTheGameEnds_andIsSmall(String version) throws IOException {
        Champion champion = ShippedChampions.read(version);
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        int frames = GameGif.write(settings(version), champion.genotype(), 5, bytes, (drawn, all) -> assertThat(drawn)
                .isBetween(1, all));
        assertThat(bytes.size()).isLessThan(MOST_BYTES);

        List<BufferedImage> painted = ends(settings(version), champion);
        List<BufferedImage> shown = new ArrayList<>();
        int read = play(bytes.toByteArray(), shown);
        assertThat(read).isEqualTo(frames);
        assertThat(shown).hasSameSizeAs(painted);
        for (int i = 0; i < shown.size(); i++) {
            if (painted.get(i) != null) {
                assertSimilar(shown.get(i), painted.get(i));
            }
        }
    }

    /** What the view paints at the end of each game; null where the game ended with the last maze. */
    private static List<BufferedImage> ends(MsPacManTaskSettings settings, Champion champion) {
        List<BufferedImage> ends = new ArrayList<>();
        EvaluationObserver painter = new EvaluationObserver() {
            private GameView view;

            @Override
            public void gameStarted(TrialGame setting, Game game) {
                view = new GameView(game);
            }

            @Override
            public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {
                BufferedImage image = null;
                if (game.getCurrentLevel() < game.rules().levels().maximumLevel()) {
                    image = new BufferedImage(
                            view.getPreferredSize().width, view.getPreferredSize().height, BufferedImage.TYPE_INT_RGB);
                    Graphics2D graphics = image.createGraphics();
                    view.paintComponent(graphics);
                    graphics.dispose();
                }
                ends.add(image);
            }
        };
        new MsPacManTask(settings.withTrials(1)).evaluate(champion.genotype(), new ResumableRandom(5), painter);
        return ends;
    }

    /** Puts the frames over each other as a browser does; keeps those that are shown longest: the ends of games. */
    private static int play(byte[] gif, List<BufferedImage> ends) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        try (ImageInputStream stream = ImageIO.createImageInputStream(new ByteArrayInputStream(gif))) {
            reader.setInput(stream);
            BufferedImage first = reader.read(0);
            BufferedImage screen = new BufferedImage(first.getWidth(), first.getHeight(), BufferedImage.TYPE_INT_RGB);
            Graphics2D graphics = screen.createGraphics();
            int count = reader.getNumImages(true);
            for (int frame = 0; frame < count; frame++) {
                IIOMetadataNode root =
                        (IIOMetadataNode) reader.getImageMetadata(frame).getAsTree("javax_imageio_gif_image_1.0");
                graphics.drawImage(
                        reader.read(frame),
                        number(root, "ImageDescriptor", "imageLeftPosition"),
                        number(root, "ImageDescriptor", "imageTopPosition"),
                        null);
                if (frame == 0) {
                    assertThat(root.getElementsByTagName("ApplicationExtension").getLength())
                            .isEqualTo(1);
                }
                if (number(root, "GraphicControlExtension", "delayTime") > 100) {
                    BufferedImage end =
                            new BufferedImage(screen.getWidth(), screen.getHeight(), BufferedImage.TYPE_INT_RGB);
                    end.setData(screen.getData());
                    ends.add(end);
                }
            }
            graphics.dispose();
            return count;
        } finally {
            reader.dispose();
        }
    }

    private static int number(IIOMetadataNode root, String element, String attribute) {
        IIOMetadataNode node =
                (IIOMetadataNode) root.getElementsByTagName(element).item(0);
        return Integer.parseInt(node.getAttribute(attribute));
    }

    /** Twice as large, and equal except for the palette's rounding and the trail, which covers only black pixels. */
    private static void assertSimilar(BufferedImage shown, BufferedImage painted) {
        for (int y = 0; y < painted.getHeight(); y++) {
            for (int x = 0; x < painted.getWidth(); x++) {
                int expected = painted.getRGB(x, y);
                if ((expected & 0xffffff) != 0) {
                    int actual = shown.getRGB(2 * x, 2 * y);
                    for (int shift = 0; shift < 24; shift += 8) {
                        assertThat(Math.abs((actual >> shift & 255) - (expected >> shift & 255)))
                                .as("pixel %d, %d", x, y)
                                .isLessThanOrEqualTo(26);
                    }
                }
            }
        }
    }
}
