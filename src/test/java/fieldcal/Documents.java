package fieldcal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** README.md and docs/*.md, as the tests read them. */
final class Documents {
  static final Path PROJECT = Path.of(System.getProperty("fieldcal.projectDir", ".")).normalize();

  private static final Pattern LINK = Pattern.compile("\\]\\(([^)\\s]+)\\)");
  private static final Pattern HEADING = Pattern.compile("#{1,6} +(.*)");

  private Documents() {}

  /** README.md, and what docs/ holds, by name. */
  static List<Path> all() throws IOException {
    List<Path> documents = new ArrayList<>();
    documents.add(PROJECT.resolve("README.md"));
    try (Stream<Path> files = Files.list(PROJECT.resolve("docs"))) {
      files.filter(file -> file.toString().endsWith(".md")).sorted().forEach(documents::add);
    }
    return documents;
  }

  /** The lines of its code blocks in a language, "" for any, without blank ones. */
  static List<String> code(Path document, String language) throws IOException {
    List<String> lines = new ArrayList<>();
    String inside = null;
    for (String line : Files.readAllLines(document)) {
      if (line.startsWith("```")) {
        inside = inside == null ? line.substring(3) : null;
      } else if (inside != null
          && (language.isEmpty() || inside.equals(language))
          && !line.isBlank()) {
        lines.add(line.strip());
      }
    }
    return lines;
  }

  /** Its links to other documents, pictures and headings of this project. */
  static List<String> links(Path document) throws IOException {
    List<String> links = new ArrayList<>();
    for (String line : prose(document)) {
      Matcher matcher = LINK.matcher(line);
      while (matcher.find()) {
        if (!matcher.group(1).contains("://")) {
          links.add(matcher.group(1));
        }
      }
    }
    return links;
  }

  /** The names by which its headings are linked to, as the usual hosts make them. */
  static Set<String> anchors(Path document) throws IOException {
    Set<String> anchors = new TreeSet<>();
    for (String line : prose(document)) {
      Matcher matcher = HEADING.matcher(line);
      if (matcher.matches()) {
        String kept =
            matcher.group(1).toLowerCase(Locale.ROOT).replaceAll("[^\\p{L}\\p{N} _-]", "");
        anchors.add(kept.strip().replace(' ', '-'));
      }
    }
    return anchors;
  }

  private static List<String> prose(Path document) throws IOException {
    List<String> lines = new ArrayList<>();
    boolean inside = false;
    for (String line : Files.readAllLines(document)) {
      if (line.startsWith("```")) {
        inside = !inside;
      } else if (!inside) {
        lines.add(line);
      }
    }
    return lines;
  }
}
