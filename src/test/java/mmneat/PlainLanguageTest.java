package mmneat;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * Rules of style that a program can check: vague words, long sentences, long and broken lines. CONTRIBUTING.md has
 * the rules.
 *
 * <p>The specification is exempt from the length of sentences: a rule with all its conditions may be one sentence.
 */
class PlainLanguageTest {

    private static final Path PROJECT = Path.of(System.getProperty("basedir", "."));

    private static final int COLUMNS = 120;

    /** Columns that may stay free at the end of a line although the next word would fit. */
    private static final int FREE_COLUMNS = 30;

    private static final int WORDS = 40;

    /** The comment of a type or package that starts with a question or a verb instead of the noun for the thing. */
    private static final Pattern NO_NOUN_FIRST =
            Pattern.compile("/\\*\\*[\\s*]*((?:What|Who|Whom|Whose|How|Where|Why|Says|Tells|Thinks|Knows)\\b[^\\n]*)"
                    + "(?:(?!\\*/)[\\s\\S])*\\*/\\s*(?:@\\w+(?:\\([^)]*\\))?\\s+)*"
                    + "(?:(?:public|protected|private|static|final|abstract|sealed|non-sealed)\\s+)*"
                    + "(?:class|record|enum|interface|package)\\s");

    /** Vague pronouns, and phrases with a plainer form: only, again, slightly, the user's own, overrides, is not a. */
    private static final Pattern VAGUE = Pattern.compile("(?i)\\b(?:some|no|any)body\\b|\\bwhoever\\b|\\bsomeone\\b"
            + "|\\bnothing but\\b|\\banew\\b|\\bsomewhat\\b|\\bone's own\\b|\\bbecomes? of\\b|\\bgo(?:es)? before\\b"
            + "|\\bnot go (?:with|together)\\b|(?<!\\bthere )\\b(?:is|are) no (?!longer\\b|more\\b|\\W)");

    /** A string or a comment of a Java file; strings are skipped, since they may hold what looks like a comment. */
    private static final Pattern COMMENT =
            Pattern.compile("\"(?:\\\\.|[^\"\\\\\\n])*\"|'(?:\\\\.|[^'\\\\\\n])'|(?s:/\\*.*?\\*/)|//[^\\n]*");

    @Test
    void documents_useNoVagueWords() throws IOException {
        assertThat(findings(documents(), text -> text, VAGUE)).isEmpty();
    }

    @Test
    void commentsOfTheProgram_useNoVagueWords() throws IOException {
        assertThat(findings(files("src", ".java"), PlainLanguageTest::comments, VAGUE))
                .isEmpty();
    }

    @Test
    void messagesOfTheProgram_useNoVagueWords() throws IOException {
        assertThat(findings(files("src/main/java", ".java"), PlainLanguageTest::strings, VAGUE))
                .isEmpty();
    }

    @Test
    void pagesOfTheProgram_useNoVagueWords() throws IOException {
        List<Path> pages = new ArrayList<>();
        for (String ending : List.of(".html", ".css", ".js")) {
            pages.addAll(files("src/main/resources", ending));
        }
        assertThat(pages).isNotEmpty();
        assertThat(findings(pages, text -> text, VAGUE)).isEmpty();
    }

    @Test
    void commentsOfScripts_useNoVagueWords() throws IOException {
        List<Path> scripts = new ArrayList<>(files("scripts", ""));
        scripts.addAll(files(".ci", ""));
        assertThat(scripts).isNotEmpty();
        assertThat(findings(scripts, text -> text, VAGUE)).isEmpty();
    }

    @Test
    void commentsOfTypes_startWithANoun() throws IOException {
        List<String> findings = new ArrayList<>();
        for (Path file : sources()) {
            NO_NOUN_FIRST
                    .matcher(Files.readString(file))
                    .results()
                    .forEach(comment -> findings.add(PROJECT.relativize(file) + ": " + comment.group(1)));
        }
        assertThat(findings).isEmpty();
    }

    @Test
    void linesOfComments_haveAtMost120Characters() throws IOException {
        List<String> tooLong = new ArrayList<>();
        for (Path file : sources()) {
            for (String line : Files.readString(file).split("\n")) {
                if (line.codePointCount(0, line.length()) > COLUMNS && line.matches("\\s*(?:/\\*|\\*|//).*")) {
                    tooLong.add(PROJECT.relativize(file) + ": " + line.strip());
                }
            }
        }
        assertThat(tooLong).isEmpty();
    }

    @Test
    void linesOfProse_haveAtMost120Characters() throws IOException {
        List<String> tooLong = new ArrayList<>();
        for (Path file : documents()) {
            String[] lines = withoutBlocks(Files.readString(file)).split("\n");
            for (String line : lines) {
                // Links and code without a blank cannot be broken; lists of names are made from the catalogue.
                if (line.codePointCount(0, line.length()) > COLUMNS
                        && !line.stripLeading().startsWith("|")
                        && !line.startsWith("#")
                        && !line.startsWith("![")
                        && !line.matches("\\s*\\S+|(?:`\\w+` ?)+")) {
                    tooLong.add(PROJECT.relativize(file) + ": " + line.substring(0, 60));
                }
            }
        }
        assertThat(tooLong).isEmpty();
    }

