package mmneat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Every document, section and link that code or a document names exists in this repository. */
class CitationTest {

    private static final Path PROJECT = Path.of(System.getProperty("basedir", "."));

    private static final Set<String> NOT_OURS = Set.of(".git", "target", ".idea", ".gradle", "results");

    /** A document by its path, and the sections that follow its name, if any. */
    private static final Pattern CITATION = Pattern.compile(
            "(docs/[\\w./-]*\\.md)(?:`?, (sections? " + "\\d[\\d.]*(?:(?:, | and | to |, and )\\d[\\d.]*)*))?");

    private static final Pattern NUMBER = Pattern.compile("\\d+(?:\\.\\d+)*");

    private static final Pattern LINK =
            Pattern.compile("\\]\\(([^)\\s]+)(?: \"[^\"]*\")?\\)|<img[^>]* src=\"([^\"]+)\"");

    private static final Pattern HEADING = Pattern.compile("(?m)^#+ +(.*?) *$");

    @Test
    void citationsInJavaFiles_nameDocumentsAndSectionsThatExist() throws IOException {
        List<String> broken = new ArrayList<>();
        int citations = 0;
        for (Path file : files("src", ".java")) {
            // Comment signs and line ends are taken out first: a citation may run over the end of a line.
            String text = Files.readString(file).replaceAll("\\s*\\n\\s*(?:\\*|//)?\\s*", " ");
            citations += check(file, text, broken);
        }
        assertThat(broken).isEmpty();
        assertThat(citations).as("citations found").isGreaterThan(100);
    }

    @Test
    void citationsInDocuments_nameDocumentsAndSectionsThatExist() throws IOException {
        List<String> broken = new ArrayList<>();
        for (Path file : files("", ".md")) {
            check(file, Files.readString(file).replaceAll("\\s*\\n\\s*", " "), broken);
        }
        assertThat(broken).isEmpty();
    }

    @Test
    void sourceLines_nameNoChapterOutsideTheRepository() throws IOException {
        Pattern outside = Pattern.compile("(?<!docs/specification/)(?<![\\w/.\"-])(?:spec/)?"
                + "(?:simulator|controllers|networks|mspacman-task|evolution|original-options)\\.md");
        List<String> broken = new ArrayList<>();
        for (Path file : files("src", ".java")) {
            Matcher matcher = outside.matcher(Files.readString(file));
            while (matcher.find()) {
                broken.add(PROJECT.relativize(file) + ": " + matcher.group());
            }
        }
        assertThat(broken).isEmpty();
    }

    @Test
    void relativeLinksInDocuments_leadToFilesAndHeadingsThatExist() throws IOException {
        List<String> broken = new ArrayList<>();
        int links = 0;
        for (Path file : files("", ".md")) {
            Matcher matcher = LINK.matcher(withoutCode(Files.readString(file)));
            while (matcher.find()) {
                String link = matcher.group(1) != null ? matcher.group(1) : matcher.group(2);
                if (!link.matches("[a-z]+:.*")) {
                    links++;
                    if (!resolves(file, link)) {
                        broken.add(PROJECT.relativize(file) + ": " + link);
                    }
                }
            }
        }
        assertThat(broken).isEmpty();
        assertThat(links).as("links found").isGreaterThan(20);
    }

    @Test
    void pathsInDocuments_exist() throws IOException {
        Pattern path = Pattern.compile("`((?:src|docs|scripts|configs|mazes|\\.ci)/[\\w./-]+)`");
        List<String> broken = new ArrayList<>();
        for (Path file : files("", ".md")) {
            Matcher matcher = path.matcher(Files.readString(file));
            while (matcher.find()) {
                if (!Files.exists(PROJECT.resolve(matcher.group(1)))) {
                    broken.add(PROJECT.relativize(file) + ": " + matcher.group(1));
                }
            }
        }
        assertThat(broken).isEmpty();
    }

    @Test
    void documentsAboutTheOriginal_nameItsVersion() throws IOException {
        List<String> unnamed = new ArrayList<>();
        for (Path file : files("", ".md")) {
            String text = Files.readString(file);
            if (!file.toString().contains("study")
                    && text.toLowerCase(Locale.ROOT).contains("the original")
                    && !text.contains("39084fd")) {
                unnamed.add(PROJECT.relativize(file).toString());
            }
        }
        assertThat(unnamed).isEmpty();
    }

    @Test
    void classesInTheRecipes_exist() throws IOException {
        String guide = Files.readString(PROJECT.resolve("CONTRIBUTING.md"));
        String recipes = guide.substring(guide.indexOf("## Recipes"));
        Set<String> classes = new HashSet<>();
        for (Path file : files("src", ".java")) {
            classes.add(file.getFileName().toString().replace(".java", ""));
        }
        List<String> named = names("`([A-Z]\\w+[a-z])`", recipes);
        named.remove("ModeSelector"); // the end of names in the original
        named.remove("Everyday"); // a group of parameters
        assertThat(named).hasSizeGreaterThan(20);
        assertThat(classes).containsAll(named);
        String architecture = Files.readString(PROJECT.resolve("docs/architecture.md"));
        assertThat(classes).containsAll(names("`([A-Z][a-z]\\w+)`", architecture));
    }

