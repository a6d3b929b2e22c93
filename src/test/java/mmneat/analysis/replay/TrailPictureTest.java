package mmneat.analysis.replay;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.HashMap;
import java.util.Map;
import java.util.TreeSet;
import mmneat.analysis.evaluation.ShippedChampions;
import mmneat.mspacman.DirectionEvaluator;
import mmneat.mspacman.EvaluationObserver;
import mmneat.mspacman.GameEnd;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TrialGame;
import mmneat.neat.Genotype;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import pacman.game.Constants;
import pacman.game.Game;
import pacman.game.GameView;

/** The picture shows Ms. Pac-Man's trail in the current maze, coloured by the deciding module. */
class TrailPictureTest {

    private static final int BLACK = 0xff000000;
    private static final int STEPS_BETWEEN_LOOKS = 50;

    private final Genotype genotype = ShippedChampions.read("interleaved").genotype();

    @Test
    void everyNodeOfThisMazeThatSheVisited_hasTheColourOfTheModuleThatTookHerThereLast() {
        Looks looks = new Looks();
        new MsPacManTask(MsPacManTaskSettings.interleaved().withTrials(1))
                .evaluate(genotype, new ResumableRandom(5), looks);

        assertThat(looks.count).isGreaterThan(20);
        assertThat(looks.levels).hasSizeGreaterThan(1);
        assertThat(looks.modulesSeen).hasSizeGreaterThan(1);
    }

    @Test
    void scale_isTheLargestThatFits_andAtLeastOne() {
        TrailPicture picture = new TrailPicture(new Game(0), 2);
        for (int scale = 1; scale < 5; scale++) {
            BufferedImage image = picture.newImage(scale);
            assertThat(picture.scaleWithin(image.getWidth(), image.getHeight())).isEqualTo(scale);
            assertThat(picture.scaleWithin(image.getWidth() - 1, image.getHeight()))
                    .isEqualTo(Math.max(1, scale - 1));
            assertThat(picture.scaleWithin(image.getWidth(), image.getHeight() - 1))
                    .isEqualTo(Math.max(1, scale - 1));
        }
        assertThat(picture.scaleWithin(0, 0)).isEqualTo(1);
    }

    @Test
    void line_hasOneSquareForEachModule() {
        for (int modules = 1; modules <= 3; modules++) {
            TrailPicture picture = new TrailPicture(new Game(0), modules);
            BufferedImage image = picture.newImage(2);
            picture.draw(image, 2, "");
            for (int module = 0; module < 4; module++) {
                assertThat(isShown(image, ModuleColours.of(module).getRGB()))
                        .as("module %d of %d", module, modules)
                        .isEqualTo(module < modules);
            }
        }
    }

    private static boolean isShown(BufferedImage image, int colour) {
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                if (image.getRGB(x, y) == colour) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Compares the picture with the view and with the modules by node, every so many steps. */
    private final class Looks implements EvaluationObserver {
        private final Map<Integer, Integer> moduleByNode = new HashMap<>();
        private final TreeSet<Integer> levels = new TreeSet<>();
        private final TreeSet<Integer> modulesSeen = new TreeSet<>();
        private TrailPicture picture;
        private GameView view;
        private int level;
        private int steps;
        private int count;

        @Override
        public void gameStarted(TrialGame setting, Game game) {
            picture = new TrailPicture(game, genotype.modules());
            view = new GameView(game);
        }

        @Override
        public void stepPlayed(Game game, DirectionEvaluator player) {
            if (!picture.add(game, player)) {
                return;
            }
            if (game.getCurrentLevel() == level) {
                int module = player.lastModule(game.getPacmanLastMoveMade().ordinal());
                moduleByNode.put(game.getPacmanCurrentNodeIndex(), module);
                modulesSeen.add(module);
            } else {
                level = game.getCurrentLevel();
                moduleByNode.clear();
            }
            levels.add(level);
            if (++steps % STEPS_BETWEEN_LOOKS == 0) {
                look(game);
            }
        }

        private void look(Game game) {
            count++;
            BufferedImage plain = new BufferedImage(
                    view.getPreferredSize().width, view.getPreferredSize().height, BufferedImage.TYPE_INT_RGB);
            Graphics2D graphics = plain.createGraphics();
            view.paintComponent(graphics);
            graphics.dispose();
            picture.paint(game);
            BufferedImage shown = picture.newImage(1);
            picture.draw(shown, 1, "");
            moduleByNode.forEach((node, module) -> {
                // The middle of a node, which neighbours' marks do not reach.
                int x = game.getNodeXCoord(node) * Constants.MAG + 5;
                int y = game.getNodeYCoord(node) * Constants.MAG + 9;
                int expected =
                        plain.getRGB(x, y) == BLACK ? ModuleColours.of(module).getRGB() : plain.getRGB(x, y);
                assertThat(shown.getRGB(x, y)).as("node %d", node).isEqualTo(expected);
            });
        }

        @Override
        public void gameOver(TrialGame setting, Game game, GameEnd end, DirectionEvaluator player) {}
    }
}