    @Test
    void paragraphs_fillTheirLines() throws IOException {
        List<String> broken = new ArrayList<>();
        for (Path file : documents()) {
            String[] lines = withoutBlocks(Files.readString(file)).split("\n");
            for (int i = 0; i + 1 < lines.length; i++) {
                String next = lines[i + 1].strip();
                boolean isParagraph = isProse(lines[i]) && isProse(next) && !next.matches("(?:[*-]|\\d+\\.)\\s.*");
                int filled = lines[i].length() + 1 + next.split("\\s")[0].length();
                if (isParagraph && filled <= COLUMNS - FREE_COLUMNS) {
                    broken.add(PROJECT.relativize(file) + ": " + lines[i].strip() + " / " + next);
                }
            }
        }
        assertThat(broken).isEmpty();
    }

    private static boolean isProse(String line) {
        return !line.isBlank() && !line.matches("(?:[|#!>\\[]|<!--).*|.*(?:  |\\\\)");
    }

    @Test
    void sentences_haveAtMost40Words() throws IOException {
        List<String> tooLong = new ArrayList<>();
        for (Path file : documents()) {
            if (file.startsWith(PROJECT.resolve("docs/specification").normalize())) {
                continue;
            }
            for (String sentence : sentences(withoutBlocks(Files.readString(file)))) {
                int words = sentence.strip().split("\\s+").length;
                if (words > WORDS) {
                    tooLong.add(PROJECT.relativize(file) + ", " + words + " words: " + sentence.strip());
                }
            }
        }
        assertThat(tooLong).isEmpty();
    }

    /** Sentences of paragraphs, items of lists, and cells of tables. */
    private static List<String> sentences(String markdown) {
        String separated = markdown.replaceAll("(?m)^#.*$", "\n\n")
                .replaceAll("(?m)^\\s*(?:[*-]|\\d+\\.) ", "\n\n")
                .replaceAll("(?m)^\\s*\\|.*\\|\\s*$", "\n\n$0\n\n")
                .replaceAll("(?m)(?<=[^\\\\])\\|", "\n\n")
                .replaceAll("(?m)^(?:`\\w+` ?)+$", "\n\n")
                .replaceAll("`[^`]*`", "code");
        List<String> sentences = new ArrayList<>();
        for (String paragraph : separated.split("\n\\s*\n")) {
            sentences.addAll(List.of(paragraph.split("(?<=[.:;?!])[)\"*]*\\s+")));
        }
        return sentences;
    }

    private static String withoutBlocks(String markdown) {
        return markdown.replaceAll("(?ms)^```.*?^```", "").replaceAll("(?m)^ {4}.*$", "");
    }

    private static String comments(String java) {
        return parts(java, true);
    }

    private static String strings(String java) {
        return parts(java, false);
    }

    private static String parts(String java, boolean areComments) {
        return COMMENT.matcher(java)
                .results()
                .map(MatchResult::group)
                .filter(part -> part.startsWith("/") == areComments)
                .collect(Collectors.joining("\n"));
    }

    private static List<String> findings(List<Path> files, UnaryOperator<String> extract, Pattern pattern)
            throws IOException {
        List<String> findings = new ArrayList<>();
        for (Path file : files) {
            // Text in code signs is a mention, not a use.
            String text = extract.apply(Files.readString(file))
                    .replaceAll("`[^`\n]*`", "")
                    .replaceAll("\\s*\n\\s*(?:\\*|//|#)?\\s*", " ");
            Matcher matcher = pattern.matcher(text);
            while (matcher.find()) {
                int start = Math.max(0, matcher.start() - 40);
                findings.add(PROJECT.relativize(file) + ": "
                        + text.substring(start, Math.min(text.length(), matcher.end() + 20)));
            }
        }
        return findings;
    }

    private static List<Path> sources() throws IOException {
        List<Path> sources = new ArrayList<>(files("src", ".java"));
        assertThat(sources).isNotEmpty();
        return sources;
    }

    private static List<Path> documents() throws IOException {
        List<Path> documents = new ArrayList<>(files("docs", ".md"));
        try (Stream<Path> top = Files.list(PROJECT)) {
            top.filter(file -> file.toString().endsWith(".md")).sorted().forEach(documents::add);
        }
        documents.removeIf(file -> file.startsWith(PROJECT.resolve("docs/study").normalize()));
        return documents;
    }

    private static List<Path> files(String folder, String ending) throws IOException {
        try (Stream<Path> files = Files.walk(PROJECT.resolve(folder).normalize())) {
            return files.filter(file -> file.toString().endsWith(ending) && Files.isRegularFile(file))
                    .sorted()
                    .toList();
        }
    }
}
