package mmneat.analysis.evaluation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.EnumSet;
import java.util.List;
import mmneat.mspacman.sensors.SensorGroup;
import mmneat.mspacman.sensors.SensorSettings;
import mmneat.mspacman.sensors.suite.SensorSuite;
import org.junit.jupiter.api.Test;

class SensorNamesTest {

    @Test
    void names_differ_evenIfTheOriginalsLabelsDoNot() {
        SensorSettings all = new SensorSettings(EnumSet.allOf(SensorGroup.class), 3, 30, 200, 10, List.of());

        List<String> names = SensorNames.of(SensorSuite.of(all).labels(0));

        assertThat(names)
                .doesNotHaveDuplicates()
                .contains("Ghost 1 no way out", "Threat 1 no way out", "Edible ghost 1 no way out");
    }
}
