package pacman.game;

import static pacman.game.GameState.EDIBLE;
import static pacman.game.GameState.GHOSTS;
import static pacman.game.GameState.LAIR;
import static pacman.game.GameState.NO_MOVE;
import static pacman.game.GameState.POSE;

import pacman.game.GameRules.Conventions;
import pacman.maze.MazeGraph;
import pacman.maze.MazePoses;

/**
 * The rules of one game step, in the order in which {@link Game#advanceGame} applies them; step 9 is {@link LairExits}.
 * A step allocates nothing, except where a ghost that would leave the lair starts the next level instead ({@link
 * GameSwitch#ONLY_ONE_LAIR_EXIT}).
 *
 * <p>Source: docs/specification/simulator.md, sections 2.3 to 2.7.
 */
final class GameStep {

    /** The rule for reversals of ghosts in a step; {@code advanceGame} and its variants pass it. */
    enum Reversal {
        /** Ghosts reverse at random and after a power pill. */
        NORMAL,
        /** Ghosts never reverse. */
        NEVER,
        /** Ghosts reverse. */
        FORCED
    }

    private static final int ALL_GHOSTS = (1 << GHOSTS) - 1;
    private static final int NO_GHOST = 0;

    /** Path distance beyond which a threat does not count as lured. */
    private static final int LURE_DISTANCE = 200;

    private GameStep() {}

    /** Steps 1 to 4: Ms. Pac-Man moves and eats a pill on her node. */
    static void updatePacMan(GameState state, int request) {
        state.minGhostDistance--;
        int pose = state.pacManPose;
        int stay = MazePoses.turned(pose, NO_MOVE);
        int straight = state.poses.onward(pose);
        int asked = state.poses.onward(MazePoses.turned(pose, request));
        pose = either(asked, either(straight, stay));
        state.pacManPose = pose;
        state.pillEaten = false;
        state.powerPillEaten = false;
        int node = MazePoses.node(pose);
        int pill = state.graph.pillPosition(node);
        if (state.hasPill(pill)) {
            eatPill(state, pill);
        } else {
            int powerPill = state.graph.powerPillNumber(node);
            if (powerPill >= 0 && (state.powerPills >>> powerPill & 1) != 0) {
                eatPowerPill(state, powerPill);
            }
        }
        if (!state.pillEaten && !state.powerPillEaten) {
            state.timeInDeadSpace++;
        }
    }

    /** Returns the first of two poses, or the second if there is no first, without a branch. */
    private static int either(int first, int second) {
        int missing = first >> 31;
        return first & ~missing | second & missing;
    }

    private static void eatPill(GameState state, int pill) {
        state.pillEaten = true;
        state.eatenPills++;
        state.score += Constants.PILL;
        state.removePill(pill);
        state.timePillReward += state.rules.levels().levelTimeLimit() - state.levelTime;
        if (state.history != null) {
            state.history.pillEatTimes.add(state.totalTime);
        }
    }

