package mmneat.cli;

import java.io.File;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import mmneat.cli.options.GameOptions;
import mmneat.cli.options.JarOption;
import mmneat.cli.options.Range;
import mmneat.cli.output.Display;
import mmneat.cli.output.OutputFile;
import mmneat.contest.Contest;
import mmneat.contest.ContestReport;
import mmneat.contest.ContestResult;
import mmneat.contest.ContestSettings;
import mmneat.contest.Contestant;
import mmneat.contest.GameFailure;
import mmneat.contest.OnFailure;
import mmneat.contest.Timing;
import mmneat.contest.entry.ControllerFactory;
import mmneat.contest.entry.ControllerLoader;
import mmneat.experiment.ExitGuard;
import mmneat.experiment.UserError;
import org.jspecify.annotations.Nullable;
import pacman.Recording;
import pacman.controllers.HumanController;
import pacman.controllers.KeyBoardInput;
import pacman.game.Constants.MOVE;
import pacman.game.GameRules;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * The command {@code play}: plays games between two controllers and prints their scores.
 *
 * <p>Each game has new controllers, and a seed drawn from a generator with the given seed. So the same words give the
 * same games.
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
            "An entry runs with your rights: it can read and write your files, open connections and start programs.",
            "",
        })
final class PlayCommand extends ConsoleCommand implements Runnable {

    private static final String HUMAN = "Human";
    private static final Set<String> NAMES_OF_THE_HUMAN =
            Set.of(HUMAN, HumanController.class.getSimpleName(), HumanController.class.getName());
    private static final String UNTIMED = "false";
    private static final String FAST = "fast";

    @Option(
            names = "pacman",
            paramLabel = "CLASS|FILE",
            defaultValue = "StarterPacMan",
            description = "Controller of Ms. Pac-Man: a class, with arguments if its constructor has any, as in"
                    + " 'my.Entry(Legacy,3)'; the folder of a run or a file with an evolved network"
                    + " (champion.json); champion:NAME, such as champion:blended, for a network that comes with the"
                    + " program; or " + HUMAN + " with view=true (default: ${DEFAULT-VALUE}).")
    private String pacMan;

    @Option(
            names = "division",
            paramLabel = "NAME",
            description =
                    "Division of the task for a multitask network, such as AnyPills (default: that of full games).")
    private @Nullable String division;

    @Option(
            names = "ghosts",
            paramLabel = "CLASS",
            defaultValue = "Legacy",
            description = "Class of the ghosts' controller, with arguments if it has any (default: ${DEFAULT-VALUE}).")
    private String ghosts;

    @Option(
            names = "classpath",
            paramLabel = "PATH",
            description = "Jars and class folders with controllers of your own, for both sides, separated by"
                    + " ${sys:path.separator}")
    private @Nullable String classPath;

    @Option(
            names = "pacmanClasspath",
            paramLabel = "PATH",
            description = "As classpath=, for Ms. Pac-Man's controller only; its class must be found there.")
    private @Nullable String pacManClassPath;

    @Option(
            names = "ghostsClasspath",
            paramLabel = "PATH",
            description = "As classpath=, for the ghosts' controller only; its class must be found there.")
    private @Nullable String ghostsClassPath;

    @Option(
            names = "games",
            paramLabel = "N",
            defaultValue = "1",
            description = "Number of games (default: ${DEFAULT-VALUE}).")
    @Range(min = 1)
    private int games;

    @Option(
            names = "seed",
            paramLabel = "N",
            defaultValue = "0",
            description = "Seed from which the games' seeds are drawn (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Option(
            names = "timed",
            paramLabel = "VALUE",
            completionCandidates = Timings.class,
            defaultValue = UNTIMED,
            description =
                    "One of ${COMPLETION-CANDIDATES}. false: no time limit. true: real time, 40 ms per step. fast: at"
                            + " most 40 ms per step; the next step starts as soon as both controllers have answered. With true"
                            + " and fast, each controller computes in its own thread, and the last answer of a late controller"
                            + " is used again (default: ${DEFAULT-VALUE}).")
    private String timed;

