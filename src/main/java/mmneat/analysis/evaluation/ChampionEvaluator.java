package mmneat.analysis.evaluation;

import com.fasterxml.jackson.core.JacksonException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.atomic.AtomicLong;
import mmneat.analysis.results.ChampionEvaluation;
import mmneat.evolution.DaemonThreads;
import mmneat.experiment.FileErrors;
import mmneat.experiment.TextFiles;
import mmneat.experiment.UserError;
import mmneat.experiment.store.RunLayout;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;
import mmneat.neat.Genotype;
import mmneat.neat.io.GenotypeJson;

/**
 * Evaluates champions over many games on all cores.
 *
 * <p>Every game has a generator of its own. The seed of game n is the n-th draw from a generator with the evaluation's
 * seed. So the result is the same for any number of threads, and any game can be repeated alone. Games are played in
 * blocks, and blocks are written in order.
 */
public final class ChampionEvaluator implements AutoCloseable {

    /** Number of games that are played one after the other and written together. */
    public static final int BLOCK = 20;

    private final Rules rules;
    private final int games;
    private final long seed;
    private final ExecutorService threads;
    private final AtomicLong played = new AtomicLong();
    private final AtomicLong found = new AtomicLong();

    /**
     * An evaluator.
     *
     * @param games games per champion, at least 1; if an earlier evaluation played more, all of them count
     * @param threads number of games that are played at the same time
     */
    public ChampionEvaluator(Rules rules, int games, long seed, int threads) {
        this.rules = rules;
        this.games = games;
        this.seed = seed;
        this.threads = Executors.newFixedThreadPool(threads, DaemonThreads.named("evaluation"));
    }

    /** Number of games taken over from an earlier evaluation. */
    public long found() {
        return found.get();
    }

    /** Number of games that all threads of this evaluator have played so far, without those found on disk. */
    public long played() {
        return played.get();
    }

    /** The file in the folder of the champion's run, or beside a network that is not the champion of a run. */
    private static Path place(Champion champion, String name) {
        boolean isOfRun = champion.runFolder().isPresent() && RunLayout.isNamedAsChampion(champion.file());
        Path folder = isOfRun
                ? champion.runFolder().get()
                : champion.file().toAbsolutePath().getParent();
        return Objects.requireNonNull(folder).resolve(isOfRun ? name : champion.name() + "-" + name);
    }

    /** A champion that is being evaluated. */
    private final class Job implements AutoCloseable {
        private final long network;
        private final Path table;
        private final Path summary;
        private final EvaluationFile file;
        private final List<GameResult> results;
        private final List<String> remarks = new ArrayList<>();
        private final List<Future<List<GameResult>>> blocks = new ArrayList<>();

        Job(Champion champion, MsPacManTaskSettings settings) {
            network = champion.genotype().id();
            table = place(champion, RunLayout.evaluationGames(rules.label()));
            summary = place(champion, RunLayout.evaluationSummary(rules.label()));
            file = new EvaluationFile(table);
            EvaluationName name = name(champion, settings);
            long[] seeds = name.seeds(games);
            results = new ArrayList<>(begin(name, champion.genotype().modules()));
            keepSummary();
            found.addAndGet(Math.min(games, results.size()));
            for (int first = results.size(); first < games; first += BLOCK) {
                int from = first;
                int to = Math.min(games, first + BLOCK);
                blocks.add(threads.submit(() -> play(settings, champion.genotype(), seeds, from, to)));
            }
        }

        /** Opens the table. If it cannot be read, the lock is released. */
        private List<GameResult> begin(EvaluationName name, int modules) {
            try {
                List<GameResult> found = file.begin(name, modules);
                file.replaced()
                        .ifPresent(old -> remarks.add(table + ": held another evaluation ("
                                + old.table().games().size() + " games; "
                                + old.table().evaluation().text() + "); kept as "
                                + old.copy().getFileName()));
                return found;
            } catch (UserError e) {
                file.close();
                throw e;
            }
        }

        /** Keeps the summary of other games, or of more games than this evaluation has; {@link #finish} replaces it. */
        private void keepSummary() {
            try {
                if (!Files.exists(summary)) {
                    return;
                }
                byte[] content = TextFiles.bytes(summary, TextFiles.SETTINGS_MIB);
                if (results.isEmpty() || gamesIn(content) > Math.max(games, results.size())) {
                    Path copy = KeptFiles.keep(summary, content);
                    remarks.add(summary + ": is the summary of other games; kept as " + copy.getFileName());
                }
            } catch (IOException e) {
                file.close();
                throw FileErrors.unreadable(summary, e);
            }
        }

        /** The number of games in a summary; 0 if it is damaged. */
        private static int gamesIn(byte[] content) throws IOException {
            try {
                return new ObjectMapper().readTree(content).path("games").asInt();
            } catch (JacksonException e) {
                return 0;
            }
        }

        private EvaluationName name(Champion champion, MsPacManTaskSettings settings) {
            return new EvaluationName(
                    networkName(champion),
                    settings.games().version().label(),
                    rules.label(),
                    seed,
                    ghostLocations(settings));
        }

