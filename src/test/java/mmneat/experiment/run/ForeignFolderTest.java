package mmneat.experiment.run;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.net.StandardProtocolFamily;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.ServerSocketChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Stream;
import java.util.zip.GZIPOutputStream;
import mmneat.evolution.XorTask;
import mmneat.experiment.UserError;
import mmneat.experiment.parameters.ParameterCatalogue;
import mmneat.experiment.parameters.ParameterReader;
import mmneat.experiment.store.SavedCheckpoint;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Folders that another program made or a user changed: a run continues from an undamaged state, or is refused in one
 * line. No file outside of the folder changes.
 */
class ForeignFolderTest {

    private static final JsonMapper JSON = JsonMapper.builder().build();

    @TempDir
    Path base;

    private Path folder;
    private Path outside;

    /** A manual change of a checkpoint. */
    record Edit(String name, Consumer<ObjectNode> change) {
        @Override
        public String toString() {
            return name;
        }
    }

    @BeforeEach
    void finishedRun() throws Exception {
        outside = Files.writeString(base.resolve("thesis.txt"), "years of work");
        folder = base.resolve("runs/1M0");
        assertThat(run(2).phase()).isEqualTo(RunMonitor.Phase.FINISHED);
    }

    static Stream<Edit> damages() {
        return Stream.of(
                edit("no logs", c -> c.putNull("logs")),
                edit("forgotten logs", c -> logs(c).removeAll()),
                edit("negative length", c -> logs(c).put("generations.csv", -1)),
                edit("length that is null", c -> logs(c).putNull("generations.csv")),
                edit("length that is a text", c -> logs(c).put("generations.csv", "0")),
                edit("length beyond the file", c -> logs(c).put("generations.csv", 1L << 40)),
                edit("unforced of null", c -> unsynced(c).putNull("champion.json")),
                edit("unforced from behind", c -> stretch(c, 5, 2)),
                edit("unforced negative", c -> stretch(c, -5, 2)),
                edit("unforced of a terabyte", c -> stretch(c, 0, 1L << 40)),
                edit("no evolution", c -> c.putNull("evolution")),
                edit("evolution removed", c -> c.remove("evolution")),
                edit("unknown field", c -> c.put("code", "evil")),
                edit("other version", c -> c.put("version", 99)),
                edit("other format", c -> c.put("format", "zip")),
                edit("negative generation", c -> evolution(c).put("generation", -1)),
                edit("generation that is null", c -> evolution(c).putNull("generation")),
                edit("earlier generation", c -> evolution(c).put("generation", 1)),
                edit("first generation", c -> evolution(c).put("generation", 0)),
                edit("length that is a fraction", c -> logs(c).put("generations.csv", 1.5)),
                edit("innovations about to overflow", c -> pool(c).put("nextInnovation", Long.MAX_VALUE)),
                edit("genotype ids about to overflow", c -> pool(c).put("nextGenotypeId", Long.MAX_VALUE)),
                edit("neuron that is its own shadow", c -> shadows(c)
                        .put(
                                archetype(c).get(0).get("innovation").asText(),
                                archetype(c).get(0).get("innovation").asLong())),
                edit("fractional generation", c -> evolution(c).put("generation", 1.5)),
                edit("empty population", c -> population(c).removeAll()),
                edit("smaller population", c -> population(c).remove(0)),
                edit("larger population", c -> population(c).add(population(c).get(0))),
                edit("twice the same genotype", c -> population(c)
                        .set(0, population(c).get(1))),
                edit("genotype of null", c -> population(c).set(0, JsonNodeFactory.instance.nullNode())),
                edit("genotype without links", c -> genotype(c).remove("links")),
                edit("weight NaN", c -> link(c).put("weight", "NaN")),
                edit("weight 1e999", c -> link(c).put("weight", new java.math.BigDecimal("1e999"))),
                edit("weight that is null", c -> link(c).putNull("weight")),
                edit(
                        "module usage longer than modules",
                        c -> genotype(c).withArray("moduleUsage").add(1).add(2)),
                edit("pool of null", c -> evolution(c).putNull("pool")),
                edit("nextInnovation of 0", c -> pool(c).put("nextInnovation", 0)),
                edit("nextInnovation removed", c -> pool(c).remove("nextInnovation")),
                edit("nextGenotypeId of 0", c -> pool(c).put("nextGenotypeId", 0)),
                edit("nextGenotypeId removed", c -> pool(c).remove("nextGenotypeId")),
                edit("no archetype", c -> pool(c).putNull("archetype")),
                edit("empty archetype", c -> archetype(c).removeAll()),
                edit("shorter archetype", c -> archetype(c).remove(0)),
                edit("reversed archetype", ForeignFolderTest::reverse),
                edit("exchanged inputs", c -> archetype(c)
                        .insert(1, archetype(c).remove(0))),
                edit("twice the same neuron", c -> archetype(c)
                        .insert(0, archetype(c).get(0))),
                edit("neuron of null", c -> archetype(c).set(0, JsonNodeFactory.instance.nullNode())),
                edit("shadow of nothing", c -> shadows(c).put("77", 78)),
                edit("generator of null", c -> evolution(c).putNull("random")),
                edit("generator of 64 bits", c -> random(c).put("bits", -1)),
                edit("generator without bits", c -> random(c).remove("bits")),
                edit(
                        "Gaussian that is no number",
                        c -> random(c).put("hasCachedGaussian", true).put("cachedGaussian", "NaN")));
    }

