package pacman.game;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.charset.StandardCharsets;
import java.util.EnumMap;
import java.util.List;
import java.util.zip.CRC32;
import mmneat.random.ResumableRandom;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;

/**
 * A game that describes every step as a line of a trace file, for recording and replaying.
 *
 * <p>A step is a JSON array: her request (U R D L, N neutral, - null); the ghosts' requests in ghost order, "." for no
 * entry, or "null" for no map; score, total time, level time, level, maze; her node, last move and lives; per ghost
 * node, edible time, lair time and last move; pills left, CRC-32 of the pills as 0 and 1, the power pills as 0 and 1;
 * time of the last reversal, points for the next ghost, flags of the step (1 she was eaten, 2 pill, 4 power pill, 8 to
 * 64 ghosts), game over, ghosts that require an action (-1 after the end), draws from the game's and from the shared
 * generator, and the situations drawn from the ghost locations, if any.
 */
final class TracedGame {

    static final ObjectMapper JSON = new ObjectMapper();
    private static final String CODES = "URDLN";

    final Game game;
    final GameRules rules;
    private final ResumableRandom shared;
    private final long drawsAtStart;
    private final ResumableRandom before = new ResumableRandom(0);
    private final ResumableRandom sharedBefore = new ResumableRandom(0);

    TracedGame(long seed, GameRules rules, long globalSeed) {
        this.rules = rules;
        shared = new ResumableRandom(globalSeed);
        game = new Game(seed, rules, shared);
        drawsAtStart = rawDraws(new ResumableRandom(globalSeed), shared);
    }

    long drawsAtStart() {
        return drawsAtStart;
    }

    static MOVE move(char code) {
        return code == '-' ? null : MOVE.values()[CODES.indexOf(code)];
    }

    static EnumMap<GHOST, MOVE> ghostMoves(String codes) {
        if (codes.equals("null")) {
            return null;
        }
        EnumMap<GHOST, MOVE> moves = new EnumMap<>(GHOST.class);
        for (GHOST ghost : GHOST.values()) {
            char code = codes.charAt(ghost.ordinal());
            if (code != '.') {
                moves.put(ghost, move(code));
            }
        }
        return moves;
    }

    /** Plays one step and describes it. */
    String step(char pacManMove, String ghostMoves) {
        before.continueAs(game.rnd);
        sharedBefore.continueAs(shared);
        int regret = game.getGhostRegret();
        game.advanceGame(move(pacManMove), ghostMoves(ghostMoves));
        StringBuilder line = new StringBuilder(200);
        line.append("[\"").append(pacManMove).append("\",\"").append(ghostMoves).append('"');
        append(line, game.getScore(), game.getTotalTime(), game.getCurrentLevelTime());
        append(line, game.getCurrentLevel(), game.getMazeIndex(), game.getPacmanCurrentNodeIndex());
        appendMove(line, game.getPacmanLastMoveMade());
        append(line, game.getPacmanNumberOfLivesRemaining());
        for (GHOST ghost : GHOST.values()) {
            line.append(",[").append(game.getGhostCurrentNodeIndex(ghost));
            append(line, game.getGhostEdibleTime(ghost), game.getGhostLairTime(ghost));
            appendMove(line, game.getGhostLastMoveMade(ghost));
            line.append(']');
        }
        append(line, game.getNumberOfActivePills());
        line.append(",\"")
                .append(pillChecksum())
                .append("\",\"")
                .append(powerPills())
                .append('"');
        append(line, game.getTimeOfLastGlobalReversal(), game.getGhostCurrentEdibleScore(), flags());
        append(line, game.gameOver() ? 1 : 0, required());
        append(line, rawDraws(before, game.rnd), rawDraws(sharedBefore, shared));
        appendSituations(line, game.getGhostRegret() - regret);
        return line.append(']').toString();
    }

    private static void append(StringBuilder line, long... values) {
        for (long value : values) {
            line.append(',').append(value);
        }
    }

    private static void appendMove(StringBuilder line, MOVE move) {
        line.append(",\"").append(CODES.charAt(move.ordinal())).append('"');
    }

    private String pillChecksum() {
        StringBuilder bits = new StringBuilder();
        for (int pill = 0; pill < game.getNumberOfPills(); pill++) {
            bits.append(game.isPillStillAvailable(pill) ? '1' : '0');
        }
        CRC32 crc = new CRC32();
        crc.update(bits.toString().getBytes(StandardCharsets.US_ASCII));
        return String.format("%08x", crc.getValue());
    }

    private String powerPills() {
        StringBuilder bits = new StringBuilder();
        for (int powerPill = 0; powerPill < game.getNumberOfPowerPills(); powerPill++) {
            bits.append(game.isPowerPillStillAvailable(powerPill) ? '1' : '0');
        }
        return bits.toString();
    }

    private int flags() {
        int flags =
                (game.wasPacManEaten() ? 1 : 0) | (game.wasPillEaten() ? 2 : 0) | (game.wasPowerPillEaten() ? 4 : 0);
        for (GHOST ghost : GHOST.values()) {
            flags |= game.wasGhostEaten(ghost) ? 8 << ghost.ordinal() : 0;
        }
        return flags;
    }

    private int required() {
        if (game.gameOver()) {
            return -1;
        }
        int required = 0;
        for (GHOST ghost : GHOST.values()) {
            required |= game.doesGhostRequireAction(ghost) ? 1 << ghost.ordinal() : 0;
        }
        return required;
    }

