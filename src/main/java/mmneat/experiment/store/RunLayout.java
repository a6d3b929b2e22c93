package mmneat.experiment.store;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import mmneat.experiment.FolderPlace;

/**
 * The names of the files in a run's folder and the columns of their tables, ours and the original's.
 *
 * <p>Names are relative to the folder, with {@code /} between the parts. The names of a run's score files and logs
 * start with a prefix, {@code <log><run>_}. Columns are counted from 1.
 *
 * <p>Source: docs/specification/evolution.md, sections 5 to 7, for the original's files.
 */
public final class RunLayout {

    /** All parameters of the run. */
    public static final String PARAMETERS = "parameters.properties";

    /** The ghost locations of a run of the isolated version of the task ({@link GhostLocationsCopy}). */
    public static final String GHOST_LOCATIONS = "ghost-locations.txt";

    /** The progress of the run. */
    public static final String STATUS = "status.json";

    /** The lock: the process that works on the run. */
    public static final String LOCK = "lock.json";

    /** The newest checkpoint. */
    public static final String CHECKPOINT = "checkpoint.json.gz";

    /** The last synced checkpoint before the newest one ({@link CheckpointFile}). */
    public static final String PREVIOUS_CHECKPOINT = "checkpoint-previous.json.gz";

    /**
     * The network of the run's champion: the best parent of the last generation that had children so far ({@link
     * mmneat.experiment} explains the term).
     */
    public static final String CHAMPION = "champion.json";

    /** One row per generation, below a header. */
    public static final String GENERATIONS = "generations.csv";

    /**
     * The columns of {@link #GENERATIONS} for every task; the best scores in its objectives follow, and in runs
     * of hybrids {@link #columnsOfGroup}.
     */
    public static final List<String> GENERATIONS_COLUMNS =
            List.of("generation", "best", "median", "worst", "champion", "modules", "neurons", "links", "steps");

    /** The champion in the original's form. */
    public static final String ORIGINAL_CHAMPION = "bestPacMan/bestPacMan.xml";

    /** The scores of {@link #ORIGINAL_CHAMPION}. */
    public static final String ORIGINAL_CHAMPION_SCORE = "bestPacMan/score.txt";

    /** The archetype, the population-wide list of neurons that fixes their order in every genotype, as XML. */
    public static final String ARCHETYPE = "archetype0.xml";

    /**
     * The shadows in the archetype, one line per neuron that has one: its innovation number and that of its shadow. A
     * shadow is a second entry of the archetype for the neuron, which the original reserves for a crossover that its
     * runs never perform. Source: docs/specification/networks.md, section 4.3.
     */
    public static final String CROSSOVER_MAPPING = "combiningCrossoverMapping.txt";

    /** The name of the {@link #log} and of the score files of the parents of each generation. */
    public static final String PARENTS = "parents";

    /** The name of the {@link #log} and of the score files of the children of each generation. */
    public static final String CHILDREN = "child";

    /** The name of the {@link #log} of the parents' networks: sizes, module usage, used inputs. */
    public static final String NETWORKS = "TWEANNData";

    /** The name of the {@link #log} of the costs of evaluation. */
    public static final String PERFORMANCE = "Performance";

    /** The name of the {@link #log} of the numbers of modules of the parents. */
    public static final String MODULE_COUNTS = "ModeUsage";

    /** The name of the {@link #log} of the goals of objectives (TUG, targeting unachieved goals). */
    public static final String GOALS = "TUG";

    /** The name of the {@link #log} of the parents of each child. */
    public static final String LINEAGE = "Lineage";

    /** The name of the {@link #log} of the mutations of each child. */
    public static final String MUTATIONS = "Mutations";

    private static final int COLUMNS_PER_PROPERTY = 4;

    /**
     * The property of {@link #PARENTS} by whose maximum champions are chosen: the mean game score, behind two
     * objectives.
     */
    private static final int CHAMPION_SCORE = 2;

    private static final String ORIGINAL_PARAMETERS = "_parameters.txt";
    private static final Pattern NETWORKS_FOLDER = Pattern.compile("initial|gen\\d+");

    private RunLayout() {}

    /**
     * The columns of {@link #GENERATIONS} for a group of modules, counted from 0. Runs of hybrids have them for each
     * group, behind all other columns.
     */
    static List<String> columnsOfGroup(int group) {
        return List.of("modules of group " + group, "use of group " + group);
    }

