package pacman.game;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.function.ToIntBiFunction;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The questions about a ghost by its index, which is 0 to 3. */
class GhostIndexTest {

    private static final List<ToIntBiFunction<Game, Integer>> QUESTIONS = List.of(
            Game::ghostNode,
            Game::ghostEdibleTime,
            Game::ghostLairTime,
            Game::ghostLastMove,
            Game::getEatenGhosts,
            (game, ghost) -> game.isGhostThreat(ghost) ? 1 : 0);

    @ParameterizedTest
    @ValueSource(ints = {-1, 4, 5, 8, 100, Integer.MIN_VALUE, Integer.MAX_VALUE})
    void indexThatNoGhostHas_isRefused(int ghost) {
        Game game = new Game(0);
        for (ToIntBiFunction<Game, Integer> question : QUESTIONS) {
            assertThatThrownBy(() -> question.applyAsInt(game, ghost))
                    .isInstanceOf(IndexOutOfBoundsException.class)
                    .hasMessageContaining(Integer.toString(ghost));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3})
    void everyGhost_hasAnswers(int ghost) {
        Game game = new Game(0);
        Constants.GHOST name = Constants.GHOST.values()[ghost];
        assertThat(game.ghostNode(ghost)).isEqualTo(game.getGhostCurrentNodeIndex(name));
        assertThat(game.ghostLairTime(ghost)).isEqualTo(game.getGhostLairTime(name));
        assertThat(game.ghostEdibleTime(ghost)).isZero();
        assertThat(game.getEatenGhosts(ghost)).isZero();
        assertThat(game.ghostLastMove(ghost))
                .isEqualTo(game.getGhostLastMoveMade(name).ordinal());
    }
}
