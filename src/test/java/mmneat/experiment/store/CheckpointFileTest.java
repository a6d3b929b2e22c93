package mmneat.experiment.store;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.TreeMap;
import mmneat.evolution.EvolutionSettings;
import mmneat.evolution.EvolutionState;
import mmneat.experiment.UserError;
import mmneat.neat.ModuleLayout;
import mmneat.neat.variation.InitialNetworks;
import mmneat.neat.variation.MutationRates;
import mmneat.neat.variation.VariationSettings;
import mmneat.nsga2.Crowding;
import mmneat.nsga2.ParentSelection;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CheckpointFileTest {

    private static final EvolutionSettings SETTINGS = new EvolutionSettings(
            1,
            OptionalInt.empty(),
            2,
            1,
            10,
            new InitialNetworks(2, ModuleLayout.single(1)),
            new ParentSelection(true, 0.5, Crowding.WHOLE_POPULATION),
            new VariationSettings(MutationRates.PUBLISHED));

    private static final EvolutionState STATE = EvolutionState.initial(SETTINGS);

    private static final CheckpointCheck CHECK = new CheckpointCheck(SETTINGS, "x0_");

    @TempDir
    Path directory;

    private CheckpointFile checkpoint;
    private Path newest;
    private Path previous;

    @BeforeEach
    void twoCheckpoints() throws IOException {
        Files.writeString(directory.resolve("x0_score.txt"), "score");
        checkpoint = new CheckpointFile(directory);
        newest = directory.resolve("checkpoint.json.gz");
        previous = directory.resolve("checkpoint-previous.json.gz");
        assertThat(checkpoint.load(CHECK)).isEmpty();
        checkpoint.save(named("first"));
        checkpoint.save(named("second"));
    }

    @Test
    void newest_isLoaded() throws IOException {
        assertThat(loaded()).isEqualTo("second");
        assertThat(directory.toFile().list()).hasSize(3);
    }

    @Test
    void anyChangedByte_isNoticed_andThePreviousUsed() throws IOException {
        byte[] whole = Files.readAllBytes(newest);
        List<String> used = new ArrayList<>();
        // Bytes 4 to 9 of the header (time, flags of the compressor, system) do not depend on the content.
        for (int i = 10; i < whole.length; i += i < whole.length - 10 ? 7 : 1) {
            byte[] damaged = whole.clone();
            damaged[i] ^= 0x10;
            Files.write(newest, damaged);
            // The last byte of the compressor has meaningless padding bits.
            assertThat(loaded()).as("byte %d", i).isIn("first", "second");
            used.add(loaded());
        }
        assertThat(used).filteredOn("second"::equals).hasSizeLessThanOrEqualTo(1);
    }

    @Test
    void cutAnywhere_isNoticed_andThePreviousUsed() throws IOException {
        byte[] whole = Files.readAllBytes(newest);
        for (int length = 0; length < whole.length; length += 7) {
            Files.write(newest, java.util.Arrays.copyOf(whole, length));
            assertThat(loaded()).as("cut to %d", length).isEqualTo("first");
        }
    }

    @Test
    void killedBetweenTheTwoRenames_thePreviousIsUsed() throws IOException {
        Files.move(newest, previous, java.nio.file.StandardCopyOption.REPLACE_EXISTING);
        assertThat(checkpoint.exists()).isTrue();
        assertThat(loaded()).isEqualTo("second");
    }

    @Test
    void bothDamaged_isAnErrorWithAdvice() throws IOException {
        Files.writeString(newest, "x");
        Files.writeString(previous, "y");
        assertThatThrownBy(() -> checkpoint.load(CHECK))
                .isInstanceOf(UserError.class)
                .hasMessageContaining("no undamaged checkpoint")
                .hasMessageContaining("delete " + directory);
    }

    @Test
    void unsyncedCheckpoint_replacesOnlyUnsyncedOnes_soThatASyncedOneAlwaysExists() throws IOException {
        checkpoint.save(withUnsynced("third", "x0_score.txt", "score"));
        checkpoint.save(withUnsynced("fourth", "x0_score.txt", "score"));
        assertThat(loaded()).isEqualTo("fourth");
        Files.delete(newest);
        assertThat(loaded()).isEqualTo("second");
        checkpoint.save(named("fifth"));
        checkpoint.save(withUnsynced("sixth", "x0_score.txt", "score"));
        assertThat(loaded()).isEqualTo("sixth");
        Files.delete(newest);
        assertThat(loaded()).isEqualTo("fifth");
    }

    @Test
    void changedUnsyncedFile_makesThePreviousCheckpointBeUsed() throws IOException {
        checkpoint.save(withUnsynced("third", "x0_score.txt", "score"));
        Path file = directory.resolve("x0_score.txt");
        for (String damaged : List.of("", "scor", "scare", "\0\0\0\0\0")) {
            Files.writeString(file, damaged);
            assertThat(loaded()).as(damaged).isEqualTo("second");
        }
        Files.delete(file);
        assertThat(loaded()).isEqualTo("second");
        // Text that a later generation appended to a log does not matter; it is cut off.
        Files.writeString(file, "score and more");
        assertThat(loaded()).isEqualTo("third");
    }

    /** Returns the name of the log that identifies the loaded checkpoint. */
    private String loaded() throws IOException {
        return checkpoint.load(CHECK).orElseThrow().logs().firstKey().replaceAll("x0_|_log\\.txt", "");
    }

    private static Checkpoint named(String name) {
        return Checkpoint.of(STATE, Map.of("x0_" + name + "_log.txt", 0L), new TreeMap<>());
    }

    private static Checkpoint withUnsynced(String name, String file, String content) {
        UnsyncedFiles unsynced = new UnsyncedFiles(Path.of(""));
        unsynced.replaced(file, content.getBytes(StandardCharsets.UTF_8));
        return Checkpoint.of(STATE, Map.of("x0_" + name + "_log.txt", 0L), unsynced.stretches());
    }
}
