package pacman.game;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.StringReader;
import java.util.List;
import org.junit.jupiter.api.Test;
import pacman.Executor;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.StarterPacMan;
import pacman.maze.Mazes;

/** Rules check themselves and say what is wrong. */
class GameRulesTest {

    @Test
    void changedCopy_changesNothingElse() {
        GameRules rules = GameRules.mpmVsGhosts();
        assertThat(rules.with().build()).isEqualTo(rules);
        assertThat(rules.with().edibleTime(333).build().edibleTime()).isEqualTo(333);
        assertThat(rules.with().edibleTime(333).build().with().edibleTime(200).build())
                .isEqualTo(rules);
    }

    @Test
    void presets_areTheirFrameworks() {
        assertThat(GameRules.fourMaze().levelTimeLimit()).isEqualTo(50_000);
        assertThat(GameRules.fourMaze().maximumLevel()).isEqualTo(4);
        assertThat(GameRules.mpmVsGhosts().maximumLevel()).isEqualTo(16);
        assertThat(GameRules.mpmVsGhosts().levelTimeLimit()).isEqualTo(3000);
        assertThat(GameRules.competition().levelTimeLimit()).isEqualTo(4000);
        assertThat(GameRules.competition().maximumLevel()).isEqualTo(Integer.MAX_VALUE);
    }

    @Test
    void valueOutOfRange_isNamed() {
        assertThatThrownBy(() -> GameRules.blended().with().lives(0).build())
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("lives must be from 1");
        assertThatThrownBy(() -> GameRules.blended().with().activeGhosts(5).build())
                .hasMessageStartingWith("activeGhosts must be from 0 to 4, is 5");
        assertThatThrownBy(() ->
                        GameRules.blended().with().preEatenPillPortion(1.5).build())
                .hasMessageStartingWith("preEatenPillPortion must be from 0 to 1, is 1.5");
        assertThatThrownBy(() -> GameRules.blended().with().initialMaze(4).build())
                .hasMessageStartingWith("initialMaze must be from 0 to 3, is 4");
        assertThatThrownBy(() -> GameRules.isolatedGhosts(0, null))
                .hasMessageStartingWith("lairExitDatabase needs ghostLocations");
        assertThatThrownBy(() -> GameRules.blended().with().lairTime(1).build())
                .hasMessageStartingWith("lairTime must be from 2");
        Mazes own = Mazes.of(List.of(Mazes.standard().get(0)));
        assertThatThrownBy(() -> GameRules.isolatedGhosts(0, GameRecorder.ghostLocations())
                        .with()
                        .mazes(own)
                        .build())
                .hasMessageStartingWith("lairExitDatabase needs ghostLocations, which are recorded in the four mazes");
        assertThatThrownBy(() -> GameRules.blended()
                        .with()
                        .mazes(own)
                        .startingPowerPill(4)
                        .build())
                .hasMessage("startingPowerPill must be from -1 to 3, is 4");
        assertThatThrownBy(() -> GameRules.blended().with().startingPowerPill(4).build())
                .hasMessage("startingPowerPill must be from -1 to 3, is 4");
    }

    @Test
    void shortestLairTime_isEnoughForEveryLevel() {
        GameRules rules =
                GameRules.competition().with().lairTime(2).levelTimeLimit(200).build();
        Executor executor = new Executor();
        for (long seed = 0; seed < 20; seed++) {
            Game game = new Game(seed, rules);
            executor.runExperiment(new StarterPacMan(), new Legacy(), game);
            assertThat(game.gameOver()).isTrue();
        }
    }

    @Test
    void lairExitDatabase_withoutStartingPowerPill_isRefused() {
        GameRules rules = GameRules.isolatedGhosts(0, GameRecorder.ghostLocations());
        assertThatThrownBy(() -> new Game(0, rules.with().startingPowerPill(-1).build()))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("a startingPowerPill");
        assertThatThrownBy(() -> new Game(0).setLairExitDatabase(true)).isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void badGhostLocations_areNamedByLine() {
        assertThatThrownBy(() -> GhostLocations.read("places.txt", new StringReader("0 0 1 2 3 4\n0 0 1 2 x 4\n")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("places.txt:2: not a number");
        assertThatThrownBy(() -> GhostLocations.read("places.txt", new StringReader("0 0 1 2 3\n")))
                .hasMessageStartingWith("places.txt:1: expected six integers");
        assertThatThrownBy(() -> GhostLocations.read("places.txt", new StringReader("0 0 1 2 3 4\n")))
                .hasMessageContaining("maze 0, power pill 0 has 1 situations, 100 are needed");
        assertThatThrownBy(() -> GhostLocations.read("places.txt", new StringReader("4 0 1 2 3 4\n")))
                .hasMessageStartingWith("places.txt:1: expected six integers");
        assertThatThrownBy(() -> GhostLocations.read("places.txt", new StringReader("0 0 1 2 3 -4\n")))
                .hasMessageStartingWith("places.txt:1: node -4 is not in maze 0");
        int lair = Mazes.standard().get(2).graph().lair();
        assertThatThrownBy(() -> GhostLocations.read("places.txt", new StringReader("2 0 " + lair + " 2 3 4\n")))
                .hasMessageStartingWith("places.txt:1: node " + lair);
    }

    @Test
    void shippedGhostLocations_areComplete() {
        GhostLocations shipped = GhostLocations.shipped();
        assertThat(shipped.node(3, 3, GhostLocations.SITUATIONS - 1, 3)).isPositive();
    }

    @Test
    void ghostLocations_areTheFirstHundredLines() throws IOException {
        StringBuilder text = new StringBuilder();
        for (int line = 0; line < 16 * 101; line++) {
            text.append(line % 16 / 4 + "\t" + line % 4 + "\t" + line / 16 + "\t5\t6\t7\n");
        }
        GhostLocations locations = GhostLocations.read("places.txt", new StringReader(text.toString()));
        assertThat(locations.node(3, 2, 99, 0)).isEqualTo(99);
        assertThat(locations.node(0, 0, 0, 3)).isEqualTo(7);
    }
}
