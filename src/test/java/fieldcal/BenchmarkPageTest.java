package fieldcal;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;

/** Whether docs/benchmarks.md is what {@code ./gradlew benchmarkPage} wrote: all blocks of one commit, on a machine with nothing else to do. */
class BenchmarkPageTest {
  private static final Path PAGE = Documents.PROJECT.resolve("docs/benchmarks.md");
  private static final Path NAMES =
      Documents.PROJECT.resolve("src/jmh/java/fieldcal/benchmark/Benchmarks.java");
  private static final Pattern BLOCK =
      Pattern.compile("(?s)<!-- measured: ([^>]*?) -->\n(.*?)<!-- end -->");
  private static final Pattern ROW = Pattern.compile("\\| (.+) \\| (.+) \\| (.+) \\| (.+) \\|");
  private static final Set<String> VERDICTS = Set.of("met", "**missed**", "not decided", "–");

  /** A block: arguments, and what was measured with them. */
  private record Block(String arguments, String table) {
    List<MatchResult> rows() {
      return table
          .lines()
          .filter(line -> line.startsWith("| ") && !line.startsWith("| what |"))
          .flatMap(line -> ROW.matcher(line).results())
          .toList();
    }
  }

  private static List<Block> blocks() throws IOException {
    return BLOCK
        .matcher(Files.readString(PAGE))
        .results()
        .map(r -> new Block(r.group(1), r.group(2)))
        .toList();
  }

  @Test
  void everyMarkerNamesBenchmarksAndTheirOptions() throws IOException {
    Set<String> known =
        Pattern.compile("parts\\.put\\(\"([a-z-]+)\"|case \"(--[a-z]+)\"")
            .matcher(Files.readString(NAMES))
            .results()
            .map(r -> r.group(1) == null ? r.group(2) : r.group(1))
            .collect(Collectors.toSet());
    assertThat(blocks()).hasSizeGreaterThan(10);
    for (Block block : blocks()) {
      assertThat(Arrays.stream(block.arguments().split(" ")).filter(w -> !w.matches("\\d+")))
          .as(block.arguments())
          .isSubsetOf(known);
    }
  }

  @Test
  void everyBlockIsMeasuredAndHasAGoalWithAVerdict() throws IOException {
    for (Block block : blocks()) {
      assertThat(block.rows()).as(block.arguments()).isNotEmpty();
      assertThat(block.rows()).anySatisfy(row -> assertThat(row.group(4)).isNotEqualTo("–"));
      for (MatchResult row : block.rows()) {
        assertThat(VERDICTS).as(row.group()).contains(row.group(4));
        assertThat(row.group(3).equals("–")).as(row.group()).isEqualTo(row.group(4).equals("–"));
      }
    }
  }

  @Test
  void thePageNamesOneCommitAndAnIdleMachine() throws IOException {
    String page = Files.readString(PAGE);
    assertThat(page.lines().filter(line -> line.startsWith("Commit "))).hasSize(1);
    assertThat(page)
        .containsPattern(
            "Commit [0-9a-f]{8,}, \\d+ \\w+ \\d{4}, \\d+ cores, Java \\S+, \\d+ minutes\\."
                + " Nothing else ran: ");
    // A table holds no commit of its own.
    assertThat(blocks()).noneSatisfy(b -> assertThat(b.table()).containsIgnoringCase("commit"));
  }
}