    /** Steps of the generator between two of its states. */
    private static long rawDraws(ResumableRandom from, ResumableRandom to) {
        ResumableRandom random = from.copy();
        for (int draws = 0; draws < 100_000; draws++) {
            if (random.bits() == to.bits()) {
                return draws;
            }
            random.nextInt();
        }
        throw new AssertionError("the generator did not come from its former state");
    }

    /** Appends the observations drawn from the ghost locations, after the numbers for edible times that ended. */
    private void appendSituations(StringBuilder line, int timeouts) {
        if (!rules.switches().contains(GameSwitch.LAIR_EXIT_DATABASE)) {
            return;
        }
        for (int timeout = 0; timeout < timeouts; timeout++) {
            sharedBefore.nextDouble();
        }
        if (sharedBefore.bits() == shared.bits()) {
            return;
        }
        line.append(",[");
        String separator = "";
        while (sharedBefore.bits() != shared.bits()) {
            line.append(separator).append(sharedBefore.nextInt(GhostLocations.SITUATIONS));
            separator = ",";
        }
        line.append(']');
    }

    /** Plays steps on a copy of the game, or on a game restored from its state, and describes the outcome. */
    ObjectNode probe(String kind, String method, String pacManMoves, String ghostMoves) {
        sharedBefore.continueAs(shared);
        shared.setSeed(5);
        Game branch = kind.equals("copy") ? game.copy() : restored();
        String[] requests = ghostMoves.split(" ");
        int done = 0;
        while (done < pacManMoves.length() && !branch.gameOver()) {
            advance(branch, method, move(pacManMoves.charAt(done)), ghostMoves(requests[done]));
            done++;
        }
        shared.continueAs(sharedBefore);
        return JSON.createObjectNode()
                .put("type", "probe")
                .put("kind", kind)
                .put("method", method)
                .put("pac", pacManMoves)
                .put("ghosts", ghostMoves)
                .put("done", done)
                .put("over", branch.gameOver() ? 1 : 0)
                .put("edibleScore", branch.getGhostCurrentEdibleScore())
                .put("state", branch.getGameState());
    }

    private Game restored() {
        GameRules plain = rules.without(TraceRules.setDuringGames()).withMazes(mazes -> mazes.withInitialMaze(0));
        Game restored = new Game(0, plain, shared);
        restored.setGameState(game.getGameState());
        return restored;
    }

    private static void advance(Game game, String method, MOVE pacMan, EnumMap<GHOST, MOVE> ghosts) {
        switch (method) {
            case "advanceGame" -> game.advanceGame(pacMan, ghosts);
            case "advanceGameWithoutReverse" -> game.advanceGameWithoutReverse(pacMan, ghosts);
            case "advanceGameWithForcedReverse" -> game.advanceGameWithForcedReverse(pacMan, ghosts);
            case "advanceGameWithPowerPillReverseOnly" -> game.advanceGameWithPowerPillReverseOnly(pacMan, ghosts);
            default -> throw new IllegalArgumentException(method);
        }
    }

    /** Returns the counters at the end, computed in the order of the trace. */
    ObjectNode end(int steps, int levels) {
        ObjectNode end = JSON.createObjectNode()
                .put("type", "end")
                .put("steps", steps)
                .put("gameOver", game.gameOver())
                .put("score", game.getScore());
        addAll(end.putArray("pillEatTimes"), game.getPillEatTimes());
        addAll(end.putArray("ghostEatTimes"), game.getGhostEatTimes());
        end.put("eatenPills", game.getEatenPills()).put("eatenGhosts", game.getEatenGhosts());
        ArrayNode each = end.putArray("specificEatenGhosts");
        for (int ghost = 0; ghost < Constants.NUM_GHOSTS; ghost++) {
            each.add(game.getEatenGhosts(ghost));
        }
        end.put("ghostReward", game.getGhostReward())
                .put("ghostRegret", game.getGhostRegret())
                .put("timeGhostReward", game.getTimeGhostReward())
                .put("timePillReward", game.getTimePillReward())
                .put("lureDistanceSum", game.getLureDistanceSum())
                .put("timeInDeadSpace", (int) game.getTimeInDeadSpace())
                .put("properlyEatenPowerPills", game.getProperlyEatenPowerPills())
                .put("improperlyEatenPowerPills", game.getImproperlyEatenPowerPills())
                .put("powerPillsEatenWhenGhostFar", game.getPowerPillsEatenWhenGhostFar())
                .put("avgGhostsPerPowerPill", text(game.averageGhostsEatenPerPowerPill(false)))
                .put("avgGhostsPerPowerPillPunished", text(game.averageGhostsEatenPerPowerPill(true)))
                .put("avgGhostsPerPowerPillAgain", text(game.averageGhostsEatenPerPowerPill(false)))
                .put("avgTimeToEatAllGhosts", text(game.averageTimeToEatAllGhostsAfterPowerPill()));
        ArrayNode scores = end.putArray("levelScores");
        for (int level = 0; level < levels; level++) {
            scores.add(text(game.getScore(level)));
        }
        return end;
    }

    private static String text(double value) {
        return Double.toString(value);
    }

    private static void addAll(ArrayNode array, List<Integer> values) {
        values.forEach(array::add);
    }
}
