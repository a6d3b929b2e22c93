package mmneat.analysis;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;

/**
 * A page in a real Chromium without a window, driven over the DevTools protocol. Collects everything that a reader
 * should never see: console errors, exceptions, requests that leave the page.
 */
public final class HeadlessChromium implements AutoCloseable {

    private static final long PATIENCE_SECONDS = 60;
    private static final int DELETION_ATTEMPTS = 50;

    private final ObjectMapper json = new ObjectMapper();
    private final Process process;
    private final Path profile;
    private final WebSocket socket;
    private final String session;
    private final AtomicInteger lastId = new AtomicInteger();
    private final Map<Integer, CompletableFuture<JsonNode>> answers = new ConcurrentHashMap<>();
    private final Map<String, CompletableFuture<JsonNode>> awaited = new ConcurrentHashMap<>();
    private final List<String> complaints = new CopyOnWriteArrayList<>();

    /**
     * Starts the browser; without one the test is skipped, but fails if the environment says that this is the full
     * check.
     */
    public static HeadlessChromium start() throws IOException {
        Optional<Path> program = Stream.of("chromium", "chromium-browser", "google-chrome")
                .flatMap(name -> Stream.of(System.getenv("PATH").split(java.io.File.pathSeparator))
                        .map(folder -> Path.of(folder, name)))
                .filter(Files::isExecutable)
                .findFirst();
        if (program.isEmpty() && "true".equals(System.getenv("CI"))) {
            throw new AssertionError("Chromium is needed for this test: apt-get install chromium");
        }
        Assumptions.assumeTrue(program.isPresent(), "Chromium is not installed");
        return new HeadlessChromium(program.get());
    }

    private HeadlessChromium(Path program) throws IOException {
        profile = Files.createTempDirectory("chromium");
        process = new ProcessBuilder(
                        program.toString(),
                        "--headless",
                        "--no-sandbox",
                        "--disable-gpu",
                        "--disable-quic",
                        "--no-first-run",
                        "--disable-background-networking",
                        "--disable-component-update",
                        "--disable-sync",
                        "--disable-dev-shm-usage",
                        "--hide-scrollbars",
                        "--remote-debugging-port=0",
                        "--user-data-dir=" + profile,
                        "about:blank")
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start();
        socket = HttpClient.newHttpClient()
                .newWebSocketBuilder()
                .buildAsync(URI.create(address()), new Receiver())
                .orTimeout(PATIENCE_SECONDS, TimeUnit.SECONDS)
                .join();
        String target = call(null, "Target.createTarget", Map.of("url", "about:blank"))
                .get("targetId")
                .asText();
        session = call(null, "Target.attachToTarget", Map.of("targetId", target, "flatten", true))
                .get("sessionId")
                .asText();
        for (String domain : List.of("Page", "Runtime", "Log", "Network")) {
            call(domain + ".enable", Map.of());
        }
    }