    /** The best network in an objective, counted from 0, in the original's form. */
    public static String bestIn(int objective) {
        return "bestObjectives/bestIn" + objective + ".xml";
    }

    /** The scores of {@link #bestIn}. */
    public static String scoresOfBestIn(int objective) {
        return "bestObjectives/score" + objective + ".txt";
    }

    /** The folder of a generation's networks. */
    public static String networksFolder(int generation) {
        return generation == 0 ? "initial" : "gen" + generation;
    }

    /** Whether a folder of this name is one of {@link #networksFolder}. */
    public static boolean isNetworksFolder(String name) {
        return NETWORKS_FOLDER.matcher(name).matches();
    }

    /** A network of a generation, counted from 0, in the original's form. */
    public static String network(String prefix, int generation, int index) {
        String folder = networksFolder(generation);
        return folder + "/" + prefix + folder + "_" + index + ".xml";
    }

    /** A log, such as that of {@link #PARENTS}. */
    public static String log(String prefix, String name) {
        return prefix + name + "_log.txt";
    }

    /** Whether a run with this prefix has a log of this name, or {@link #GENERATIONS}. */
    static boolean isLog(String prefix, String name) {
        return name.equals(GENERATIONS) || name.matches(Pattern.quote(prefix) + "\\w+_log\\.txt");
    }

    /** Whether a run with this prefix writes a file of this name in one of its generations. */
    static boolean isWrittenByRun(String prefix, String name) {
        return isLog(prefix, name)
                || List.of(CHAMPION, ORIGINAL_CHAMPION, ORIGINAL_CHAMPION_SCORE, ARCHETYPE, CROSSOVER_MAPPING)
                        .contains(name)
                || name.matches("bestObjectives/(bestIn\\d+\\.xml|score\\d+\\.txt)")
                || name.matches(Pattern.quote(prefix) + "\\w+\\.(txt|plot)")
                || name.matches(
                        "(?<folder>" + NETWORKS_FOLDER + ")/" + Pattern.quote(prefix) + "\\k<folder>_\\d+\\.xml");
    }

    /**
     * Whether a run of this program or of the original may have written a file or folder with this name. The lock and
     * the status do not count, because they exist before the first checkpoint.
     */
    static boolean isNamedAsOfARun(String name) {
        return !List.of(LOCK, STATUS).contains(name)
                && (isNetworksFolder(name)
                        || name.matches("bestPacMan|bestObjectives|.*\\.(txt|xml|csv|json|gz|plot|properties)"));
    }

    /**
     * The folder of the run to which a file belongs, by its name and place. Empty if the folder is not that of a run,
     * or if runs have no file of this name. The file may be missing, its folder may be a symbolic link.
     */
    public static Optional<Path> runWith(Path file) throws IOException {
        if (Files.exists(file) && !Files.isRegularFile(file)) {
            return Optional.empty();
        }
        Path place = FolderPlace.withoutLinks(file);
        String name = "";
        for (Path folder = place.getParent(); folder != null && name.indexOf('/') < 0; folder = folder.getParent()) {
            name = folder.relativize(place)
                    .toString()
                    .replace(place.getFileSystem().getSeparator(), "/");
            if (isRun(folder) && isOfRun(prefixIn(folder), name)) {
                return Optional.of(folder);
            }
        }
        return Optional.empty();
    }

    private static boolean isRun(Path folder) {
        return Files.isDirectory(folder)
                && Files.isReadable(folder)
                && (Stream.of(STATUS, LOCK, CHECKPOINT, PREVIOUS_CHECKPOINT)
                                .anyMatch(name -> Files.exists(folder.resolve(name)))
                        || parametersIn(folder).isPresent());
    }

    /** Whether a file of this name is written into the folder of a run with this prefix, at any time. */
    private static boolean isOfRun(String prefix, String name) {
        // Without a log there are no files with a prefix. No name begins with a slash.
        String known = prefix.isEmpty() ? "/" : prefix;
        String finished = name.replaceFirst(Pattern.quote(DurableFiles.UNFINISHED) + "$", "");
        return List.of(PARAMETERS, GHOST_LOCATIONS, STATUS, LOCK, CHECKPOINT, PREVIOUS_CHECKPOINT)
                        .contains(finished)
                || finished.matches("evaluation-[^/]+\\.(json|csv)|[^/]*" + Pattern.quote(ORIGINAL_PARAMETERS))
                || finished.matches(Pattern.quote(known) + "[^/]*\\.(txt|plot)")
                || isWrittenByRun(known, finished);
    }

