package mmneat.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CheckpointFileTest {

    @TempDir
    Path directory;

    private CheckpointFile checkpoint;
    private Path newest;
    private Path previous;

    @BeforeEach
    void twoCheckpoints() throws IOException {
        checkpoint = new CheckpointFile(directory);
        newest = directory.resolve("checkpoint.json.gz");
        previous = directory.resolve("checkpoint-previous.json.gz");
        assertThat(checkpoint.load()).isEmpty();
        checkpoint.save(bytes("first"));
        checkpoint.save(bytes("second"));
    }

    @Test
    void newest_isLoaded() throws IOException {
        assertThat(checkpoint.load()).contains(bytes("second"));
        assertThat(directory.toFile().list()).hasSize(2);
    }

    @Test
    void anyChangedByte_isNoticed_andThePreviousUsed() throws IOException {
        byte[] whole = Files.readAllBytes(newest);
        List<String> used = new ArrayList<>();
        // Bytes 4 to 9 of the header (time, flags of the compressor, system) say nothing about the content.
        for (int i = 10; i < whole.length; i++) {
            byte[] damaged = whole.clone();
            damaged[i] ^= 0x10;
            Files.write(newest, damaged);
            // The compressor fills its last byte up with bits that mean nothing.
            assertThat(checkpoint.load().map(String::new))
                    .as("byte %d", i)
                    .get()
                    .isIn("first", "second");
            used.add(checkpoint.load().map(String::new).orElseThrow());
        }
        assertThat(used).filteredOn("second"::equals).hasSizeLessThanOrEqualTo(1);
    }

    @Test
    void cutAnywhere_isNoticed_andThePreviousUsed() throws IOException {
        byte[] whole = Files.readAllBytes(newest);
        for (int length = 0; length < whole.length; length++) {
            Files.write(newest, java.util.Arrays.copyOf(whole, length));
            assertThat(checkpoint.load()).as("cut to %d", length).contains(bytes("first"));
        }
    }

    @Test
    void killedBetweenTheTwoRenames_thePreviousIsUsed() throws IOException {
        Files.move(newest, previous, java.nio.file.StandardCopyOption.REPLACE_EXISTING);
        assertThat(checkpoint.exists()).isTrue();
        assertThat(checkpoint.load()).contains(bytes("second"));
    }

    @Test
    void bothDamaged_isAnErrorThatSaysWhatToDo() throws IOException {
        Files.writeString(newest, "x");
        Files.writeString(previous, "y");
        assertThatThrownBy(checkpoint::load)
                .isInstanceOf(UserError.class)
                .hasMessageContaining("no whole checkpoint")
                .hasMessageContaining("delete " + directory.toAbsolutePath());
    }

    private static byte[] bytes(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }
}