    /** The browser says on standard error where it listens. */
    private String address() throws IOException {
        BufferedReader lines = process.errorReader(StandardCharsets.UTF_8);
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            int start = line.indexOf("ws://");
            if (start >= 0) {
                // A thread of its own: since Java 25 the common pool, of one thread on two cores, would be blocked.
                Thread reader = new Thread(() -> lines.lines().forEach(rest -> {}), "chromium-output");
                reader.setDaemon(true);
                reader.start();
                return line.substring(start).strip();
            }
        }
        throw new IOException("Chromium ended before it listened");
    }

    /** Opens a file and waits until it is loaded. */
    public void open(Path page) {
        CompletableFuture<JsonNode> loaded = new CompletableFuture<>();
        awaited.put("Page.loadEventFired", loaded);
        call("Page.navigate", Map.of("url", page.toUri().toString()));
        await(loaded);
    }

    /** Sets the size of the window in CSS pixels. */
    public void resize(int width, int height, boolean phone) {
        call(
                "Emulation.setDeviceMetricsOverride",
                Map.of("width", width, "height", height, "deviceScaleFactor", phone ? 2 : 1, "mobile", phone));
    }

    /** Makes pages see a reader who prefers a dark or a light colour scheme. */
    public void preferDark(boolean dark) {
        call(
                "Emulation.setEmulatedMedia",
                Map.of("features", List.of(Map.of("name", "prefers-color-scheme", "value", dark ? "dark" : "light"))));
    }

    /** The value of an expression; a promise is waited for. */
    public JsonNode evaluate(String expression) {
        JsonNode result =
                call("Runtime.evaluate", Map.of("expression", expression, "awaitPromise", true, "returnByValue", true));
        if (result.has("exceptionDetails")) {
            throw new AssertionError(expression + ": " + result.get("exceptionDetails"));
        }
        return result.get("result").path("value");
    }

    /** Waits until an expression is true. */
    public void waitUntil(String condition) {
        evaluate("new Promise(done => { const look = () => (" + condition
                + ") ? done(true) : requestAnimationFrame(look); look(); })");
    }

    /** The text that an element shows. */
    public String text(String selector) {
        return evaluate("document.querySelector('" + selector + "').textContent")
                .asText();
    }

    /** Presses and releases a key, named as in the browser: "ArrowRight", " ", "End". */
    public void press(String key) {
        call("Input.dispatchKeyEvent", Map.of("type", "keyDown", "key", key));
        call("Input.dispatchKeyEvent", Map.of("type", "keyUp", "key", key));
    }

    /** Presses the mouse in an element and drags it; places are shares of the element's width, at half its height. */
    public void drag(String selector, double from, double to) {
        JsonNode box = evaluate("(r => [r.left, r.top, r.width, r.height])(document.querySelector('" + selector
                + "').getBoundingClientRect())");
        double y = box.get(1).asDouble() + box.get(3).asDouble() / 2;
        double left = box.get(0).asDouble();
        double width = box.get(2).asDouble();
        mouse("mousePressed", left + from * width, y);
        mouse("mouseMoved", left + (from + to) / 2 * width, y);
        mouse("mouseMoved", left + to * width, y);
        mouse("mouseReleased", left + to * width, y);
    }

    /** Clicks the middle of an element. */
    public void click(String selector) {
        drag(selector, 0.5, 0.5);
    }

    private void mouse(String type, double x, double y) {
        boolean down = !type.equals("mouseReleased");
        call(
                "Input.dispatchMouseEvent",
                Map.of("type", type, "x", x, "y", y, "button", "left", "buttons", down ? 1 : 0, "clickCount", 1));
    }

    /** A picture of the window as PNG. */
    public void screenshot(Path file) throws IOException {
        byte[] png = Base64.getDecoder()
                .decode(call("Page.captureScreenshot", Map.of("format", "png"))
                        .get("data")
                        .asText());
        Files.write(file, png);
    }

    /** Console errors and warnings, exceptions, and requests except those for files and inline data. */
    public List<String> complaints() {
        return List.copyOf(complaints);
    }

    private JsonNode call(String method, Map<String, ?> parameters) {
        return call(session, method, parameters);
    }

    private JsonNode call(String to, String method, Map<String, ?> parameters) {
        int id = lastId.incrementAndGet();
        ObjectNode message = json.createObjectNode().put("id", id).put("method", method);
        message.set("params", json.valueToTree(parameters));
        if (to != null) {
            message.put("sessionId", to);
        }
        CompletableFuture<JsonNode> answer = new CompletableFuture<>();
        answers.put(id, answer);
        socket.sendText(message.toString(), true).join();
        JsonNode received = await(answer);
        if (received.has("error")) {
            throw new AssertionError(method + ": " + received.get("error"));
        }
        return received.get("result");
    }

    private static JsonNode await(CompletableFuture<JsonNode> future) {
        try {
            return future.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException | ExecutionException | TimeoutException e) {
            throw new AssertionError("Chromium does not answer", e);
        }
    }

    private void receive(JsonNode message) {
        if (message.has("id")) {
            answers.remove(message.get("id").asInt()).complete(message);
            return;
        }
        String event = message.get("method").asText();
        JsonNode details = message.get("params");
        switch (event) {
            case "Runtime.exceptionThrown" ->
                complaints.add(details.get("exceptionDetails").toString());
            case "Runtime.consoleAPICalled" -> {
                if (List.of("error", "warning", "assert")
                        .contains(details.get("type").asText())) {
                    complaints.add(details.get("args").toString());
                }
            }
            case "Log.entryAdded" -> complaints.add(details.get("entry").toString());
            case "Network.requestWillBeSent" -> {
                String url = details.get("request").get("url").asText();
                if (!url.startsWith("file:") && !url.startsWith("data:") && !url.startsWith("blob:")) {
                    complaints.add("request for " + url);
                }
            }
            default -> {
                // Other events tell nothing that a reader could see.
            }
        }
        CompletableFuture<JsonNode> waiting = awaited.remove(event);
        if (waiting != null) {
            waiting.complete(details);
        }
    }

    @Override
    public void close() throws IOException {
        socket.abort();
        // Its children outlive it a little, and write into the profile until they end.
        List<ProcessHandle> all = Stream.concat(process.descendants(), Stream.of(process.toHandle()))
                .toList();
        process.destroy();
        all.forEach(HeadlessChromium::awaitEnd);
        deleteProfile();
    }

    private static void awaitEnd(ProcessHandle ended) {
        try {
            ended.onExit().get(10, TimeUnit.SECONDS);
        } catch (TimeoutException e) {
            ended.destroyForcibly();
            ended.onExit().join();
        } catch (ExecutionException e) {
            throw new IllegalStateException(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void deleteProfile() throws IOException {
        for (int attempt = 1; ; attempt++) {
            try (Stream<Path> files = Files.walk(profile)) {
                for (Path file :
                        files.sorted(java.util.Comparator.reverseOrder()).toList()) {
                    Files.deleteIfExists(file);
                }
                return;
            } catch (IOException | UncheckedIOException e) {
                // A process that is no longer known may still have put a file there, or taken one away.
                if (attempt == DELETION_ATTEMPTS) {
                    throw e;
                }
            }
            try {
                Thread.sleep(100);
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return;
            }
        }
    }

    /** Puts the pieces of a message together. */
    private final class Receiver implements WebSocket.Listener {
        private final StringBuilder text = new StringBuilder();

        @Override
        public CompletionStage<?> onText(WebSocket from, CharSequence part, boolean last) {
            text.append(part);
            if (last) {
                String message = text.toString();
                text.setLength(0);
                try {
                    receive(json.readTree(message));
                } catch (IOException e) {
                    complaints.add(e.toString());
                }
            }
            from.request(1);
            return null;
        }
    }
}
