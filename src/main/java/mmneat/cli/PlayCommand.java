package mmneat.cli;

import java.io.File;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumMap;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import java.util.stream.Stream;
import mmneat.contest.entry.ControllerFactory;
import mmneat.contest.entry.ControllerLoader;
import mmneat.experiment.FileErrors;
import mmneat.experiment.UserError;
import mmneat.random.ResumableRandom;
import org.apache.commons.math3.stat.descriptive.SummaryStatistics;
import pacman.ControllerFailure;
import pacman.Executor;
import pacman.controllers.Controller;
import pacman.controllers.HumanController;
import pacman.controllers.KeyBoardInput;
import pacman.game.Constants;
import pacman.game.Constants.GHOST;
import pacman.game.Constants.MOVE;
import pacman.game.Game;
import pacman.game.GameRules;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * Plays games between two controllers and prints what they scored.
 *
 * <p>Each game gets new controllers, and a seed drawn from a generator with the seed given: the same words give the same
 * games.
 */
@Command(
        name = "play",
        customSynopsis = "mmneat play [name=value...]",
        description = {
            "Plays games of Ms. Pac-Man between two controllers and prints score and speed.",
            "",
            "Example: mmneat play pacman=StarterPacMan ghosts=Legacy games=1000 seed=1",
            "Example: mmneat play classpath=entry.jar pacman=my.Entry view=true",
            "",
        })
final class PlayCommand extends ConsoleCommand implements Runnable {

    private static final String HUMAN = "Human";
    private static final Set<String> NAMES_OF_THE_HUMAN =
            Set.of(HUMAN, HumanController.class.getSimpleName(), HumanController.class.getName());
    private static final int PROGRESS_SECONDS = 5;
    private static final int LAST_LOOK_MILLISECONDS = 2000;
    private static final long STALL_MILLISECONDS = 10_000;

    @Option(
            names = "pacman",
            paramLabel = "CLASS|FILE",
            defaultValue = "StarterPacMan",
            description = "Controller of Ms. Pac-Man: a class; the folder of a run or a file with an evolved network"
                    + " (champion.json); champion:blended, champion:interleaved or champion:isolated for a network that"
                    + " comes with the program; or " + HUMAN + " with view=true (default: ${DEFAULT-VALUE}).")
    private String pacMan;

    @Option(
            names = "division",
            paramLabel = "NAME",
            description =
                    "Division of the task for a multitask network, such as AnyPills (default: that of full games).")
    private String division;

    @Option(
            names = "ghosts",
            paramLabel = "CLASS",
            defaultValue = "Legacy",
            description = "Class of the ghosts' controller (default: ${DEFAULT-VALUE}).")
    private String ghosts;

    @Option(
            names = "classpath",
            paramLabel = "PATH",
            description = "Jars and class folders of outside controllers, separated by ${sys:path.separator}")
    private String classPath;

    @Option(names = "games", paramLabel = "N", defaultValue = "1", description = "Games (default: ${DEFAULT-VALUE}).")
    @Range(min = 1)
    private int games;

    @Option(
            names = "seed",
            paramLabel = "N",
            defaultValue = "0",
            description = "Seed of the games' seeds (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(
            names = "timed",
            paramLabel = "true|false",
            arity = "1",
            defaultValue = "false",
            description = "Controllers get 40 ms per step, in threads of their own; otherwise as long as they take"
                    + " (default: ${DEFAULT-VALUE}).")
    private boolean timed;

    @Option(
            names = "view",
            paramLabel = "true|false",
            arity = "1",
            defaultValue = "false",
            description = "Shows the games in a window, 40 ms per step (default: ${DEFAULT-VALUE}).")
    private boolean view;

    @Option(
            names = "record",
            paramLabel = "FILE",
            description = "Writes a recording of the game, for the command replay.")
    private Path record;

    @Mixin
    private GameOptions game;

    @Override
    public void run() {
        new Contest(this).play();
    }

    /** The games of one command. */
    private static final class Contest {