    /** The gnuplot script that shows a log. */
    public static String plot(String prefix, String name) {
        return prefix + name + "_log.plot";
    }

    /** The objectives of the {@link #PARENTS} or {@link #CHILDREN} of a generation. */
    public static String scores(String prefix, String population, int generation) {
        return prefix + population + "_gen" + generation + ".txt";
    }

    /**
     * The other scores of the {@link #PARENTS} or {@link #CHILDREN} of a generation: scores that the task records but
     * that are not objectives ({@link mmneat.evolution.Task#otherScoreNames}).
     */
    public static String otherScores(String prefix, String population, int generation) {
        return prefix + population + "_other_scores_gen" + generation + ".txt";
    }

    /**
     * Returns the length of the longest ending of a file name in a run, in characters of one byte each. The ending is
     * what follows the prefix. With it a caller checks before a run that no name exceeds the limit of the file system.
     *
     * @param generations number of generations of the run
     */
    public static int longestEnding(int generations) {
        return Stream.of(
                        otherScores("", PARENTS, generations),
                        evaluationReport("", Long.MAX_VALUE),
                        "AVG_" + plot("", NETWORKS),
                        "_learning-curve.svg")
                .mapToInt(name -> (name + DurableFiles.UNFINISHED).length())
                .max()
                .orElseThrow();
    }

    /** The original's report on an evaluation of the network with this id. */
    public static String evaluationReport(String prefix, long network) {
        return log(prefix, "Eval-Net" + network);
    }

    /** The summary of the champion's evaluation by these rules. */
    public static String evaluationSummary(String rules) {
        return "evaluation-" + rules + ".json";
    }

    /** The games of the champion's evaluation by these rules, one line per game. */
    public static String evaluationGames(String rules) {
        return "evaluation-" + rules + ".csv";
    }

    /**
     * First column of a property, counted from 0, in a log of a population: minimum, mean, maximum and deviation
     * follow.
     */
    public static int firstColumn(int property) {
        return 2 + COLUMNS_PER_PROPERTY * property;
    }

    /** Column of the champion's score in the log of {@link #PARENTS}. */
    public static int championScoreColumnOfLog() {
        return firstColumn(CHAMPION_SCORE) + 2;
    }

    /** Column of the champion's score in {@link #GENERATIONS}. */
    public static int championScoreColumnOfTable() {
        return 1 + GENERATIONS_COLUMNS.indexOf("best");
    }

    /**
     * Returns the log of {@link #PARENTS} of a single run in a folder, with any prefix; empty if there is none.
     * Summaries over several runs are not found: their names have no run number.
     */
    public static Optional<Path> parentsLogIn(Path folder) {
        Pattern name = Pattern.compile(".*\\d" + Pattern.quote("_" + log("", PARENTS)));
        return firstIn(folder, name);
    }

    /** The prefix of the files in a folder; empty if it has no log of {@link #PARENTS}. */
    public static String prefixIn(Path folder) {
        return parentsLogIn(folder)
                .map(log -> log.getFileName().toString())
                .map(name -> name.substring(0, name.length() - log("", PARENTS).length()))
                .orElse("");
    }

    /** The file of the run's parameters in a folder: ours, or else the original's. */
    public static Optional<Path> parametersIn(Path folder) {
        Path ours = folder.resolve(PARAMETERS);
        return Files.exists(ours)
                ? Optional.of(ours)
                : firstIn(folder, Pattern.compile(".*" + Pattern.quote(ORIGINAL_PARAMETERS)));
    }

    /** The champion in a folder: ours, or else the original's. */
    public static Optional<Path> championIn(Path folder) {
        return Stream.of(CHAMPION, ORIGINAL_CHAMPION)
                .map(folder::resolve)
                .filter(Files::exists)
                .findFirst();
    }

    /** Whether a file, in any folder, has the name of the champion in the original's form. */
    public static boolean isNamedAsOriginalChampion(Path file) {
        return Path.of(ORIGINAL_CHAMPION).endsWith(file.getFileName());
    }

    /** Whether a file, in any folder, has the name of a champion, ours or the original's. */
    public static boolean isNamedAsChampion(Path file) {
        return file.endsWith(CHAMPION) || isNamedAsOriginalChampion(file);
    }

    private static Optional<Path> firstIn(Path folder, Pattern name) {
        try (Stream<Path> files = Files.list(folder)) {
            return files.filter(
                            file -> name.matcher(file.getFileName().toString()).matches())
                    .sorted()
                    .findFirst();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
