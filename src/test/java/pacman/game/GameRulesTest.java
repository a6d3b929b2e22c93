package pacman.game;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.StringReader;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import pacman.Executor;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.StarterPacMan;
import pacman.maze.Mazes;

/** Rules are checked, and messages say what is wrong. */
class GameRulesTest {

    @Test
    void changedCopy_changesNothingElse() {
        GameRules rules = GameRules.mpmVsGhosts();
        assertThat(rules.withGhosts(ghosts -> ghosts.withEdibleTime(333))
                        .ghosts()
                        .edibleTime())
                .isEqualTo(333);
        assertThat(rules.withGhosts(ghosts -> ghosts.withEdibleTime(333))
                        .withGhosts(ghosts -> ghosts.withEdibleTime(200)))
                .isEqualTo(rules);
    }

    /** Every {@code with...} of the four parts changes the component that it names, and no other. */
    @ParameterizedTest
    @MethodSource
    void everyChange_changesTheComponentOfItsName(Record part) throws ReflectiveOperationException {
        RecordComponent[] components = part.getClass().getRecordComponents();
        for (RecordComponent component : components) {
            String name = component.getName();
            Object value = otherThan(component.getAccessor().invoke(part), component.getType());
            Method change = part.getClass()
                    .getMethod(
                            "with" + name.substring(0, 1).toUpperCase(Locale.ROOT) + name.substring(1),
                            component.getType());
            Object changed = change.invoke(part, value);
            for (RecordComponent other : components) {
                Object expected =
                        other == component ? value : other.getAccessor().invoke(part);
                assertThat(other.getAccessor().invoke(changed))
                        .as("%s after %s", other, change)
                        .isEqualTo(expected);
            }
        }
    }

    static Stream<Record> everyChange_changesTheComponentOfItsName() {
        GameRules rules = GameRules.blended();
        return Stream.of(rules.mazes(), rules.levels(), rules.ghosts(), rules.pills());
    }

    private static Object otherThan(Object value, Class<?> type) {
        if (type == boolean.class) {
            return !(boolean) value;
        }
        if (type == int.class) {
            return (int) value == 3 ? 2 : 3;
        }
        if (type == double.class) {
            return 0.5;
        }
        return type == Mazes.class
                ? Mazes.of(List.of(Mazes.standard().get(0), Mazes.standard().get(1)))
                : GhostLocations.shipped();
    }

    @Test
    void presets_areTheirFrameworks() {
        assertThat(GameRules.fourMaze().levels().levelTimeLimit()).isEqualTo(50_000);
        assertThat(GameRules.fourMaze().levels().maximumLevel()).isEqualTo(4);
        assertThat(GameRules.mpmVsGhosts().levels().maximumLevel()).isEqualTo(16);
        assertThat(GameRules.mpmVsGhosts().levels().levelTimeLimit()).isEqualTo(3000);
        assertThat(GameRules.competition().levels().levelTimeLimit()).isEqualTo(4000);
        assertThat(GameRules.competition().levels().maximumLevel()).isEqualTo(Integer.MAX_VALUE);
    }

    @Test
    void valueOutOfRange_isNamed() {
        assertThatThrownBy(() -> GameRules.blended().withLevels(levels -> levels.withLives(0)))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith("lives must be from 1");
        assertThatThrownBy(() -> GameRules.blended().withGhosts(ghosts -> ghosts.withActiveGhosts(5)))
                .hasMessageStartingWith("activeGhosts must be from 0 to 4, is 5");
        assertThatThrownBy(() -> GameRules.blended().withPills(pills -> pills.withPreEatenPillPortion(1.5)))
                .hasMessageStartingWith("preEatenPillPortion must be from 0 to 1, is 1.5");
        assertThatThrownBy(() -> GameRules.blended().withMazes(mazes -> mazes.withInitialMaze(4)))
                .hasMessageStartingWith("initialMaze must be from 0 to 3, is 4");
        assertThatThrownBy(() -> GameRules.isolatedGhosts(0, null))
                .hasMessageStartingWith("lairExitDatabase needs ghostLocations");
        assertThatThrownBy(() -> GameRules.blended().withGhosts(ghosts -> ghosts.withLairTime(1)))
                .hasMessageStartingWith("lairTime must be from 2");
        Mazes own = Mazes.of(List.of(Mazes.standard().get(0)));
        assertThatThrownBy(() -> GameRules.isolatedGhosts(0, GameRecorder.ghostLocations())
                        .withMazes(mazes -> mazes.withMazes(own)))
                .hasMessageStartingWith("lairExitDatabase needs ghostLocations, which are recorded in the four mazes");
        assertThatThrownBy(() -> GameRules.blended()
                        .withMazes(mazes -> mazes.withMazes(own).withStartingPowerPill(4)))
                .hasMessage("startingPowerPill must be from -1 to 3, is 4");
        assertThatThrownBy(() -> GameRules.blended().withMazes(mazes -> mazes.withStartingPowerPill(4)))
                .hasMessage("startingPowerPill must be from -1 to 3, is 4");
    }

    @Test
    void shortestLairTime_isEnoughForEveryLevel() {
        GameRules rules = GameRules.competition()
                .withGhosts(ghosts -> ghosts.withLairTime(2))
                .withLevels(levels -> levels.withLevelTimeLimit(200));
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
        assertThatThrownBy(() -> new Game(0, rules.withMazes(mazes -> mazes.withStartingPowerPill(-1))))
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
