package consumer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class ConsumerTest {

    @Test
    void libraries_workTogether_asModules() {
        assertTrue(Consumer.score(1, 1000) > 0);
        assertEquals(0.3, Consumer.evolved(0.3), 0.1);
        assertTrue(Consumer.hypervolume() > 0);
        assertTrue(Consumer.class.getModule().isNamed());
    }

    @Test
    void jackson_isNotForcedOnUsersOfNetworks() {
        assertThrows(ClassNotFoundException.class, () -> Class.forName("com.fasterxml.jackson.databind.ObjectMapper"));
    }
}