    @ParameterizedTest
    @MethodSource("damages")
    void damagedCheckpoint_thePreviousIsUsed(Edit edit) throws Exception {
        change(newest(), edit);
        RunOutcome outcome = run(3);
        assertThat(outcome.phase()).isEqualTo(RunMonitor.Phase.FINISHED);
        assertThat(outcome.message())
                .contains("continued from its previous checkpoint, checkpoint.json.gz: ")
                .doesNotContain("\n", "Exception");
        assertThat(outcome.status().generation()).isEqualTo(3);
    }

    @ParameterizedTest
    @MethodSource("damages")
    void bothCheckpointsDamaged_theRunIsRefused_andNoFileChanges(Edit edit) throws Exception {
        change(newest(), edit);
        Files.copy(
                newest(),
                folder.resolve("checkpoint-previous.json.gz"),
                java.nio.file.StandardCopyOption.REPLACE_EXISTING);
        requireRefused("has no undamaged checkpoint");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "../../thesis.txt",
                "/etc/hostname",
                "..",
                "",
                ".",
                "./generations.csv",
                "initial/../../../thesis.txt",
                "..\\..\\thesis.txt",
                "checkpoint.json.gz",
                "parameters.properties",
                "status.json",
                "notes.txt",
                "generations.csv/",
                "a\u0000b"
            })
    void namesThatAreNotFilesOfTheRun_areRefused_evenWithAnIntactPreviousCheckpoint(String name) throws Exception {
        byte[] whole = Files.readAllBytes(newest());
        change(newest(), edit("log", c -> logs(c).put(name, 0)));
        requireRefused("is not a file of this run");
        Files.write(newest(), whole);
        change(newest(), edit("unforced", c -> unsynced(c)
                .putObject(name)
                .put("from", 0)
                .put("to", 1)
                .put("checksum", 1)));
        requireRefused("is not a file of this run");
    }

    @Test
    void logsOfAnotherFile_areRefused() throws Exception {
        change(newest(), edit("champion as log", c -> logs(c).put("champion.json", 0)));
        requireRefused("'champion.json', which is not a file of this run");
    }

    @Test
    void checkpointTooLargeForTheMemory_isDamaged() throws Exception {
        try (OutputStream bomb = new GZIPOutputStream(Files.newOutputStream(newest()))) {
            byte[] blanks = new byte[1 << 20];
            java.util.Arrays.fill(blanks, (byte) ' ');
            for (int i = 0; i < 64; i++) {
                bomb.write(blanks);
            }
        }
        assertThat(run(3).message()).contains("larger than 20 MiB when unpacked");
    }

    @ParameterizedTest
    @MethodSource("damages")
    void damagedCheckpoint_theMessageNamesNoJavaClass(Edit edit) throws Exception {
        change(newest(), edit);
        assertThat(run(3).message()).doesNotContain("mmneat.", "java.", "Json", "Coercion", ": null;");
    }

    @Test
    void emptyCheckpointFile_isCutOff() throws Exception {
        Files.write(newest(), new byte[0]);
        assertThat(run(3).message()).contains("checkpoint.json.gz: it is cut off");
    }

    @ParameterizedTest
    @ValueSource(strings = {"null", "[]", "{}", "", "[[[[[[[[[[[", "{\"format\":\"mmneat-checkpoint\"}", "\u0000"})
    void textsThatAreNotACheckpoint_areDamaged(String text) throws Exception {
        SavedCheckpoint.write(newest(), text.getBytes(java.nio.charset.StandardCharsets.UTF_8));
        RunOutcome outcome = run(3);
        assertThat(outcome.phase()).isEqualTo(RunMonitor.Phase.FINISHED);
        assertThat(outcome.message().lines()).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "generations.csv",
                "champion.json",
                "status.json",
                "lock.json",
                "parameters.properties",
                "checkpoint.json.gz",
                "checkpoint.json.gz.unfinished",
                "champion.json.unfinished",
                "XorTask-1M0_parents_log.txt",
                "XorTask-1M0_parents_gen9.txt",
                "bestPacMan/score.txt",
                "bestPacMan",
                "gen9"
            })
    void linksInTheFolder_areNotFollowed(String name) throws Exception {
        Path link = folder.resolve(name);
        Path target = name.matches("bestPacMan|gen9") ? Files.createDirectory(base.resolve("mine")) : outside;
        delete(link);
        Files.createSymbolicLink(link, target);
        requireRefused("is a symbolic link");
        Files.delete(link);
        Files.createSymbolicLink(link, base.resolve("absent"));
        requireRefused("is a symbolic link");
        assertThat(base.resolve("absent")).doesNotExist();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"status.json", "lock.json", "parameters.properties", "checkpoint.json.gz", "generations.csv"})
    void socketsInTheFolder_areRefused_asPipesAndDevicesAre(String name) throws Exception {
        Path socket = folder.resolve(name);
        delete(socket);
        try (ServerSocketChannel channel = ServerSocketChannel.open(StandardProtocolFamily.UNIX)) {
            channel.bind(UnixDomainSocketAddress.of(socket));
            String message = "";
            try {
                message = String.valueOf(run(3).message());
            } catch (UserError e) {
                message = String.valueOf(e.getMessage());
            }
            assertThat(message).contains(name + ": is a pipe, socket or device").doesNotContain("\n");
        }
    }

    @Test
    void folderThatIsALinkItself_isTheUsersChoice() throws Exception {
        Path moved = Files.move(folder, base.resolve("elsewhere"));
        Files.createSymbolicLink(folder, moved);
        assertThat(run(3).phase()).isEqualTo(RunMonitor.Phase.FINISHED);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "XorTask-1M0_parents_gen0.txt",
                "blended-2M0_parents_log.txt",
                "Blended-TwoModules0_parameters.txt",
                "archetype0.xml",
                "bestPacMan/bestPacMan.xml",
                "bestObjectives/bestIn0.xml",
                "initial/x_0.xml",
                "gen500/x_0.xml",
                "generations.csv",
                "champion.json",
                "parameters.properties",
                "some.plot"
            })
    void folderWithFilesOfARun_butWithoutACheckpoint_isNotWrittenTo(String name) throws Exception {
        delete(folder);
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        Files.writeString(file, "theirs");
        requireRefused("but no checkpoint to continue it from");
    }

    @Test
    void runWithoutItsCheckpoints_isNotStartedAgain() throws Exception {
        Files.delete(newest());
        Files.delete(folder.resolve("checkpoint-previous.json.gz"));
        requireRefused("but no checkpoint to continue it from");
    }

    @Test
    void run_startsInAnEmptyFolder_orOneWithoutFilesOfARun() throws Exception {
        delete(folder);
        Files.createDirectories(folder);
        Files.writeString(folder.resolve("checkpoint.json.gz.unfinished"), "x");
        Files.writeString(folder.resolve("status.json"), "{}");
        assertThat(run(1).phase()).isEqualTo(RunMonitor.Phase.FINISHED);
    }

    private RunOutcome run(int generations) throws InterruptedException {
        return new ExperimentRunner(ExperimentPlan.of(new ParameterReader(ParameterCatalogue.load())
                        .read(List.of(
                                "task=" + XorTask.class.getName(),
                                "mu=4",
                                "run=0",
                                "maxGens=" + generations,
                                "base=" + base.resolve("runs")))
                        .parameters()))
                .run()
                .get(0);
    }

    /**
     * Checks that the run is refused in one line, before it starts or in its outcome, and that no file in the folder or
     * beside it changes.
     */
    private void requireRefused(String reason) throws Exception {
        Map<String, String> before = files();
        try {
            RunOutcome outcome = run(3);
            assertThat(outcome.phase()).isEqualTo(RunMonitor.Phase.REFUSED);
            assertThat(outcome.message()).contains(reason).doesNotContain("\n");
            assertThat(outcome.failure()).isNull();
        } catch (UserError e) {
            assertThat(e).hasMessageContaining(reason);
        }
        assertThat(files()).isEqualTo(before);
        assertThat(outside).hasContent("years of work");
    }

    /** Returns the content of all files below the base by name; for links, their targets. */
    private Map<String, String> files() throws IOException {
        Map<String, String> files = new TreeMap<>();
        try (Stream<Path> all = Files.walk(base)) {
            for (Path file : all.toList()) {
                files.put(
                        file.toString(),
                        Files.isSymbolicLink(file)
                                ? "-> " + Files.readSymbolicLink(file)
                                : Files.isDirectory(file)
                                        ? ""
                                        : Files.readString(file, java.nio.charset.StandardCharsets.ISO_8859_1));
            }
        }
        return files;
    }

    private Path newest() {
        return folder.resolve("checkpoint.json.gz");
    }

    private static void change(Path file, Edit edit) throws IOException {
        ObjectNode checkpoint = (ObjectNode) JSON.readTree(SavedCheckpoint.json(file));
        edit.change().accept(checkpoint);
        SavedCheckpoint.write(file, JSON.writeValueAsBytes(checkpoint));
    }

    private static void delete(Path path) throws IOException {
        if (!Files.exists(path)) {
            return;
        }
        try (Stream<Path> all = Files.walk(path)) {
            all.sorted(java.util.Comparator.reverseOrder()).forEach(file -> {
                try {
                    Files.delete(file);
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            });
        }
    }

    private static Edit edit(String name, Consumer<ObjectNode> change) {
        return new Edit(name, change);
    }

    private static ObjectNode logs(ObjectNode checkpoint) {
        return (ObjectNode) checkpoint.get("logs");
    }

    private static ObjectNode unsynced(ObjectNode checkpoint) {
        return (ObjectNode) checkpoint.get("unforced");
    }

    private static void stretch(ObjectNode checkpoint, long from, long to) {
        unsynced(checkpoint)
                .putObject("champion.json")
                .put("from", from)
                .put("to", to)
                .put("checksum", 0);
    }

    private static ObjectNode evolution(ObjectNode checkpoint) {
        return (ObjectNode) checkpoint.get("evolution");
    }

    private static ArrayNode population(ObjectNode checkpoint) {
        return (ArrayNode) evolution(checkpoint).get("population");
    }

    private static ObjectNode genotype(ObjectNode checkpoint) {
        return (ObjectNode) population(checkpoint).get(0);
    }

    private static ObjectNode link(ObjectNode checkpoint) {
        return (ObjectNode) genotype(checkpoint).get("links").get(0);
    }

    private static ObjectNode pool(ObjectNode checkpoint) {
        return (ObjectNode) evolution(checkpoint).get("pool");
    }

    private static ArrayNode archetype(ObjectNode checkpoint) {
        return (ArrayNode) pool(checkpoint).get("archetype").get("entries");
    }

    private static ObjectNode shadows(ObjectNode checkpoint) {
        return (ObjectNode) pool(checkpoint).get("archetype").get("shadows");
    }

    private static ObjectNode random(ObjectNode checkpoint) {
        return (ObjectNode) evolution(checkpoint).get("random");
    }

    private static void reverse(ObjectNode checkpoint) {
        ArrayNode entries = archetype(checkpoint);
        List<JsonNode> reversed = new java.util.ArrayList<>();
        entries.forEach(entry -> reversed.add(0, entry));
        entries.removeAll().addAll(reversed);
    }
}