        private final PrintWriter out;
        private final PrintWriter notes;
        private final GameRules rules;
        private final String rulesName;
        private final ControllerFactory<EnumMap<GHOST, MOVE>> ghosts;

        /** Null if a human plays. */
        private final Supplier<Controller<MOVE>> pacMan;

        private final String pacManName;

        private final int games;
        private final long seed;
        private final boolean timed;
        private final boolean view;

        /** Null if the game is not recorded. */
        private final Path recording;

        private final Executor executor = new Executor();
        private final SummaryStatistics scores = new SummaryStatistics();
        private long steps;

        /** Number of the game that is played. */
        private volatile int playing;

        Contest(PlayCommand options) {
            out = options.out();
            notes = options.notes();
            rules = options.game.rules(GameRules.competition());
            rulesName = options.game.name();
            games = options.games;
            seed = options.seed;
            timed = options.timed;
            view = options.view && Display.isThere();
            if (options.view && !view) {
                notes.println("mmneat: there is no display, so the games are not shown");
            }
            recording = options.record;
            ControllerLoader loader = new ControllerLoader(classPath(options.classPath));
            String player = options.pacMan;
            boolean human = NAMES_OF_THE_HUMAN.contains(player);
            if (human && !view) {
                throw new UserError("pacman=" + player + " needs view=true and a display");
            }
            options.requireEffect("division", !human && NetworkPlayer.isNetwork(player), "it is for a network");
            if (human) {
                pacMan = null;
                pacManName = HUMAN;
            } else if (NetworkPlayer.isNetwork(player)) {
                pacMan = NetworkPlayer.read(player, Optional.ofNullable(options.division), seed);
                pacManName = player;
            } else {
                ControllerFactory<MOVE> factory = loader.pacMan(player);
                pacMan = factory::create;
                pacManName = factory.name();
            }
            ghosts = loader.ghosts(options.ghosts);
            requireRecordable();
        }

        private static List<Path> classPath(String classPath) {
            return Stream.ofNullable(classPath)
                    .flatMap(text -> Stream.of(text.split(File.pathSeparator)))
                    .filter(place -> !place.isBlank())
                    .map(Path::of)
                    .toList();
        }

        private void requireRecordable() {
            if (recording == null) {
                return;
            }
            if (games != 1) {
                throw new UserError("record=" + recording + ": one game is recorded; use games=1");
            }
            if (view && !timed) {
                throw new UserError("record=" + recording + ": with view=true use timed=true too");
            }
            OutputFile.require("record", recording);
        }

        void play() {
            ResumableRandom seeds = new ResumableRandom(seed);
            rules.prepareMazes();
            long start = System.nanoTime();
            long nextProgress = start + TimeUnit.SECONDS.toNanos(PROGRESS_SECONDS);
            Thread ending = new Thread(this::reportEnd);
            Runtime.getRuntime().addShutdownHook(ending);
            try (StallNotice stall = new StallNotice(notes, STALL_MILLISECONDS)) {
                for (int index = 0; index < games; index++) {
                    playing = index + 1;
                    Game game = newGame(seeds);
                    stall.watch(hasTimeLimit() ? null : game);
                    play(game, index);
                    stall.watch(null);
                    scores.addValue(game.getScore());
                    steps += game.getTotalTime();
                    if (index + 1 < games && System.nanoTime() > nextProgress) {
                        nextProgress += TimeUnit.SECONDS.toNanos(PROGRESS_SECONDS);
                        notes.println(String.format(
                                Locale.ROOT, "%d of %d games, mean score %.1f", index + 1, games, scores.getMean()));
                        notes.flush();
                    }
                }
            } finally {
                forget(ending);
            }
            report((System.nanoTime() - start) / 1e9);
        }

        private static void forget(Thread hook) {
            try {
                Runtime.getRuntime().removeShutdownHook(hook);
            } catch (IllegalStateException e) {
                // Ctrl-C came as the last game ended: the hook is at work.
                return;
            }
        }

