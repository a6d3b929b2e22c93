package tour;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.HashMap;
import java.util.List;
import java.util.Random;
import pacman.controllers.Controller;
import pacman.game.Constants;
import pacman.game.Constants.DM;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.internal.AStar;
import pacman.game.internal.Ghost;
import pacman.game.internal.Maze;
import pacman.game.internal.Node;
import pacman.game.internal.PacMan;
import pacman.game.internal.PathsCache;

/** An entry in the manner of 2012 that asks the game everything that can be asked. */
public class TouringPacMan extends Controller<MOVE> {

    private int sum;

    @Override
    public MOVE getMove(Game game, long timeDue) {
        lastMove = MOVE.LEFT;
        boolean first = game.getTotalTime() == 0;
        state(game);
        nodes(game);
        paths(game);
        if (first) {
            advance(game);
            internals(game);
            mmNeat(game.copy());
        }
        int[] pills = game.getActivePillsIndices();
        int here = game.getPacmanCurrentNodeIndex();
        int pill = game.getClosestNodeIndexFromNodeIndex(here, pills, DM.PATH);
        return pill < 0 ? MOVE.NEUTRAL : game.getNextMoveTowardsTarget(here, pill, DM.PATH);
    }

    private void state(Game game) {
        if (game.gameOver() || game.wasPacManEaten() || game.wasPillEaten() || game.wasPowerPillEaten()) {
            sum++;
        }
        for (GHOST ghost : GHOST.values()) {
            sum += ghost.initialLairTime + game.getGhostCurrentNodeIndex(ghost) + game.getGhostEdibleTime(ghost);
            sum += game.getGhostLairTime(ghost) + game.getGhostLastMoveMade(ghost).opposite().ordinal();
            sum += game.isGhostEdible(ghost) || game.wasGhostEaten(ghost) || game.doesGhostRequireAction(ghost) ? 1 : 0;
        }
        sum += game.getGhostEdibleTime(GHOST.PINKY) + game.getGhostEdibleTime(GHOST.INKY) + MOVE.DOWN.ordinal();
        sum += game.getNumGhostsEaten() + game.getTimeOfLastGlobalReversal() + game.getMazeIndex();
        sum += game.getCurrentLevel() + game.getNumberOfNodes() + game.getGhostCurrentEdibleScore();
        sum += game.getGhostInitialNodeIndex() + game.getPacmanLastMoveMade().ordinal();
        sum += game.getPacmanNumberOfLivesRemaining() + game.getScore() + game.getCurrentLevelTime();
        sum += game.getNumberOfPills() + game.getNumberOfPowerPills();
        sum += game.getNumberOfActivePills() + game.getNumberOfActivePowerPills();
        sum += game.getActivePowerPillsIndices().length + game.getJunctionIndices().length;
        sum += game.isPillStillAvailable(0) || game.isPowerPillStillAvailable(0) ? 1 : 0;
        switch (game.getPacmanCurrentNodeIndex()) {
            case Constants.PILL:
            case Constants.POWER_PILL:
            case Constants.LEVEL_LIMIT:
                sum++;
                break;
            default:
                break;
        }
    }

    private void nodes(Game game) {
        int here = game.getPacmanCurrentNodeIndex();
        MOVE last = game.getPacmanLastMoveMade();
        sum += game.getNodeXCood(here) + game.getNodeYCood(here) + game.getNodeXCoord(here) + game.getNodeYCoord(here);
        sum += game.getPillIndex(here) + game.getPowerPillIndex(here) + (game.isJunction(here) ? 1 : 0);
        sum += game.getPillIndices().length + game.getPowerPillIndices().length;
        sum += game.getPossibleMoves(here).length + game.getPossibleMoves(here, last).length;
        int[] neighbours = game.getNeighbouringNodes(here);
        sum += game.getNeighbouringNodes(here, last).length + game.getNeighbour(here, last);
        sum += game.getMoveToMakeToReachDirectNeighbour(here, neighbours[0]).ordinal();
    }

    private void paths(Game game) {
        int here = game.getPacmanCurrentNodeIndex();
        int there = game.getPowerPillIndices()[0];
        MOVE last = game.getPacmanLastMoveMade();
        sum += game.getShortestPathDistance(here, there) + game.getManhattanDistance(here, there);
        sum += (int) (game.getEuclideanDistance(here, there) + game.getDistance(here, there, DM.EUCLID));
        sum += (int) game.getDistance(here, there, last, DM.PATH);
        sum += game.getFarthestNodeIndexFromNodeIndex(here, game.getPillIndices(), DM.MANHATTAN);
        List<MOVE> moves = new ArrayList<MOVE>();
        moves.add(game.getNextMoveAwayFromTarget(here, there, DM.valueOf("PATH")));
        moves.add(game.getApproximateNextMoveTowardsTarget(here, there, last, DM.PATH));
        moves.add(game.getApproximateNextMoveAwayFromTarget(here, there, last, DM.PATH));
        moves.add(game.getNextMoveTowardsTarget(here, there, last, DM.PATH));
        moves.add(game.getNextMoveAwayFromTarget(here, there, last, DM.PATH));
        sum += moves.size() + DM.values().length + MOVE.valueOf("UP").ordinal() + GHOST.valueOf("SUE").ordinal();
        sum += game.getAStarPath(here, there, last).length + game.getShortestPath(here, there).length;
        sum += game.getApproximateShortestPath(here, there, last).length;
        sum += game.getShortestPath(here, there, last).length + game.getShortestPathDistance(here, there, last);
        sum += game.getApproximateShortestPathDistance(here, there, last);
    }