        /** Isolated games depend on the recording too. */
        private String ghostLocations(MsPacManTaskSettings settings) {
            return settings.games().version() == TaskVersion.ISOLATED
                    ? Integer.toHexString(
                            Objects.hashCode(settings.games().rules().ghosts().ghostLocations()))
                    : "";
        }

        ChampionEvaluation finish() throws InterruptedException {
            for (Future<List<GameResult>> block : blocks) {
                List<GameResult> done = get(block);
                file.append(done);
                results.addAll(done);
            }
            ChampionEvaluation evaluation = EvaluationSummary.of(network, rules, seed, results);
            try {
                Path unfinished = summary.resolveSibling(summary.getFileName() + ".new");
                new ObjectMapper().writerWithDefaultPrettyPrinter().writeValue(unfinished.toFile(), evaluation);
                Files.move(
                        unfinished,
                        summary,
                        java.nio.file.StandardCopyOption.REPLACE_EXISTING,
                        java.nio.file.StandardCopyOption.ATOMIC_MOVE);
            } catch (IOException e) {
                throw FileErrors.unwritable(summary, e);
            }
            return evaluation;
        }

        @Override
        public void close() {
            file.close();
        }
    }

    private List<GameResult> play(MsPacManTaskSettings settings, Genotype genotype, long[] seeds, int from, int to) {
        GamePlayer player = new GamePlayer(settings, genotype);
        List<GameResult> results = new ArrayList<>();
        for (int game = from; game < to; game++) {
            results.add(player.play(game, seeds[game]));
            played.incrementAndGet();
        }
        return results;
    }

    private static List<GameResult> get(Future<List<GameResult>> block) throws InterruptedException {
        try {
            return block.get();
        } catch (ExecutionException e) {
            throw new IllegalStateException("a game failed", e.getCause());
        }
    }

    /**
     * A champion with the settings of its games.
     *
     * @param champion the network
     * @param settings from {@link PlayerSettings}, with the rules of this evaluation
     */
    public record Entry(Champion champion, MsPacManTaskSettings settings) {}

    /**
     * Evaluates champions: {@link #begin}, then {@link Evaluations#finish}.
     *
     * @return one evaluation per entry
     * @throws UserError as {@code begin} and {@code finish} do
     */
    public List<ChampionEvaluation> evaluate(List<Entry> entries) throws InterruptedException {
        try (Evaluations evaluations = begin(entries)) {
            return evaluations.finish();
        }
    }

    /**
     * Opens the table of each champion in the folder of its run, or beside a file that belongs to no run, and starts to
     * play. Games of an earlier evaluation with the same seed count. The table and the summary of an evaluation with
     * another seed or another champion are kept as other files.
     *
     * @throws UserError if a table cannot be written or is damaged, or if another evaluation is writing it
     */
    public Evaluations begin(List<Entry> entries) {
        List<Job> jobs = new ArrayList<>();
        try {
            for (Entry entry : entries) {
                Path table = place(entry.champion(), RunLayout.evaluationGames(rules.label()));
                if (jobs.stream().anyMatch(job -> job.table.equals(table))) {
                    throw new UserError(entry.champion().file() + ": another of these champions has the same table, "
                            + table + "; name one of them");
                }
                jobs.add(new Job(entry.champion(), entry.settings()));
            }
        } catch (UserError e) {
            jobs.forEach(Job::close);
            throw e;
        }
        return new Evaluations(jobs);
    }

    /** Evaluations whose games are being played. */
    public final class Evaluations implements AutoCloseable {

        private final List<Job> jobs;

        private Evaluations(List<Job> jobs) {
            this.jobs = jobs;
        }

        /** Remarks on the files that were found, one line each: which evaluation was kept as which file. */
        public List<String> remarks() {
            return jobs.stream().flatMap(job -> job.remarks.stream()).toList();
        }

        /**
         * Waits for the games, and writes the table and the summary of each champion.
         *
         * @return one evaluation per entry
         * @throws UserError if a table or summary cannot be written
         */
        public List<ChampionEvaluation> finish() throws InterruptedException {
            List<ChampionEvaluation> evaluations = new ArrayList<>();
            for (Job job : jobs) {
                evaluations.add(job.finish());
            }
            return evaluations;
        }

        /** Releases the tables. */
        @Override
        public void close() {
            jobs.forEach(Job::close);
        }
    }

    /** The network in the {@link EvaluationName}. */
    private static String networkName(Champion champion) {
        int fingerprint = GenotypeJson.write(champion.genotype()).hashCode();
        return "network " + champion.genotype().id() + " (" + Integer.toHexString(fingerprint) + ")";
    }

    /**
     * The seed of the game of median score in the evaluation of a run's champion; empty if there was none.
     *
     * @throws UserError if its table cannot be read or is damaged
     */
    public static Optional<Long> typicalGame(Champion champion, Path runFolder, Rules rules) {
        return EvaluationTable.read(runFolder.resolve(RunLayout.evaluationGames(rules.label())))
                .filter(table -> table.evaluation().network().equals(networkName(champion))
                        && table.evaluation().rules().equals(rules.label()))
                .map(table -> table.games().stream()
                        .sorted(Comparator.comparingDouble(GameResult::score).thenComparingInt(GameResult::number))
                        .toList())
                .map(results -> results.get(results.size() / 2).seed());
    }

    @Override
    public void close() {
        threads.shutdownNow();
    }
}
