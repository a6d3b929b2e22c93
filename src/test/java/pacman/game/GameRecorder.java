package pacman.game;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import mmneat.random.ResumableRandom;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;

/** Records this program's games between scripted players in the format of the golden traces. */
final class GameRecorder {

    private static final String MOVES = "URDLN";
    private static final int LONGEST = 500;
    private static final String[] METHODS = {
        "advanceGame",
        "advanceGameWithoutReverse",
        "advanceGameWithForcedReverse",
        "advanceGameWithPowerPillReverseOnly"
    };

    private final Consumer<String> lines;
    private final ResumableRandom random = new ResumableRandom(2012);

    GameRecorder(Consumer<String> lines) {
        this.lines = lines;
    }

    /** Returns random ghost locations in the form of the isolated task's recording. */
    static GhostLocations ghostLocations() {
        ResumableRandom random = new ResumableRandom(100);
        StringBuilder text = new StringBuilder();
        for (int line = 0; line < 16 * GhostLocations.SITUATIONS; line++) {
            text.append(line % 16 / 4).append(' ').append(line % 4);
            for (int ghost = 0; ghost < 4; ghost++) {
                text.append(' ').append(random.nextInt(1290));
            }
            text.append('\n');
        }
        try {
            return GhostLocations.read("random places", new StringReader(text.toString()));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Map<String, GameRules> allRules() {
        GameRules base = GameRules.blended();
        // The recorded games were made with copies that continue the game.
        GameRules.Copies continuing = GameRules.Copies.CONTINUE_THE_GAME;
        Map<String, GameRules> rules = new LinkedHashMap<>();
        rules.put("competition", GameRules.competition().withCopies(continuing));
        rules.put("mpmvsg", GameRules.mpmVsGhosts().withCopies(continuing));
        rules.put("fourmaze", GameRules.fourMaze());
        rules.put("blended", base);
        rules.put("interleaved", GameRules.interleaved());
        rules.put("pilltask", GameRules.isolatedPills());
        rules.put("ghosttask", GameRules.isolatedGhosts(0, ghostLocations()));
        rules.put("twoghosts", base.withGhosts(ghosts -> ghosts.withActiveGhosts(2)));
        rules.put("infinite", base.with(Set.of(GameSwitch.INFINITE_EDIBLE_TIME)));
        rules.put("noreversal", base.with(Set.of(GameSwitch.WITHOUT_RANDOM_REVERSALS)));
        rules.put("improper", base.with(Set.of(GameSwitch.DIE_ON_IMPROPER_POWER_PILL_EATING)));
        rules.put("punish", base.withPills(pills -> pills.withPowerPillPunishmentRate(0.3)));
        rules.put("preeaten", base.withPills(pills -> pills.withPreEatenPillPortion(0.8)));
        rules.put("onlymaze", base.withMazes(mazes -> mazes.withOnlyMaze(2)).withLevels(levels -> levels.withLives(3)));
        rules.put(
                "times",
                base.withGhosts(ghosts -> ghosts.withEdibleTime(333).withLairTime(77))
                        .withLevels(levels -> levels.withLives(5)));
        return rules;
    }

    void record() {
        allRules().forEach((name, rules) -> {
            ObjectNode line = TracedGame.JSON.createObjectNode();
            TraceRules.write(name, rules, line);
            lines.accept(line.toString());
            for (int game = 0; game < 3; game++) {
                record(name, rules, game);
            }
        });
    }

    private void record(String name, GameRules rules, int number) {
        int maze = rules.mazes().onlyMaze() >= 0 ? 0 : random.nextInt(4);
        int powerPill = rules.mazes().startingPowerPill() >= 0 ? number : -1;
        long seed = random.nextLong();
        long globalSeed = random.nextInt(1 << 30);
        GameRules own = rules.withMazes(mazes -> mazes.withInitialMaze(maze).withStartingPowerPill(powerPill));
        TracedGame traced = new TracedGame(seed, own, globalSeed);
        lines.accept(TracedGame.JSON
                .createObjectNode()
                .put("type", "game")
                .put("id", name + "-" + number)
                .put("seed", seed)
                .put("globalSeed", globalSeed)
                .put("initialMaze", maze)
                .put("startPowerPill", powerPill)
                .put("globalDrawsAtStart", traced.drawsAtStart())
                .put("state", traced.game.getGameState())
                .toString());
        int steps = 0;
        int level = 0;
        while (!traced.game.gameOver() && steps < LONGEST) {
            lines.accept(traced.step(pacManMove(traced.game, number), ghostMoves(traced.game, number)));
            steps++;
            if (steps % 100 == 0 || traced.game.getCurrentLevel() != level) {
                level = traced.game.getCurrentLevel();
                full(traced, steps);
                probe(traced);
            }
        }
        full(traced, steps);
        lines.accept(traced.end(steps, Math.min(4, traced.game.getCurrentLevel() + 1))
                .toString());
    }

    private void full(TracedGame traced, int steps) {
        lines.accept(TracedGame.JSON
                .createObjectNode()
                .put("type", "full")
                .put("step", steps)
                .put("state", traced.game.getGameState())
                .toString());
    }

    private void probe(TracedGame traced) {
        StringBuilder pacMan = new StringBuilder();
        StringBuilder ghosts = new StringBuilder();
        int length = 1 + random.nextInt(12);
        for (int i = 0; i < length; i++) {
            pacMan.append(MOVES.charAt(random.nextInt(5)));
            ghosts.append(i == 0 ? "" : " ").append(randomMoves("URDLN"));
        }
        String kind = random.nextInt(2) == 0 ? "copy" : "restore";
        lines.accept(traced.probe(kind, METHODS[random.nextInt(4)], pacMan.toString(), ghosts.toString())
                .toString());
    }

    /** Game 0: any move; game 1: pills, and edible ghosts; game 2: illegal and absent moves. */
    private char pacManMove(Game game, int number) {
        if (number == 0) {
            return MOVES.charAt(random.nextInt(5));
        }
        if (number == 2) {
            return "UURDDLNNLR-"
                    .charAt(random.nextInt(game.getTotalTime() < 200 && game.getTotalTime() > 10 ? 10 : 11));
        }
        int here = game.getPacmanCurrentNodeIndex();
        for (int ghost = 0; ghost < 4; ghost++) {
            if (game.ghostEdibleTime(ghost) > 10) {
                return code(game.getNextMoveTowardsTarget(here, game.ghostNode(ghost), DM.PATH));
            }
        }
        int[] targets = random.nextInt(4) == 0 ? game.getActivePowerPillsIndices() : game.getActivePillsIndices();
        int target = game.getClosestNodeIndexFromNodeIndex(here, targets, DM.PATH);
        return target < 0 ? 'N' : code(game.getNextMoveTowardsTarget(here, target, DM.PATH));
    }

    /** Game 0: after her; game 1: anything; game 2: no map, absent entries, null values. */
    private String ghostMoves(Game game, int number) {
        if (number == 1) {
            return randomMoves("URDL");
        }
        if (number == 2) {
            return random.nextInt(3) == 0 ? "null" : randomMoves("URDLN.-");
        }
        StringBuilder codes = new StringBuilder();
        for (GHOST ghost : GHOST.values()) {
            codes.append(
                    game.doesGhostRequireAction(ghost)
                            ? code(game.getApproximateNextMoveTowardsTarget(
                                    game.getGhostCurrentNodeIndex(ghost),
                                    game.getPacmanCurrentNodeIndex(),
                                    game.getGhostLastMoveMade(ghost),
                                    DM.values()[ghost.ordinal() % 3]))
                            : '.');
        }
        return codes.toString();
    }

    private String randomMoves(String codes) {
        StringBuilder moves = new StringBuilder();
        for (int ghost = 0; ghost < 4; ghost++) {
            moves.append(codes.charAt(random.nextInt(codes.length())));
        }
        return moves.toString();
    }

    private static char code(MOVE move) {
        return MOVES.charAt(move.ordinal());
    }
}
