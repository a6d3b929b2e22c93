package mmneat.experiment.parameters;

import java.lang.reflect.RecordComponent;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import java.util.stream.Stream;
import mmneat.experiment.PlainText;
import mmneat.experiment.UserError;
import mmneat.mspacman.CheckedParts;
import mmneat.mspacman.GameSettings;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.NetworkSettings;
import mmneat.mspacman.TaskVersion;
import mmneat.mspacman.modules.ModuleDivision;
import mmneat.mspacman.modules.ModuleDivisions;
import mmneat.mspacman.sensors.Sensor;
import mmneat.mspacman.sensors.SensorGroup;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.neat.network.ModuleArbitration;
import org.jspecify.annotations.Nullable;
import pacman.controllers.NewGhostController;
import pacman.controllers.examples.AggressiveGhosts;
import pacman.controllers.examples.BetterLegacy;
import pacman.controllers.examples.ChaseFleeGhosts;
import pacman.controllers.examples.DeterministicLegacy;
import pacman.controllers.examples.Legacy;
import pacman.controllers.examples.Legacy2TheReckoning;
import pacman.controllers.examples.RandomGhosts;
import pacman.controllers.examples.StarterGhosts;
import pacman.controllers.examples.VeryRandomLegacy;
import pacman.game.GameRules;
import pacman.game.GameSwitch;
import pacman.game.GhostLocations;
import pacman.game.GhostRules;
import pacman.game.LevelRules;
import pacman.game.MazeRules;
import pacman.game.PillRules;
import pacman.maze.Mazes;

/**
 * The parameters that the Ms.&nbsp;Pac-Man task reads. Each component has the name of a parameter; the catalogue
 * ({@code parameters.csv}, {@link ParameterCatalogue}) describes it. Some are also components of {@link
 * EvolutionParameters}, whose comment says which and why.
 */
