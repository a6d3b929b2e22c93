package pacman.game;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import pacman.game.GameRules.Conventions;

/** Rules as a trace file writes them: parameters by their command line names, and switches. */
final class TraceRules {

    private TraceRules() {}

    static GameRules read(JsonNode line, GhostLocations ghostLocations) {
        JsonNode params = line.get("params");
        JsonNode on = line.get("switches");
        return new GameRules.Builder()
                .conventions(Conventions.valueOf(params.path("conventions").asText("MM_NEAT")))
                .lives(params.get("pacmanLives").asInt())
                .extraLife(params.get("pacManGainsLives").asBoolean())
                .maximumLevel(params.get("pacmanMaxLevel").asInt())
                .levelTimeLimit(params.get("pacManLevelTimeLimit").asInt())
                .fatalTimeLimit(params.get("pacmanFatalTimeLimit").asBoolean())
                .creditForRemainingPills(params.get("getRemainingPills").asBoolean())
                .edibleTime(params.get("edibleTime").asInt())
                .lairTime(params.get("lairTime").asInt())
                .infiniteEdibleTime(params.get("infiniteEdibleTime").asBoolean())
                .imprisonedWhileEdible(params.get("imprisonedWhileEdible").asBoolean())
                .randomGhostReversals(params.get("allowRandomGhostReversals").asBoolean())
                .activeGhosts(params.get("numActiveGhosts").asInt())
                .preEatenPillPortion(params.get("preEatenPillPercentage").asDouble())
                .powerPillPunishmentRate(params.get("powerPillPunishmentRate").asDouble())
                .dieOnImproperPowerPillEating(
                        params.get("dieOnImproperPowerPillEating").asBoolean())
                .closeGhostDistance(params.get("closeGhostDistance").asInt())
                .onlyMaze(params.get("justMaze").asInt())
                .ghostLocations(ghostLocations)
                .switches(new GameSwitches(
                        on.get("exitLairEdible").asBoolean(),
                        on.get("endOnlyOnTimeLimit").asBoolean(),
                        on.get("randomLairExit").asBoolean(),
                        on.get("lairExitDatabase").asBoolean(),
                        on.get("simultaneousLairExit").asBoolean(),
                        on.get("ghostsStartOutsideLair").asBoolean(),
                        on.get("onlyOneLairExitAllowed").asBoolean(),
                        on.get("endAfterGhostEatingChances").asBoolean(),
                        on.get("removePillsNearPowerPills").asBoolean(),
                        on.get("noPills").asBoolean(),
                        on.get("noPowerPills").asBoolean(),
                        on.get("endAfterPowerPillsEaten").asBoolean()))
                .build();
    }

    static void write(String name, GameRules rules, ObjectNode line) {
        line.put("type", "rules").put("name", name);
        line.putObject("params")
                .put("conventions", rules.conventions().name())
                .put("pacmanLives", rules.lives())
                .put("pacManGainsLives", rules.extraLife())
                .put("pacmanMaxLevel", rules.maximumLevel())
                .put("pacManLevelTimeLimit", rules.levelTimeLimit())
                .put("pacmanFatalTimeLimit", rules.fatalTimeLimit())
                .put("getRemainingPills", rules.creditForRemainingPills())
                .put("edibleTime", rules.edibleTime())
                .put("lairTime", rules.lairTime())
                .put("infiniteEdibleTime", rules.infiniteEdibleTime())
                .put("imprisonedWhileEdible", rules.imprisonedWhileEdible())
                .put("allowRandomGhostReversals", rules.randomGhostReversals())
                .put("numActiveGhosts", rules.activeGhosts())
                .put("preEatenPillPercentage", rules.preEatenPillPortion())
                .put("powerPillPunishmentRate", rules.powerPillPunishmentRate())
                .put("dieOnImproperPowerPillEating", rules.dieOnImproperPowerPillEating())
                .put("closeGhostDistance", rules.closeGhostDistance())
                .put("justMaze", rules.onlyMaze());
        GameSwitches on = rules.switches();
        line.putObject("switches")
                .put("exitLairEdible", on.exitLairEdible())
                .put("endOnlyOnTimeLimit", on.endOnlyOnTimeLimit())
                .put("randomLairExit", on.randomLairExit())
                .put("lairExitDatabase", on.lairExitDatabase())
                .put("simultaneousLairExit", on.simultaneousLairExit())
                .put("ghostsStartOutsideLair", on.ghostsStartOutsideLair())
                .put("onlyOneLairExitAllowed", on.onlyOneLairExitAllowed())
                .put("endAfterGhostEatingChances", on.endAfterGhostEatingChances())
                .put("removePillsNearPowerPills", on.removePillsNearPowerPills())
                .put("noPills", on.withoutPills())
                .put("noPowerPills", on.withoutPowerPills())
                .put("endAfterPowerPillsEaten", on.endAfterPowerPillsEaten());
    }
}