    private static void eatPowerPill(GameState state, int powerPill) {
        int threats = 0;
        int nearest = Integer.MAX_VALUE;
        int lure = 0;
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            if (state.isThreat(ghost)) {
                int distance = distanceToGhost(state, ghost);
                threats++;
                nearest = Math.min(nearest, distance);
                lure += LURE_DISTANCE - Math.min(distance, LURE_DISTANCE);
            }
        }
        notePowerPill(state, threats);
        state.score += Constants.POWER_PILL;
        if (threats == state.rules.ghosts().activeGhosts()) {
            state.properlyEatenPowerPills++;
            if (nearest > state.rules.pills().closeGhostDistance()) {
                state.powerPillsEatenWhenGhostFar++;
            }
        } else if (state.has(GameSwitch.DIE_ON_IMPROPER_POWER_PILL_EATING)) {
            state.gameOver = true;
            return;
        } else {
            state.improperlyEatenPowerPills++;
            state.ghostRegret += state.rules.ghosts().activeGhosts() - threats;
        }
        state.lureDistance += lure;
        state.eatenPills++;
        state.ghostMultiplier = 1;
        state.powerPills &= ~(1L << powerPill);
        state.powerPillEaten = true;
        if (state.history != null) {
            state.history.pillEatTimes.add(state.totalTime);
        }
        int edibleTime = state.newEdibleTime();
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            state.ghosts[EDIBLE + ghost] = state.ghosts[LAIR + ghost] == 0 ? edibleTime : 0;
        }
    }

    private static void notePowerPill(GameState state, int threats) {
        state.timeOfLastPowerPill = state.totalTime;
        if (state.history == null) {
            return;
        }
        if (threats == 0 || state.isAnyEdible()) {
            state.history.timesToEatAll.add(GameHistory.NEVER);
        }
        state.history.ghostsPerPowerPill.add(0);
    }

    /**
     * Steps 6 and 7: ghosts reverse, or move.
     *
     * @param requests requested moves, encoded as {@link GhostMoves}
     * @return bit set of the ghosts that moved in step 7
     */
    static int updateGhosts(GameState state, int requests, Reversal reversal) {
        state.minGhostDistance--;
        if (reversal != Reversal.NEVER && reverse(state, reversal == Reversal.FORCED) || reversal == Reversal.FORCED) {
            return NO_GHOST;
        }
        return moveGhosts(state, requests);
    }

    private static boolean reverse(GameState state, boolean forced) {
        boolean event =
                !state.has(GameSwitch.WITHOUT_RANDOM_REVERSALS) && state.random.nextDouble() < Constants.GHOST_REVERSAL;
        if (!forced && !event && !state.powerPillEaten || state.levelTime <= 1) {
            return false;
        }
        boolean reversed = false;
        int[] ghosts = state.ghosts;
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            int pose = ghosts[POSE + ghost];
            int move = MazePoses.move(pose);
            if (ghosts[LAIR + ghost] == 0 && move != NO_MOVE) {
                ghosts[POSE + ghost] = state.poses.onward(MazePoses.turned(pose, MazeGraph.opposite(move)));
                reversed = true;
            }
        }
        if (reversed) {
            state.timeOfLastReversal = state.totalTime;
        }
        return reversed;
    }

    /*
     * In most steps most ghosts are in a corridor and have no choice. They move first, in a loop without calls that the
     * compiler unrolls. They draw no random numbers, so the order of the other ghosts' draws does not change.
     */
    private static int moveGhosts(GameState state, int requests) {
        int[] ghosts = state.ghosts;
        int others = 0;
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            int next = state.poses.onward(ghosts[POSE + ghost]);
            boolean isFree = (ghosts[LAIR + ghost] | ghosts[EDIBLE + ghost]) == 0;
            if (isFree && next >= 0 && GhostMoves.of(requests, ghost) == NO_MOVE) {
                ghosts[POSE + ghost] = next;
            } else {
                others |= 1 << ghost;
            }
        }
        int moved = ALL_GHOSTS;
        for (int left = others; left != 0; left &= left - 1) {
            int ghost = Integer.numberOfTrailingZeros(left);
            if (state.mayMove(ghost)) {
                ghosts[POSE + ghost] = moveGhost(state, ghosts[POSE + ghost], GhostMoves.of(requests, ghost));
            } else {
                moved &= ~(1 << ghost);
            }
        }
        return moved;
    }

    /** Moves a ghost as requested if that is possible without turning back, else straight on, else at random. */
    private static int moveGhost(GameState state, int pose, int request) {
        int last = MazePoses.move(pose);
        int back = last == NO_MOVE ? NO_MOVE : MazeGraph.opposite(last);
        int asked = request == back ? -1 : state.poses.onward(MazePoses.turned(pose, request));
        if (asked >= 0) {
            return asked;
        }
        int straight = state.poses.onward(pose);
        if (straight >= 0) {
            return straight;
        }
        int open = state.graph.openDirections(MazePoses.node(pose)) & ~(1 << back);
        return state.poses.onward(MazePoses.turned(pose, drawMove(state, open)));
    }

    /** Draws one of several directions. A number is drawn even if there is only one direction. */
    private static int drawMove(GameState state, int directions) {
        int left = directions;
        for (int draw = state.random.nextInt(Integer.bitCount(directions)); draw > 0; draw--) {
            left &= left - 1;
        }
        return Integer.numberOfTrailingZeros(left);
    }

    /** Step 8: Ms. Pac-Man meets ghosts, and edible times decrease. */
    static void updateMeetings(GameState state) {
        state.pacManEaten = false;
        state.ghostsEaten = 0;
        if (state.minGhostDistance <= Constants.EAT_DISTANCE && !meetGhosts(state)) {
            return;
        }
        if (state.isAnyEdible()) {
            runEdibleTimes(state);
        }
    }

    /** Returns whether she survives. */
    private static boolean meetGhosts(GameState state) {
        int nearest = Integer.MAX_VALUE;
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            int distance = leastDistanceToGhost(state, ghost);
            if (distance <= Constants.EAT_DISTANCE) {
                distance = distanceToGhost(state, ghost);
            }
            if (distance < 0) {
                continue;
            }
            if (distance > Constants.EAT_DISTANCE) {
                nearest = Math.min(nearest, distance);
            } else if (state.ghosts[EDIBLE + ghost] == 0) {
                eatPacMan(state);
                return false;
            } else {
                eatGhost(state, ghost);
            }
        }
        state.minGhostDistance = nearest;
        return true;
    }

    private static void runEdibleTimes(GameState state) {
        for (int ghost = 0; ghost < GHOSTS; ghost++) {
            if (state.ghosts[EDIBLE + ghost] > 0 && --state.ghosts[EDIBLE + ghost] == 0) {
                endEdibleTime(state, ghost);
            }
        }
    }

    private static int distanceToGhost(GameState state, int ghost) {
        return state.tables.distances().between(state.ghostNode(ghost), state.pacManNode());
    }

    /**
     * Returns a lower bound of the distance from coordinates only, because the large table of distances is rarely in
     * the cache.
     */
    private static int leastDistanceToGhost(GameState state, int ghost) {
        return state.graph.leastDistance(state.ghostNode(ghost), state.pacManNode());
    }

    private static void eatGhost(GameState state, int ghost) {
        int[] ghosts = state.ghosts;
        state.score += Constants.GHOST_EAT_SCORE * state.ghostMultiplier;
        state.eatenGhosts++;
        ghosts[GameState.EATEN + ghost]++;
        state.ghostReward += state.ghostMultiplier;
        state.timeGhostReward += ghosts[EDIBLE + ghost] * state.ghostMultiplier;
        state.ghostMultiplier *= 2;
        ghosts[EDIBLE + ghost] = 0;
        ghosts[LAIR + ghost] = state.scaledTime(state.rules.ghosts().lairTime());
        ghosts[POSE + ghost] = MazePoses.of(state.graph.lair(), NO_MOVE);
        state.ghostsEaten |= 1 << ghost;
        if (state.history != null) {
            state.history.ghostEatTimes.add(state.totalTime);
            if (!state.has(GameSwitch.EXIT_LAIR_EDIBLE)) {
                state.history.ghostEaten(
                        state.rules.ghosts().activeGhosts(),
                        !state.isAnyEdible(),
                        state.totalTime - state.timeOfLastPowerPill);
            }
        }
    }

    private static void eatPacMan(GameState state) {
        state.ghostRegret += state.edibleGhosts();
        state.lives--;
        state.pacManEaten = true;
        if (state.lives <= 0) {
            state.gameOver = true;
        } else {
            LevelStart.resetPositions(state);
        }
    }

    private static void endEdibleTime(GameState state, int ghost) {
        if (state.has(GameSwitch.INFINITE_EDIBLE_TIME)) {
            state.ghosts[EDIBLE + ghost] = 2;
            return;
        }
        state.ghostRegret++;
        // The original draws even at rate 0, from the generator of the evolution. Without that generator the draw has
        // no effect.
        double rate = state.rules.pills().powerPillPunishmentRate();
        if ((state.shared != null || rate > 0) && state.taskRandom().nextDouble() < rate) {
            state.gameOver = true;
        }
        if (state.history != null && !state.isAnyEdible()) {
            state.history.timesToEatAll.add(GameHistory.NEVER);
        }
    }

    /** Step 10: an extra life, once per game. */
    static void updateExtraLife(GameState state) {
        if (state.rules.levels().extraLife() && !state.extraLifeReceived && state.score >= Constants.EXTRA_LIFE_SCORE) {
            state.extraLifeReceived = true;
            state.lives++;
        }
    }

    /** Step 12: the end of the game by its time limit, and the end of the level. */
    static void endLevelOrGame(GameState state) {
        if (state.totalTime + 1 > Constants.MAX_TIME) {
            state.gameOver = true;
            state.score += state.lives * Constants.AWARD_LIFE_LEFT;
            if (state.rules.conventions() == Conventions.COMPETITION) {
                return;
            }
        }
        boolean outOfTime = !state.rules.levels().fatalTimeLimit()
                && state.levelTime >= state.rules.levels().levelTimeLimit();
        if (outOfTime || isCleared(state)) {
            LevelStart.next(state);
        }
    }

    private static boolean isCleared(GameState state) {
        if (state.powerPills != 0 || state.has(GameSwitch.END_ONLY_ON_TIME_LIMIT)) {
            return false;
        }
        if (state.has(GameSwitch.END_AFTER_POWER_PILLS_EATEN)) {
            return true;
        }
        boolean chances = state.has(GameSwitch.END_AFTER_GHOST_EATING_CHANCES);
        if (state.pillsLeft > 0 && !chances) {
            return false;
        }
        return !(chances || state.has(GameSwitch.WITHOUT_PILLS)) || !state.isAnyEdible();
    }
}
