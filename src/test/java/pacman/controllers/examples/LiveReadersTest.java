package pacman.controllers.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumMap;
import java.util.List;
import org.junit.jupiter.api.Test;
import pacman.controllers.Controller;
import pacman.controllers.ReadOnlyController;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.OutsideLegacy;

/** The rule that decides which controllers may read the live game. */
class LiveReadersTest {

    @Test
    void examplesThatOnlyRead_mayReadTheLiveGame() {
        List<Controller<EnumMap<GHOST, MOVE>>> teams = List.of(
                new AggressiveGhosts(),
                new BetterLegacy(),
                new ChaseFleeGhosts(),
                new DeterministicLegacy(),
                new Legacy(),
                new Legacy2TheReckoning(),
                new RandomGhosts(),
                new StarterGhosts(),
                new VeryRandomLegacy());
        assertThat(teams).allSatisfy(team -> assertThat(LiveReaders.of(team)).isPresent());
        List<Controller<MOVE>> players =
                List.of(new NearestPillPacMan(), new RandomNonRevPacMan(), new RandomPacMan(), new StarterPacMan());
        assertThat(players)
                .allSatisfy(player -> assertThat(LiveReaders.of(player)).isPresent());
    }

    @Test
    void otherControllers_getCopies_evenIfTheyExtendAnExample() {
        assertThat(LiveReaders.of(new PansyGhosts())).isEmpty();
        assertThat(LiveReaders.of(new NearestPillPacManVS())).isEmpty();
        Controller<EnumMap<GHOST, MOVE>> heir = new OutsideLegacy();
        assertThat(heir).isInstanceOf(ReadOnlyController.class);
        assertThat(LiveReaders.of(heir)).isEmpty();
    }
}