    @Option(
            names = "moveLimit",
            paramLabel = "SECONDS",
            description = "Seconds after which an untimed game fails if a controller has not answered (default: none).")
    @Range(min = 1)
    private @Nullable Integer moveLimit;

    @Option(
            names = "onFailure",
            paramLabel = "VALUE",
            completionCandidates = Reactions.class,
            defaultValue = "stop",
            description =
                    "Reaction to a controller's failure (exception, endless recursion, out of memory, call to exit, move"
                            + " limit), one of ${COMPLETION-CANDIDATES}. stop: reports the finished games and exits with code 2. skip:"
                            + " leaves the game out. score0: counts it with score 0 (default: ${DEFAULT-VALUE}).")
    private String onFailure;

    @Option(
            names = "check",
            paramLabel = "VALUE",
            completionCandidates = Checks.class,
            defaultValue = "none",
            description =
                    "One of ${COMPLETION-CANDIDATES}. repeat: plays the first game again and reports whether its score is"
                            + " the same (default: ${DEFAULT-VALUE}).")
    private String check;

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
    private @Nullable Path record;

    @Mixin
    private GameOptions game;

    @Mixin
    private JarOption jar;

    @Override
    public void run() {
        boolean isHuman = NAMES_OF_THE_HUMAN.contains(pacMan);
        if (isHuman && !view) {
            throw new UserError("pacman=" + pacMan + " needs view=true, which shows the game");
        }
        if (isHuman && !Display.isThere()) {
            throw new UserError("pacman=" + pacMan + " needs a display, and there is none; use a desktop session");
        }
        boolean isShown = isShown();
        requireEffect("division", !isHuman && NetworkPlayer.isNetwork(pacMan), "it is for a network");
        ContestSettings settings = ExitGuard.guard(notes(), () -> settings(isHuman, isShown));
        requireEffect("moveLimit", settings.timing() == Timing.NONE, "a timed game does not wait for an answer");
        requireUsedClassPath(settings);
        requireRecordable(settings);
        settings.rules().prepareMazes();
        Recording.Recorder recorder = record == null ? null : new Recording.Recorder();
        long start = System.nanoTime();
        ContestResult result = new Contest(settings, notes())
                .play(recorder == null ? state -> {} : recorder::add, soFar -> report(settings, soFar, start));
        report(settings, result, start);
        if (record != null && recorder != null && !recorder.text().isEmpty()) {
            OutputFile.write(record, recorder.text() + System.lineSeparator());
        }
        requireResult(settings, result);
    }

    private boolean isShown() {
        if (view && !Display.isThere()) {
            notes().println("mmneat: there is no display, so the games are not shown");
        }
        return view && Display.isThere();
    }

    private ContestSettings settings(boolean isHuman, boolean isShown) {
        return new ContestSettings(
                pacMan(isHuman),
                contestant(
                        loader("ghostsClasspath", ghostsClassPath).ghosts(ghosts), "ghosts", ghosts, ghostsClassPath),
                game.rules(GameRules.competition()),
                games,
                seed,
                timing(isHuman, isShown),
                moveLimit == null ? null : Duration.ofSeconds(moveLimit),
                isShown,
                OnFailure.valueOf(onFailure.toUpperCase(Locale.ROOT)),
                check.equals("repeat"));
    }

    /** Returns the time limit: real time for games of a human player and for shown games. */
    private Timing timing(boolean isHuman, boolean isShown) {
        if (timed.equals(UNTIMED) && !isHuman) {
            return Timing.NONE;
        }
        return timed.equals(FAST) && !isShown ? Timing.UNTIL_ANSWERED : Timing.REAL_TIME;
    }

