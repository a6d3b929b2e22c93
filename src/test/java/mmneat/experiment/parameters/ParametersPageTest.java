package mmneat.experiment.parameters;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** docs/parameters.md agrees with the catalogue. */
class ParametersPageTest {

    private static final Path PAGE = Path.of("docs", "parameters.md");
    private static final String TABLES = "<!-- From here on made from the catalogue by ParametersPageTest. -->\n";

    @Test
    void page_listsTheCatalogue() throws IOException {
        String page = Files.readString(PAGE);
        String intro = page.substring(0, page.indexOf(TABLES) + TABLES.length());
        String expected = intro + tables();
        if (Boolean.getBoolean("update.docs")) {
            Files.writeString(PAGE, expected);
        }
        assertThat(Files.readString(PAGE))
                .as("made again by: mvn test -Dtest=ParametersPageTest -Dupdate.docs=true")
                .isEqualTo(expected);
    }

    private static String tables() {
        StringBuilder text = new StringBuilder();
        String group = "";
        for (Parameter parameter : ParameterCatalogue.load().all()) {
            if (parameter.support() != Parameter.Support.YES) {
                continue;
            }
            if (!parameter.group().equals(group)) {
                group = parameter.group();
                text.append("\n## ")
                        .append(group)
                        .append("\n\n| parameter | default | allowed | meaning |\n|---|---|---|---|\n");
            }
            text.append("| `")
                    .append(parameter.name())
                    .append("` | ")
                    .append(parameter.defaultValue())
                    .append(" | ")
                    .append(parameter.allowedInWords())
                    .append(" | ")
                    .append(parameter.meaning().replace("|", "\\|"))
                    .append(" |\n");
        }
        text.append("\n## Accepted without effect\n\n").append(names(Parameter.Support.IGNORED));
        text.append("\n## Not supported\n\nAnything but the default is an error.\n\n")
                .append(names(Parameter.Support.NO));
        return text.toString();
    }

    private static String names(Parameter.Support support) {
        StringBuilder text = new StringBuilder();
        for (Parameter parameter : ParameterCatalogue.load().all()) {
            if (parameter.support() == support) {
                text.append("`").append(parameter.name()).append("` ");
            }
        }
        return text.toString().strip() + "\n";
    }
}
