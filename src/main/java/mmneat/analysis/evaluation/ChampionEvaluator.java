package mmneat.analysis.evaluation;

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
import mmneat.experiment.UserError;
import mmneat.experiment.store.RunLayout;
import mmneat.mspacman.MsPacManTaskSettings;
import mmneat.mspacman.TaskVersion;
import mmneat.neat.Genotype;
import mmneat.neat.io.GenotypeJson;
import mmneat.random.ResumableRandom;

/**
 * Evaluates champions over many games on all cores.
 *
 * <p>Every game has a generator of its own. The seed of game n is the n-th draw from a generator with the evaluation's
 * seed. So the result is the same for any number of threads, and any game can be repeated alone. Games are played in
 * blocks, and blocks are written in order.
 */
public final class ChampionEvaluator implements AutoCloseable {

    private static final int BLOCK = 20;

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

    /** A champion that is being evaluated. */
    private final class Job implements AutoCloseable {
        private final long network;
        private final Path table;
        private final Path summary;
        private final EvaluationFile file;
        private final List<GameResult> results;
        private final List<Future<List<GameResult>>> blocks = new ArrayList<>();

        Job(Champion champion, MsPacManTaskSettings settings) {
            network = champion.genotype().id();
            Path folder =
                    Objects.requireNonNull(champion.file().toAbsolutePath().getParent());
            String prefix = champion.runFolder().isPresent() && isOfRun(champion) ? "" : champion.name() + "-";
            Path place = prefix.isEmpty() ? champion.runFolder().get() : folder;
            table = place.resolve(prefix + RunLayout.evaluationGames(rules.label()));
            summary = place.resolve(prefix + RunLayout.evaluationSummary(rules.label()));
            file = new EvaluationFile(table);
            long[] seeds = seeds(games);
            results = new ArrayList<>(
                    file.begin(name(champion, settings), champion.genotype().modules(), ChampionEvaluator.this::seeds));
            found.addAndGet(Math.min(games, results.size()));
            for (int first = results.size(); first < games; first += BLOCK) {
                int from = first;
                int to = Math.min(games, first + BLOCK);
                blocks.add(threads.submit(() -> play(settings, champion.genotype(), seeds, from, to)));
            }
        }

        /** The champion of the run, not some other network in its folder. */
        private boolean isOfRun(Champion champion) {
            return RunLayout.isNamedAsChampion(champion.file());
        }

        private String name(Champion champion, MsPacManTaskSettings settings) {
            return networkName(champion) + "; "
                    + settings.games().version().label() + " task; " + rules.label()
                    + " rules; seed " + seed + ghostLocations(settings);
        }

        /** Isolated games depend on the recording too. */
        private String ghostLocations(MsPacManTaskSettings settings) {
            return settings.games().version() == TaskVersion.ISOLATED
                    ? "; ghost locations "
                            + Integer.toHexString(Objects.hashCode(
                                    settings.games().rules().ghosts().ghostLocations()))
                    : "";
        }

        ChampionEvaluation finish() throws InterruptedException {
            for (Future<List<GameResult>> block : blocks) {
                List<GameResult> done = get(block);
                file.append(done);
                results.addAll(done);
            }
            ChampionEvaluation evaluation = EvaluationSummary.of(network, rules, results);
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

    private long[] seeds(int count) {
        ResumableRandom random = new ResumableRandom(seed);
        long[] seeds = new long[count];
        for (int game = 0; game < count; game++) {
            seeds[game] = random.nextLong();
        }
        return seeds;
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
     * Evaluates champions and writes the table and the summary of each into the folder of its run, or beside a file
     * that belongs to no run. Games of an earlier evaluation with the same seed are kept.
     *
     * @return one evaluation per entry
     * @throws UserError if a table or summary cannot be written, or if another evaluation is writing it
     */
    public List<ChampionEvaluation> evaluate(List<Entry> entries) throws InterruptedException {
        List<Job> jobs = new ArrayList<>();
        try {
            entries.forEach(entry -> jobs.add(new Job(entry.champion(), entry.settings())));
            List<ChampionEvaluation> evaluations = new ArrayList<>();
            for (Job job : jobs) {
                evaluations.add(job.finish());
            }
            return evaluations;
        } finally {
            jobs.forEach(Job::close);
        }
    }

    /** How the last column of a table of games begins. */
    private static String networkName(Champion champion) {
        int fingerprint = GenotypeJson.write(champion.genotype()).hashCode();
        return "network " + champion.genotype().id() + " (" + Integer.toHexString(fingerprint) + ")";
    }

    /**
     * The seed of the game of median score in the evaluation of a run's champion; empty if there was none.
     *
     * @throws IOException if its table cannot be read
     */
    public static Optional<Long> typicalGame(Champion champion, Path runFolder, Rules rules) throws IOException {
        Path table = runFolder.resolve(RunLayout.evaluationGames(rules.label()));
        if (!Files.exists(table)) {
            return Optional.empty();
        }
        List<String> lines = Files.readAllLines(table);
        if (lines.size() < 2 || !lines.get(1).contains("," + networkName(champion) + ";")) {
            return Optional.empty();
        }
        List<GameResult> results = lines.stream()
                .skip(1)
                .map(GameResult::parse)
                .sorted(Comparator.comparingDouble(GameResult::score).thenComparingInt(GameResult::number))
                .toList();
        return results.isEmpty()
                ? Optional.empty()
                : Optional.of(results.get(results.size() / 2).seed());
    }

    @Override
    public void close() {
        threads.shutdownNow();
    }
}