        /** A controller may call {@code System.exit}, whose exit code says nothing: a script must not take it for a result. */
        private void reportEnd() {
            notes.println("mmneat: the program was ended in game " + playing + " of " + games + "; there is no result");
            notes.flush();
        }

        /** Whether the game goes on without a controller that is late; a human's always does. */
        private boolean hasTimeLimit() {
            return timed || pacMan == null;
        }

        /**
         * By MM-NEAT's rules a game draws from the run's generator too, which copies share. Here each game has one of its own, so that
         * a controller that looks ahead in copies does not change the games that come after.
         */
        private Game newGame(ResumableRandom seeds) {
            return rules.conventions() == GameRules.Conventions.MM_NEAT
                    ? new Game(seeds.nextLong(), rules, new ResumableRandom(seeds.nextLong()))
                    : new Game(seeds.nextLong(), rules);
        }

        private void play(Game game, int index) {
            try {
                Controller<MOVE> player = pacMan == null ? new HumanController(new KeyBoardInput()) : pacMan.get();
                play(game, player, ghosts.create());
            } catch (RuntimeException | Error failure) {
                ControllerFailure report = ControllerFailure.in(failure).orElse(null);
                if (report == null) {
                    throw failure;
                }
                notes.println("mmneat: " + report.controllerName() + " threw an exception in game " + (index + 1)
                        + " at time " + report.totalTime());
                Throwable thrown = report == failure ? failure.getCause() : failure;
                thrown.printStackTrace(notes);
                notes.flush();
                throw new UserError(report.controllerName() + " failed: " + thrown, thrown);
            }
        }

        private void play(Game game, Controller<MOVE> player, Controller<EnumMap<GHOST, MOVE>> team) {
            if (recording != null) {
                record(game, player, team);
            } else if (hasTimeLimit()) {
                executor.runGameTimedSpeedOptimised(player, team, view, view, game);
            } else if (view) {
                executor.runGame(player, team, game, true, Constants.DELAY);
            } else {
                executor.runExperiment(player, team, game);
            }
            if (view) {
                lookAtTheEnd();
            }
        }

        private void record(Game game, Controller<MOVE> player, Controller<EnumMap<GHOST, MOVE>> team) {
            if (timed) {
                recordTimed(game, player, team);
                return;
            }
            OutputFile.write(recording, executor.runGameRecorded(player, team, game) + System.lineSeparator());
        }

        /** The competition's method writes the file itself and only prints that it could not, so it gets a file of its own. */
        private void recordTimed(Game game, Controller<MOVE> player, Controller<EnumMap<GHOST, MOVE>> team) {
            try {
                Path part = Files.createTempFile("mmneat", ".recording");
                try {
                    executor.runGameTimedRecorded(game, player, team, view, part.toString());
                    OutputFile.write(recording, Files.readAllBytes(part));
                } finally {
                    Files.delete(part);
                }
            } catch (IOException e) {
                throw new UserError("record=" + recording + ": " + FileErrors.reason(e), e);
            }
        }

        private static void lookAtTheEnd() {
            try {
                Thread.sleep(LAST_LOOK_MILLISECONDS);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }

        private void report(double seconds) {
            out.println(pacManName + " against " + ghosts.name() + ", " + games + (games == 1 ? " game" : " games")
                    + ", seed " + seed + ", rules " + rulesName + (timed ? ", timed" : ""));
            out.println(String.format(
                    Locale.ROOT,
                    "score: mean %.1f, standard deviation %s, minimum %.0f, maximum %.0f",
                    scores.getMean(),
                    games == 1 ? "-" : String.format(Locale.ROOT, "%.1f", scores.getStandardDeviation()),
                    scores.getMin(),
                    scores.getMax()));
            out.println(String.format(
                    Locale.ROOT,
                    "steps: %d, %.0f per second from the start of the first game, when the mazes are loaded",
                    steps,
                    steps / Math.max(seconds, 1e-9)));
            out.flush();
        }
    }
}
