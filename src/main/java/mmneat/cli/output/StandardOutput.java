package mmneat.cli.output;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.Charset;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * Standard output that remembers the first failure of a write.
 *
 * <p>Print streams and writers ignore such failures. This class keeps them until the command ends, so that every
 * command can report them. After a failure, all further output is discarded.
 */
public final class StandardOutput extends OutputStream {

    private final OutputStream target;
    private @Nullable IOException failure;

    public StandardOutput(OutputStream target) {
        this.target = target;
    }

    /** Returns the encoding that Java chose for {@code System.out}. */
    public static Charset encoding() {
        // The first property exists since Java 19.
        String name = System.getProperty("stdout.encoding", System.getProperty("sun.stdout.encoding"));
        return name == null || !Charset.isSupported(name) ? Charset.defaultCharset() : Charset.forName(name);
    }

    @Override
    public synchronized void write(int b) {
        write(new byte[] {(byte) b}, 0, 1);
    }

    @Override
    public synchronized void write(byte[] bytes, int offset, int length) {
        if (failure == null) {
            try {
                target.write(bytes, offset, length);
            } catch (IOException e) {
                failure = e;
            }
        }
    }

    @Override
    public synchronized void flush() {
        if (failure == null) {
            try {
                target.flush();
            } catch (IOException e) {
                failure = e;
            }
        }
    }

    /**
     * The first failure; empty if everything was written, or if the reader of a pipe has ended, as {@code head} does.
     */
    public synchronized Optional<IOException> failure() {
        return Optional.ofNullable(failure).filter(e -> !isClosedPipe(e));
    }

    private static boolean isClosedPipe(IOException e) {
        String message = String.valueOf(e.getMessage()).toLowerCase(Locale.ROOT);
        // The second and the third message are from Windows.
        return message.contains("broken pipe")
                || message.contains("pipe is being closed")
                || message.contains("pipe has been ended");
    }
}