    private Contestant<MOVE> pacMan(boolean isHuman) {
        if (isHuman) {
            return new Contestant<>(HUMAN, "", () -> new HumanController(new KeyBoardInput()));
        }
        if (NetworkPlayer.isNetwork(pacMan)) {
            return new Contestant<>(pacMan, "", NetworkPlayer.read(pacMan, Optional.ofNullable(division), seed, jar));
        }
        return contestant(loader("pacmanClasspath", pacManClassPath).pacMan(pacMan), "pacman", pacMan, pacManClassPath);
    }

    private static <T> Contestant<T> contestant(
            ControllerFactory<T> factory, String option, String value, @Nullable String ownClassPath) {
        if (ownClassPath != null && !places(ownClassPath).contains(Path.of(factory.origin()))) {
            throw new UserError(option + "=" + value + ": the class is not in " + ownClassPath
                    + " but elsewhere; leave out " + option + "Classpath= to use it");
        }
        return new Contestant<>(factory.name(), factory.origin(), factory::create);
    }

    /** Returns the loader of one side, which searches the side's class path first, then the common one. */
    private ControllerLoader loader(String option, @Nullable String ownClassPath) {
        List<Path> both = places(classPath);
        List<Path> own = places(ownClassPath);
        return new ControllerLoader(
                own.isEmpty() ? "classpath" : option,
                Stream.concat(own.stream(), both.stream()).toList());
    }

    private static List<Path> places(@Nullable String classPath) {
        return Stream.ofNullable(classPath)
                .flatMap(text -> Stream.of(text.split(File.pathSeparator)))
                .filter(place -> !place.isBlank())
                .map(Path::of)
                .toList();
    }

    private void requireUsedClassPath(ContestSettings settings) {
        boolean isUsed = !settings.pacMan().origin().isEmpty()
                || !settings.ghosts().origin().isEmpty();
        requireEffect("classpath", isUsed, "both controllers come with the program");
        boolean playsClass = !settings.pacMan().name().equals(HUMAN) && !NetworkPlayer.isNetwork(pacMan);
        requireEffect("pacmanClasspath", playsClass, "Ms. Pac-Man's controller is not a class");
    }

    private void requireRecordable(ContestSettings settings) {
        if (record == null) {
            return;
        }
        if (games != 1) {
            throw new UserError("record=" + record + ": only one game can be recorded; use games=1");
        }
        requireEffect("check", !settings.isRepeated(), "the game is recorded");
        OutputFile.require("record", record);
        Optional<Path> network = NetworkPlayer.file(pacMan);
        if (network.isPresent()) {
            OutputFile.requireOther("record", record, "pacman=" + pacMan, network.get());
        }
    }

    private void report(ContestSettings settings, ContestResult result, long start) {
        double seconds = (System.nanoTime() - start) / 1e9;
        ContestReport.lines(settings, result, game.name(), seconds).forEach(out()::println);
        out().flush();
    }

    private static void requireResult(ContestSettings settings, ContestResult result) {
        if (result.failures().isEmpty()) {
            return;
        }
        GameFailure failure = result.failures().get(0);
        if (settings.onFailure() == OnFailure.STOP) {
            throw new UserError(failure.sentence() + "; game " + failure.game() + " of " + settings.games()
                    + " ended the contest; onFailure=skip or onFailure=score0 plays on");
        }
        if (result.scores().isEmpty()) {
            throw new UserError("no game was played to its end: " + failure.sentence());
        }
    }

    /** Values of the option {@code timed=}. */
    private static final class Timings extends ArrayList<String> {
        Timings() {
            super(List.of(UNTIMED, "true", FAST));
        }
    }

    /** Values of the option {@code onFailure=}. */
    private static final class Reactions extends ArrayList<String> {
        Reactions() {
            super(List.of("stop", "skip", "score0"));
        }
    }

    /** Values of the option {@code check=}: {@code repeat} plays the first game again and compares the scores. */
    private static final class Checks extends ArrayList<String> {
        Checks() {
            super(List.of("none", "repeat"));
        }
    }
}
