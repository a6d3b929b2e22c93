package pacman.maze;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.IntStream;
import mmneat.random.ResumableRandom;
import org.junit.jupiter.api.Test;
import pacman.game.Constants.DM;
import pacman.game.Game;

class PillOrderTest {

    /** The reference form: the game's own query over all present pills and power pills. */
    private static int nearestByQuery(Game game, int node) {
        int[] present = IntStream.concat(
                        IntStream.of(game.getActivePillsIndices()), IntStream.of(game.getActivePowerPillsIndices()))
                .toArray();
        return game.getClosestNodeIndexFromNodeIndex(node, present, DM.PATH);
    }

    @Test
    void nearestPill_isThatOfTheGeneralQuery_inRandomStatesOfAllMazes() {
        ResumableRandom random = new ResumableRandom(1);
        for (int maze = 0; maze < 4; maze++) {
            Game game = new Game(0, maze);
            String[] fields = game.getGameState().split(",");
            int pillsField = IntStream.range(0, fields.length)
                    .filter(i -> fields[i].length() == game.getNumberOfPills())
                    .findFirst()
                    .orElseThrow();
            for (int round = 0; round < 60; round++) {
                double portion = round / 59.0;
                fields[pillsField] = randomBits(random, game.getNumberOfPills(), portion);
                fields[pillsField + 1] = randomBits(random, game.getNumberOfPowerPills(), portion);
                game.setGameState(String.join(",", fields));
                for (int node = 0; node < game.getNumberOfNodes(); node += 1 + random.nextInt(7)) {
                    assertThat(game.nearestPill(node)).isEqualTo(nearestByQuery(game, node));
                }
                int lair = game.getNumberOfNodes() - 1;
                assertThat(game.nearestPill(lair)).isEqualTo(nearestByQuery(game, lair));
            }
        }
    }

    private static String randomBits(ResumableRandom random, int count, double portion) {
        StringBuilder bits = new StringBuilder();
        for (int i = 0; i < count; i++) {
            bits.append(random.nextDouble() < portion ? '1' : '0');
        }
        return bits.toString();
    }
}