record GameParameters(
        int trials,
        boolean deterministic,
        String ghostTeam,
        String pacmanInputOutputMediator,
        String pacmanMultitaskScheme,
        int multitaskModes,
        int pacmanLives,
        boolean pacManGainsLives,
        int pacmanMaxLevel,
        int pacManLevelTimeLimit,
        boolean pacmanFatalTimeLimit,
        int edibleTime,
        int lairTime,
        int numActiveGhosts,
        int initialMaze,
        int justMaze,
        boolean allowRandomGhostReversals,
        boolean infiniteEdibleTime,
        int closeGhostDistance,
        double preEatenPillPercentage,
        double powerPillPunishmentRate,
        boolean dieOnImproperPowerPillEating,
        boolean getRemainingPills,
        boolean exitLairEdible,
        boolean endOnlyOnTimeLimit,
        boolean simultaneousLairExit,
        boolean endAfterGhostEatingChances,
        boolean removePillsNearPowerPills,
        boolean noPills,
        boolean noPowerPills,
        int junctionsToSense,
        boolean incoming,
        boolean trapped,
        boolean eTimeVsGDis,
        boolean specific,
        boolean specificGhostProximityOrder,
        boolean specificGhostEdibleThreatSplit,
        int smallStepSimDepth,
        boolean highLevel,
        String ownSensors,
        String objectives,
        String jar,
        boolean softmaxModeSelection,
        double softmaxTemperature,
        int disabledMode,
        double preferenceNeuronFatigueUnit,
        double preferenceNeuronDecay,
        boolean weightedAverageModeAggregation) {

    /** The only supported kind of sensors and outputs: the network is activated once per direction. */
    private static final String MEDIATOR = "IICheckEachDirectionMediator";

    private static final Map<String, Supplier<NewGhostController>> TEAMS = Map.of(
            "Legacy", Legacy::new,
            "Legacy2TheReckoning", Legacy2TheReckoning::new,
            "AggressiveGhosts", AggressiveGhosts::new,
            "BetterLegacy", BetterLegacy::new,
            "ChaseFleeGhosts", ChaseFleeGhosts::new,
            "DeterministicLegacy", DeterministicLegacy::new,
            "RandomGhosts", RandomGhosts::new,
            "StarterGhosts", StarterGhosts::new,
            "VeryRandomLegacy", VeryRandomLegacy::new);

    /** The names of parameters that only the game uses: rules of the game, sensors and outputs. */
    static List<String> ofTheGameAlone() {
        Set<String> shared = Set.of("multitaskModes", "jar");
        return Stream.concat(
                        Stream.of(GameParameters.class.getRecordComponents()).map(RecordComponent::getName),
                        Stream.of("imprisonedWhileEdible"))
                .filter(name -> !shared.contains(name))
                .toList();
    }

    /** @param locations where ghosts appear in the isolated version; null for the others */
    MsPacManTaskSettings settings(TaskVersion version, @Nullable GhostLocations locations) {
        if (!pacmanInputOutputMediator.equals(MEDIATOR)) {
            throw new UserError("pacmanInputOutputMediator=" + pacmanInputOutputMediator + ": must be " + MEDIATOR);
        }
        OwnClasses classes = new OwnClasses(jar);
        GameRules rules = rules(version, locations);
        return new MsPacManTaskSettings(
                new GameSettings(version, trials, rules, ghosts(classes), deterministic),
                new NetworkSettings(sensors(version, classes), division(classes), arbitration()),
                ObjectiveParameter.read(objectives, classes, version, rules));
    }

    private GameRules rules(TaskVersion version, @Nullable GhostLocations locations) {
        return new GameRules(
                GameRules.Conventions.MM_NEAT,
                GameRules.Copies.CONTINUE_THE_GAME,
                new MazeRules(Mazes.standard(), initialMaze, justMaze, -1),
                new LevelRules(
                        pacmanLives,
                        pacManGainsLives,
                        pacmanMaxLevel,
                        getRemainingPills,
                        pacManLevelTimeLimit,
                        pacmanFatalTimeLimit),
                new GhostRules(numActiveGhosts, edibleTime, lairTime, locations),
                new PillRules(preEatenPillPercentage, closeGhostDistance, powerPillPunishmentRate),
                switches(version));
    }

    private Set<GameSwitch> switches(TaskVersion version) {
        Map<GameSwitch, Boolean> switches = new EnumMap<>(GameSwitch.class);
        switches.put(GameSwitch.EXIT_LAIR_EDIBLE, exitLairEdible);
        switches.put(GameSwitch.END_ONLY_ON_TIME_LIMIT, endOnlyOnTimeLimit);
        switches.put(GameSwitch.SIMULTANEOUS_LAIR_EXIT, simultaneousLairExit);
        switches.put(GameSwitch.END_AFTER_GHOST_EATING_CHANCES, endAfterGhostEatingChances);
        switches.put(GameSwitch.REMOVE_PILLS_NEAR_POWER_PILLS, removePillsNearPowerPills);
        switches.put(GameSwitch.WITHOUT_PILLS, noPills);
        switches.put(GameSwitch.WITHOUT_POWER_PILLS, noPowerPills);
        switches.put(GameSwitch.INFINITE_EDIBLE_TIME, infiniteEdibleTime);
        switches.put(GameSwitch.IMPRISONED_WHILE_EDIBLE, version != TaskVersion.BLENDED);
        switches.put(GameSwitch.WITHOUT_RANDOM_REVERSALS, !allowRandomGhostReversals);
        switches.put(GameSwitch.DIE_ON_IMPROPER_POWER_PILL_EATING, dieOnImproperPowerPillEating);
        switches.values().removeIf(on -> !on);
        return switches.keySet();
    }

    private SensorSettings sensors(TaskVersion version, OwnClasses classes) {
        return new SensorSettings(
                sensorGroups(version),
                junctionsToSense,
                smallStepSimDepth,
                edibleTime,
                SensorSettings.CLOSE_POWER_PILL_DISTANCE,
                OwnClasses.names("ownSensors", ownSensors).stream()
                        .map(name -> labelled(name, classes.make("ownSensors", name, Sensor.class)))
                        .toList());
    }

    private Set<SensorGroup> sensorGroups(TaskVersion version) {
        Map<SensorGroup, Boolean> choice = new EnumMap<>(SensorGroup.class);
        choice.put(SensorGroup.NUMBERED_GHOSTS, specific);
        choice.put(SensorGroup.NEAREST_GHOSTS, specificGhostProximityOrder);
        choice.put(SensorGroup.NEAREST_OF_EACH_KIND, specificGhostEdibleThreatSplit);
        choice.put(SensorGroup.APPROACHING, incoming);
        choice.put(SensorGroup.TRAPPED, trapped);
        choice.put(SensorGroup.TIME_VERSUS_DISTANCE, eTimeVsGDis);
        choice.put(SensorGroup.EDIBLE, version == TaskVersion.BLENDED);
        choice.put(SensorGroup.EDIBLE_PROPORTIONS, !infiniteEdibleTime);
        choice.put(SensorGroup.OPTIONS_AFTER_JUNCTION, highLevel);
        choice.values().removeIf(wanted -> !wanted);
        return choice.keySet();
    }

    private static Sensor labelled(String name, Sensor sensor) {
        String asked = "ownSensors=" + name + ": label()";
        PlainText.require(asked, OwnClasses.ask(asked, sensor::label));
        return CheckedParts.of(sensor);
    }

    private @Nullable ModuleDivision division(OwnClasses classes) {
        if (multitaskModes < 2) {
            return null;
        }
        ModuleDivision division = ModuleDivisions.find(pacmanMultitaskScheme).orElseGet(() -> ownDivision(classes));
        if (division.modules() != multitaskModes) {
            throw new UserError("multitaskModes=" + multitaskModes + ": " + pacmanMultitaskScheme + " chooses among "
                    + division.modules() + " modules; give multitaskModes=" + division.modules());
        }
        return division;
    }

    private ModuleDivision ownDivision(OwnClasses classes) {
        String asked = "pacmanMultitaskScheme=" + pacmanMultitaskScheme + ": ";
        ModuleDivision division = classes.make("pacmanMultitaskScheme", pacmanMultitaskScheme, ModuleDivision.class);
        int modules = OwnClasses.ask(asked + "modules()", division::modules);
        for (int i = 0; i < modules; i++) {
            int module = i;
            String observation = asked + "observation(" + module + ")";
            PlainText.require(observation, OwnClasses.ask(observation, () -> division.observation(module)));
        }
        return CheckedParts.of(division);
    }

    private Supplier<NewGhostController> ghosts(OwnClasses classes) {
        Supplier<NewGhostController> known = TEAMS.get(ghostTeam);
        return known != null ? known : OwnGhosts.factory(ghostTeam, classes);
    }

    private ModuleArbitration arbitration() {
        ModuleArbitration arbitration = ModuleArbitration.PREFERENCE.withDisabledModule(disabledMode);
        if (softmaxModeSelection) {
            if (softmaxTemperature == 0) {
                throw new UserError("softmaxTemperature=0: must be positive with softmaxModeSelection=true");
            }
            arbitration = arbitration.withSoftmax(softmaxTemperature);
        }
        if (preferenceNeuronFatigueUnit != 0) {
            arbitration = arbitration.withFatigue(preferenceNeuronFatigueUnit, preferenceNeuronDecay);
        }
        return weightedAverageModeAggregation
                ? arbitration.withAnswer(ModuleArbitration.Answer.WEIGHTED_AVERAGE)
                : arbitration;
    }
}
