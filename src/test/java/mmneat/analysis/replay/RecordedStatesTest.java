package mmneat.analysis.replay;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import org.junit.jupiter.api.Test;
import pacman.Executor;
import pacman.Recording;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.StarterPacMan;
import pacman.game.Game;
import pacman.game.GameRules;

class RecordedStatesTest {

    private static final ReplayTitle TITLE = new ReplayTitle("game.txt", "recorded game");

    @Test
    void replay_hasTheStatesOfTheRecording_andNoNetwork() throws IOException {
        Game game = new Game(3, GameRules.competition());
        String text = new Executor().runGameRecorded(new StarterPacMan(), new Legacy(), game);
        Recording recording = new Recording(text.lines().toList());

        Replay replay = RecordedStates.replay(recording, GameRules.competition(), TITLE);

        assertThat(replay.finalScore()).isEqualTo(game.getScore());
        assertThat(replay.steps()).isEqualTo(recording.states().size() - 1);
        JsonNode json = new ObjectMapper().readTree(replay.json());
        assertThat(json.at("/network/inputs")).isEmpty();
        assertThat(json.at("/outcomes/0/text").asText()).startsWith("End of the recording");
        assertThat(ReplayPage.html(replay)).contains("game.txt");
    }
}