    private static void advance(Game game) {
        EnumMap<GHOST, MOVE> moves = new EnumMap<GHOST, MOVE>(GHOST.class);
        Game ahead = game.copy();
        ahead.advanceGame(MOVE.LEFT, moves);
        ahead.advanceGameWithoutReverse(MOVE.LEFT, moves);
        ahead.advanceGameWithForcedReverse(MOVE.LEFT, moves);
        ahead.advanceGameWithPowerPillReverseOnly(MOVE.LEFT, moves);
        ahead.updatePacMan(MOVE.RIGHT);
        ahead.updateGhosts(moves);
        ahead.updateGame();
        ahead.updateGhostsWithoutReverse(moves);
        ahead.updateGhostsWithForcedReverse(moves);
        ahead.updateGame(true, true, true, true, true);
        Game other = new Game(new Random(1).nextLong(), 1);
        other.setGameState(ahead.getGameState());
        if (!other.getGameState().equals(ahead.getGameState())) {
            throw new IllegalStateException("a state is not restored");
        }
    }

    private void internals(Game game) {
        Maze maze = game.getCurrentMaze();
        sum += maze.shortestPathDistances.length + maze.pillIndices.length + maze.powerPillIndices.length;
        sum += maze.junctionIndices.length + maze.initialPacManNodeIndex + maze.lairNodeIndex;
        sum += maze.initialGhostNodeIndex + maze.name.length() + new Maze(1).graph.length;
        AStar astar = maze.astar;
        MOVE last = game.getPacmanLastMoveMade();
        sum += astar.computePathsAStar(0, 5, MOVE.RIGHT, game).length + astar.computePathsAStar(0, 5, game).length;
        AStar own = new AStar();
        own.createGraph(maze.graph);
        own.resetGraph();
        Node node = maze.graph[game.getPacmanCurrentNodeIndex()];
        sum += node.x + node.y + node.nodeIndex + node.pillIndex + node.powerPillIndex + node.numNeighbouringNodes;
        sum += node.neighbourhood.size() + node.allPossibleMoves.get(last).length;
        sum += node.allNeighbouringNodes.get(last).length + node.allNeighbourhoods.get(last).size();
        sum += new Node(0, 4, 4, -1, -1, new int[] {-1, 1, -1, -1}).x;
        PathsCache paths = Game.caches[game.getMazeIndex()];
        HashMap<Integer, Integer> numbers = paths.junctionIndexConverter;
        sum += numbers.size() + paths.getPathFromA2B(0, 50).length + paths.getPathFromA2B(0, 50, MOVE.RIGHT).length;
        sum += paths.getPathDistanceFromA2B(0, 50, MOVE.RIGHT);
        if (new PathsCache(2).game == game) {
            sum++;
        }
        PacMan pacMan = new PacMan(0, MOVE.LEFT, 3, false).copy();
        Ghost ghost = new Ghost(GHOST.SUE, 0, 0, 0, MOVE.NEUTRAL).copy();
        sum += pacMan.currentNodeIndex + pacMan.numberOfLivesRemaining + pacMan.lastMoveMade.ordinal();
        sum += (pacMan.hasReceivedExtraLife ? 1 : 0) + ghost.currentNodeIndex + ghost.edibleTime + ghost.lairTime;
        sum += ghost.type.ordinal() + ghost.lastMoveMade.ordinal();
        sum += Constants.nodeNames.length + Constants.distNames.length + Constants.mazeNames.length;
        sum += Constants.pathImages.length();
    }

    /** What MM-NEAT added to the game. */
    private void mmNeat(Game game) {
        sum += game.rnd.nextInt(5) + game.levelTimeLeft() + game.newEdibleTime() + (game.isGhostThreat(0) ? 1 : 0);
        sum += game.getThreatGhostLocations().length + game.getNumEdibleGhosts() + game.getGhostReward();
        sum += game.getTimeGhostReward() + game.getTimePillReward() + game.getGhostRegret() + game.getEatenGhosts();
        sum += game.getEatenGhosts(0) + game.getEatenPills() + game.getProperlyEatenPowerPills();
        sum += game.getImproperlyEatenPowerPills() + game.getEatenPowerPills();
        sum += game.getPowerPillsEatenWhenGhostFar() + (int) (game.getLureDistanceSum() + game.getTimeInDeadSpace());
        Game fresh = new Game(3);
        sum += fresh.getPillEatTimes().size() + fresh.getGhostEatTimes().size() + (int) fresh.getScore(0);
        sum += (int) fresh.averageGhostsEatenPerPowerPill(true);
        sum += (int) fresh.averageTimeToEatAllGhostsAfterPowerPill();
        fresh.setSimultaneousLairExit(true);
        fresh.setRandomLairExit(true);
        fresh.setExitLairEdible(true);
        fresh.setLairExitDatabase(false);
        fresh.setGhostsStartOutsideLair(true);
        fresh.setOnlyOneLairExitAllowed(false);
        fresh.setEndOnlyOnTimeLimit(false);
        fresh.setEndAfterPowerPillsEaten(false);
        fresh.setEndAfterGhostEatingChances(false);
        fresh.setRemovePillsNearPowerPills(true);
        fresh.playWithoutPills();
        fresh.playWithoutPowerPills();
        fresh.playWithPills();
        fresh.playWithPowerPills();
    }
}