    /** Full names of classes, and names of packages in backticks. */
    @Test
    void fullNamesInDocuments_areClassesAndPackages() throws IOException {
        Set<String> known = new HashSet<>();
        for (Path file : files("src", ".java")) {
            String folders = PROJECT.relativize(file).toString().replace('\\', '/');
            String name = folders.replaceAll(".*?/java/|\\.java$", "").replace('/', '.');
            for (String part = name; part.contains("."); part = part.substring(0, part.lastIndexOf('.'))) {
                known.add(part);
            }
        }
        // A module, and the jar of the program.
        known.addAll(Set.of("mmneat.simulator", "mmneat.jar"));
        List<String> named = new ArrayList<>();
        for (Path file : files("", ".md")) {
            named.addAll(
                    names("(?<![\\w./-])((?:mmneat|pacman)(?:\\.[a-z]\\w*)*\\.[A-Z]\\w+)", Files.readString(file)));
            named.addAll(names("`((?:mmneat|pacman)(?:\\.[a-z]\\w*)+)`", Files.readString(file)));
        }
        assertThat(named).hasSizeGreaterThan(50);
        assertThat(known).containsAll(named);
    }

    private static List<String> names(String pattern, String text) {
        return new ArrayList<>(Pattern.compile(pattern)
                .matcher(text)
                .results()
                .map(name -> name.group(1))
                .toList());
    }

    private static int check(Path file, String text, List<String> broken) throws IOException {
        int citations = 0;
        Matcher matcher = CITATION.matcher(text);
        while (matcher.find()) {
            citations++;
            Path document = PROJECT.resolve(matcher.group(1));
            if (!Files.isRegularFile(document)) {
                broken.add(PROJECT.relativize(file) + ": " + matcher.group());
            } else if (matcher.group(2) != null) {
                Set<String> sections = sections(document);
                Matcher number = NUMBER.matcher(matcher.group(2));
                while (number.find()) {
                    if (!sections.contains(number.group())) {
                        broken.add(PROJECT.relativize(file) + ": " + matcher.group(1) + " has no section "
                                + number.group());
                    }
                }
            }
        }
        return citations;
    }

    private static boolean resolves(Path from, String link) throws IOException {
        int sign = link.indexOf('#');
        String path = sign < 0 ? link : link.substring(0, sign);
        Path target = path.isEmpty() ? from : from.resolveSibling(path).normalize();
        if (!Files.exists(target)) {
            return false;
        }
        return sign < 0 || anchors(target).contains(link.substring(sign + 1));
    }

    /** The numbers at the start of the document's headings: {@code 5} and {@code 5.2}. */
    private static Set<String> sections(Path document) throws IOException {
        Set<String> sections = new HashSet<>();
        for (String heading : headings(document)) {
            Matcher number = NUMBER.matcher(heading);
            if (number.lookingAt()) {
                sections.add(number.group());
            }
        }
        return sections;
    }

    /** The names that GitHub gives to the headings: lower case, blanks as hyphens, other signs left out. */
    private static Set<String> anchors(Path document) throws IOException {
        Set<String> anchors = new HashSet<>();
        for (String heading : headings(document)) {
            String anchor = heading.toLowerCase(Locale.ROOT)
                    .replaceAll("[^\\p{L}\\p{N}_ -]", "")
                    .replace(' ', '-');
            String name = anchor;
            for (int times = 1; !anchors.add(name); times++) {
                name = anchor + "-" + times;
            }
        }
        return anchors;
    }

    private static List<String> headings(Path document) throws IOException {
        return HEADING.matcher(withoutBlocks(Files.readString(document)))
                .results()
                .map(heading -> heading.group(1))
                .toList();
    }

    private static String withoutCode(String markdown) {
        return withoutBlocks(markdown).replaceAll("`[^`\\n]*`", "");
    }

    private static String withoutBlocks(String markdown) {
        return markdown.replaceAll("(?ms)^```.*?^```", "");
    }

    private static List<Path> files(String folder, String ending) throws IOException {
        List<Path> files = new ArrayList<>();
        collect(PROJECT.resolve(folder).normalize(), ending, files);
        return files;
    }

    private static void collect(Path folder, String ending, List<Path> files) throws IOException {
        try (Stream<Path> entries = Files.list(folder.toString().isEmpty() ? Path.of(".") : folder)) {
            entries.sorted().forEach(entry -> {
                String name = entry.getFileName().toString();
                try {
                    if (Files.isDirectory(entry) && !NOT_OURS.contains(name)) {
                        collect(entry, ending, files);
                    } else if (name.endsWith(ending)) {
                        files.add(entry);
                    }
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            });
        }
    }
}
