package fieldcal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Whether {@code ./gradlew benchmarkTables} measures what docs/benchmarks.md shows, by the list of what it runs. */
class BenchmarkTablesTest {
  private static final Path LIST = Documents.PROJECT.resolve("gradle/benchmarks.csv");
  private static final Path NAMES =
      Documents.PROJECT.resolve("src/jmh/java/fieldcal/benchmark/Benchmarks.java");
  private static final Path DOCUMENT = Documents.PROJECT.resolve("docs/benchmarks.md");

  /** Measures a table of another document, docs/kswitch.md. */
  private static final String ELSEWHERE = "k-switch";

  private record Row(String section, String program, List<String> words) {}

  private static List<Row> rows() throws IOException {
    return Files.readAllLines(LIST).stream()
        .filter(line -> !line.startsWith("#") && !line.isBlank())
        .map(line -> line.split(" *; *"))
        .map(cells -> new Row(cells[0], cells[1], List.of(cells[2].split(" "))))
        .toList();
  }

  @Test
  void everySectionIsMeasuredInItsPlace() throws IOException {
    List<String> sections =
        Files.readAllLines(DOCUMENT).stream()
            .filter(line -> line.startsWith("## "))
            .map(line -> line.substring(3))
            .toList();
    assertThat(rows().stream().map(Row::section).distinct().toList()).isEqualTo(sections);
  }

  @Test
  void everyBenchmarkIsRun() throws IOException {
    Set<String> run =
        rows().stream()
            .filter(row -> row.program().equals("benchmark"))
            .flatMap(row -> row.words().stream().takeWhile(word -> !word.startsWith("--")))
            .collect(Collectors.toCollection(TreeSet::new));
    run.add(ELSEWHERE);
    Set<String> known =
        Pattern.compile("parts\\.put\\(\"([a-z-]+)\"")
            .matcher(Files.readString(NAMES))
            .results()
            .map(MatchResult::group)
            .map(text -> text.replaceAll(".*\"(.*)\"", "$1"))
            .collect(Collectors.toCollection(TreeSet::new));
    assertThat(run).isEqualTo(known);
  }

  /** The document names amounts as in {@code play --runs 9}. */
  @Test
  void theAmountsAreThoseOfTheDocument() throws IOException {
    List<String> commands =
        rows().stream()
            .filter(row -> row.program().equals("benchmark"))
            .map(row -> String.join(" ", row.words()))
            .toList();
    List<String> named =
        Pattern.compile("`([a-z-]+(?: --(?:runs|minutes) \\d+)+)`")
            .matcher(Files.readString(DOCUMENT))
            .results()
            .map(result -> result.group(1))
            .toList();
    assertThat(named).isNotEmpty();
    for (String name : named) {
      assertThat(commands).as(name).anyMatch(command -> (command + " ").startsWith(name + " "));
    }
  }
}
