package mmneat.experiment.parameters;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import mmneat.CompiledClasses;
import mmneat.contest.entry.ControllerLoader;
import mmneat.experiment.UserError;
import mmneat.mspacman.MsPacManTask;
import mmneat.mspacman.sensors.Observation;
import mmneat.mspacman.sensors.Sensor;
import mmneat.mspacman.sensors.suite.SensorSuite;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A user's sensors, in a jar and on the class path. A user's tasks are tested with the experiments. */
class OwnClassesTest {

    @TempDir
    Path folder;

    /** A sensor on the class path. */
    public static class Always implements Sensor {
        @Override
        public String label() {
            return "Always";
        }

        @Override
        public double sense(Observation observation) {
            return 1;
        }
    }

    /** A sensor whose constructor fails. */
    public static final class Broken extends Always {
        public Broken() {
            throw new IllegalStateException("no day for sensing");
        }
    }

    /** A sensor of a class that is not public. */
    static final class Hidden extends Always {}

    private static List<String> labels(String... words) {
        MsPacManTask task = (MsPacManTask) Tasks.factory(new ParameterReader(ParameterCatalogue.load())
                        .read(List.of(words))
                        .parameters())
                .get();
        return SensorSuite.of(task.settings().networks().sensors()).labels(-1);
    }

    private static void assertMistake(String message, String... words) {
        assertThatThrownBy(() -> labels(words)).isInstanceOf(UserError.class).hasMessage(message);
    }

    private Path jar() throws IOException {
        Path classes = CompiledClasses.compile(
                folder,
                System.getProperty("java.class.path"),
                "package my; public final class NearExit implements mmneat.mspacman.sensors.Sensor {"
                        + " public String label() { return \"Near Exit\"; }"
                        + " public boolean isDirectional() { return false; }"
                        + " public double sense(mmneat.mspacman.sensors.Observation observation) { return Half.of(); } }",
                "package my; final class Half { static double of() { return 0.5; } }");
        return CompiledClasses.jar(classes, folder.resolve("my-sensors.jar"));
    }

    @Test
    void sensorsOfAJar_andOfTheClassPath_comeAfterTheOthers() throws IOException {
        List<String> labels =
                labels("task=blended", "jar=" + jar(), "ownSensors=my.NearExit, " + Always.class.getName());
        assertThat(labels).hasSize(32).endsWith("Near Exit", "Always in dir -1");
    }

    @ParameterizedTest
    @ValueSource(strings = {"ownSensors", "objectives"})
    void emptyNameInAList_isAMistake(String parameter) {
        for (String list : List.of(",", "my.A,", ",my.A", "my.A,,my.B", " , ")) {
            assertMistake(
                    parameter + "=" + list.strip() + ": a name is missing; separate the names by single commas",
                    "task=blended",
                    parameter + "=" + list);
        }
    }

    @Test
    void jarThatIsNoJar_isAMistakeThatSaysWhatToGive(@TempDir Path places) throws IOException {
        Path source = Files.writeString(places.resolve("Parity.java"), "class Parity {}");
        Path single = Files.writeString(places.resolve("Single.class"), "");
        Path text = Files.writeString(places.resolve("notes.txt"), "notes");
        String compile = ": is source code; compile it first, and give the jar or the folder of its classes";
        assertMistake("jar=" + source + compile, "task=Parity", "jar=" + source);
        assertMistake(
                "jar=" + single + ": is a single class; give the folder of its package, or a jar",
                "task=Parity",
                "jar=" + single);
        assertMistake(
                "jar=" + text + ": is not a readable jar or class folder: zip END header not found",
                "task=Parity",
                "jar=" + text);
        assertMistake(
                "task=my.Parity: there is no such class in " + places + ", but its source code, " + source
                        + "; compile it first",
                "task=my.Parity",
                "jar=" + places);
        assertThatThrownBy(() -> new ControllerLoader(List.of(source)))
                .isInstanceOf(UserError.class)
                .hasMessage("classpath=" + source + compile);
        assertThatThrownBy(() -> new ControllerLoader(List.of(places)).pacMan("Parity"))
                .isInstanceOf(UserError.class)
                .hasMessageEndingWith("but its source code, " + source + "; compile it first");
    }

    @Test
    void unusableSensor_isAnErrorThatNamesIt() throws IOException {
        assertMistake(
                "ownSensors=my.NearExit: there is no such class; name its jar with jar=FILE",
                "task=blended",
                "ownSensors=my.NearExit");
        Path jar = jar();
        assertMistake(
                "ownSensors=my.Nothing: there is no such class in " + jar,
                "task=blended",
                "jar=" + jar,
                "ownSensors=my.Nothing");
        assertMistake(
                "ownSensors=java.lang.String: the class must implement " + Sensor.class.getName(),
                "task=blended",
                "ownSensors=java.lang.String");
        assertMistake(
                "ownSensors=" + Broken.class.getName()
                        + ": cannot be created: java.lang.IllegalStateException: no day for sensing",
                "task=blended",
                "ownSensors=" + Broken.class.getName());
        assertMistake(
                "ownSensors=" + Hidden.class.getName() + ": the class must be public",
                "task=blended",
                "ownSensors=" + Hidden.class.getName());
        assertMistake(
                "task=Nim: must be one of blended, interleaved, isolated, or the name of a class of your own, in jar=FILE",
                "task=Nim");
        assertMistake(
                "jar=none.jar: the file is missing or not readable",
                "task=blended",
                "jar=none.jar",
                "ownSensors=my.NearExit");
    }
}
