package pacman.game;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.EnumMap;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import pacman.game.GameRules.Conventions;

/** Reads the rules of a trace file: parameters by their command line names, and switches. */
final class TraceRules {

    /** The names of the switches in a trace file that the original sets during a game. */
    private static final Map<GameSwitch, String> NAMES = new EnumMap<>(GameSwitch.class);

    static {
        NAMES.put(GameSwitch.EXIT_LAIR_EDIBLE, "exitLairEdible");
        NAMES.put(GameSwitch.END_ONLY_ON_TIME_LIMIT, "endOnlyOnTimeLimit");
        NAMES.put(GameSwitch.RANDOM_LAIR_EXIT, "randomLairExit");
        NAMES.put(GameSwitch.LAIR_EXIT_DATABASE, "lairExitDatabase");
        NAMES.put(GameSwitch.SIMULTANEOUS_LAIR_EXIT, "simultaneousLairExit");
        NAMES.put(GameSwitch.GHOSTS_START_OUTSIDE_LAIR, "ghostsStartOutsideLair");
        NAMES.put(GameSwitch.ONLY_ONE_LAIR_EXIT, "onlyOneLairExitAllowed");
        NAMES.put(GameSwitch.END_AFTER_GHOST_EATING_CHANCES, "endAfterGhostEatingChances");
        NAMES.put(GameSwitch.REMOVE_PILLS_NEAR_POWER_PILLS, "removePillsNearPowerPills");
        NAMES.put(GameSwitch.WITHOUT_PILLS, "noPills");
        NAMES.put(GameSwitch.WITHOUT_POWER_PILLS, "noPowerPills");
        NAMES.put(GameSwitch.END_AFTER_POWER_PILLS_EATEN, "endAfterPowerPillsEaten");
    }

    /** The names of the switches that a trace file lists among the parameters. */
    private static final Map<GameSwitch, String> PARAMETERS = new EnumMap<>(Map.of(
            GameSwitch.INFINITE_EDIBLE_TIME, "infiniteEdibleTime",
            GameSwitch.IMPRISONED_WHILE_EDIBLE, "imprisonedWhileEdible",
            GameSwitch.DIE_ON_IMPROPER_POWER_PILL_EATING, "dieOnImproperPowerPillEating"));

    private TraceRules() {}

    /** The switches that the original sets during a game, so that they are off in a restored game. */
    static Set<GameSwitch> setDuringGames() {
        return NAMES.keySet();
    }

    static GameRules read(JsonNode line, GhostLocations ghostLocations) {
        JsonNode params = line.get("params");
        JsonNode on = line.get("switches");
        Set<GameSwitch> switches = EnumSet.noneOf(GameSwitch.class);
        NAMES.forEach((each, written) -> setIf(on.get(written).asBoolean(), each, switches));
        PARAMETERS.forEach((each, written) -> setIf(params.get(written).asBoolean(), each, switches));
        setIf(!params.get("allowRandomGhostReversals").asBoolean(), GameSwitch.WITHOUT_RANDOM_REVERSALS, switches);
        return new GameRules(
                Conventions.valueOf(params.path("conventions").asText("MM_NEAT")),
                GameRules.Copies.CONTINUE_THE_GAME,
                MazeRules.MM_NEAT.withOnlyMaze(params.get("justMaze").asInt()),
                new LevelRules(
                        params.get("pacmanLives").asInt(),
                        params.get("pacManGainsLives").asBoolean(),
                        params.get("pacmanMaxLevel").asInt(),
                        params.get("getRemainingPills").asBoolean(),
                        params.get("pacManLevelTimeLimit").asInt(),
                        params.get("pacmanFatalTimeLimit").asBoolean()),
                new GhostRules(
                        params.get("numActiveGhosts").asInt(),
                        params.get("edibleTime").asInt(),
                        params.get("lairTime").asInt(),
                        ghostLocations),
                new PillRules(
                        params.get("preEatenPillPercentage").asDouble(),
                        params.get("closeGhostDistance").asInt(),
                        params.get("powerPillPunishmentRate").asDouble()),
                switches);
    }

    private static void setIf(boolean on, GameSwitch each, Set<GameSwitch> switches) {
        if (on) {
            switches.add(each);
        }
    }

    static void write(String name, GameRules rules, ObjectNode line) {
        line.put("type", "rules").put("name", name);
        line.putObject("params")
                .put("conventions", rules.conventions().name())
                .put("pacmanLives", rules.levels().lives())
                .put("pacManGainsLives", rules.levels().extraLife())
                .put("pacmanMaxLevel", rules.levels().maximumLevel())
                .put("pacManLevelTimeLimit", rules.levels().levelTimeLimit())
                .put("pacmanFatalTimeLimit", rules.levels().fatalTimeLimit())
                .put("getRemainingPills", rules.levels().creditForRemainingPills())
                .put("edibleTime", rules.ghosts().edibleTime())
                .put("lairTime", rules.ghosts().lairTime())
                .put("infiniteEdibleTime", rules.switches().contains(GameSwitch.INFINITE_EDIBLE_TIME))
                .put("imprisonedWhileEdible", rules.switches().contains(GameSwitch.IMPRISONED_WHILE_EDIBLE))
                .put("allowRandomGhostReversals", !rules.switches().contains(GameSwitch.WITHOUT_RANDOM_REVERSALS))
                .put("numActiveGhosts", rules.ghosts().activeGhosts())
                .put("preEatenPillPercentage", rules.pills().preEatenPillPortion())
                .put("powerPillPunishmentRate", rules.pills().powerPillPunishmentRate())
                .put(
                        "dieOnImproperPowerPillEating",
                        rules.switches().contains(GameSwitch.DIE_ON_IMPROPER_POWER_PILL_EATING))
                .put("closeGhostDistance", rules.pills().closeGhostDistance())
                .put("justMaze", rules.mazes().onlyMaze());
        ObjectNode on = line.putObject("switches");
        NAMES.forEach((each, written) -> on.put(written, rules.switches().contains(each)));
    }
}
