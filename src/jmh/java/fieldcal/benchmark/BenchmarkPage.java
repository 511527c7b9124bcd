package fieldcal.benchmark;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * {@code ./gradlew benchmarkPage}: measures what docs/benchmarks.md shows and writes it there. The page itself says what is measured: each marker {@code <!-- measured: ARGUMENTS -->} names what {@link Benchmarks} is
 * started with, in a process of its own; its table replaces what stands between the marker and {@code <!-- end -->}.
 *
 * <p>The whole output of each block is kept in {@code build/benchmarks/COMMIT/NN.txt}. A block that was measured with this commit and these arguments, while nothing else ran, is not measured again. {@code --quick} measures as little as possible, to see
 * that all blocks work; its page is written beside its results.
 */
public final class BenchmarkPage {
  private static final Pattern BLOCK =
      Pattern.compile("(?s)<!-- measured: ([^>]*?) -->\n.*?<!-- end -->");
  private static final Pattern HEAD = Pattern.compile("(?s)<!-- machine -->\n.*?<!-- end -->");
  private static final Pattern FIRST_LINE =
      Pattern.compile("# (.*) \\((\\S+), ([0-9.]+) s, others ([0-9.]+) cores\\)");

  /** What the system itself computes is below that, cores (chosen: a tenth of a core changes a time of two cores by 5 %). */
  private static final double IDLE = 0.1;

  /** How often browsers are looked at, ms. */
  private static final int LOOK = 200;

  private static final String QUICK_KICKS = "--kicks 10";

  private final Path project;
  private final boolean quick;
  private final PrintStream out;

  private BenchmarkPage(Path project, boolean quick, PrintStream out) {
    this.project = project;
    this.quick = quick;
    this.out = out;
  }

  /** A block that was measured: when, how long, what others computed, and its table. */
  private record Result(
      String arguments, LocalDate date, double seconds, double others, String table) {
    /** Null where the text is none of a block that ended. */
    static Result of(String text) {
      Matcher first = FIRST_LINE.matcher(text.lines().findFirst().orElse(""));
      int table = text.lastIndexOf("\n| what |");
      if (!first.matches() || table < 0) {
        return null;
      }
      return new Result(
          first.group(1),
          LocalDate.parse(first.group(2)),
          Double.parseDouble(first.group(3)),
          Double.parseDouble(first.group(4)),
          text.substring(table + 1).strip());
    }
  }

  /**
   * Measures all blocks in their order.
   *
   * @param args {@code --quick} or nothing
   * @throws Exception when a block cannot be measured
   */
  public static void main(String[] args) throws Exception {
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    boolean quick = List.of(args).equals(List.of("--quick"));
    if (args.length > 0 && !quick) {
      System.err.println("usage: [--quick]");
      System.exit(2);
      return;
    }
    Path project = Path.of(System.getProperty("fieldcal.projectDir", ".")).toAbsolutePath();
    System.exit(new BenchmarkPage(project, quick, out).measure() ? 0 : 1);
  }

  private boolean measure() throws IOException, InterruptedException {
    String changes = MeasuredCommit.changes(project);
    if (!quick && !changes.isBlank()) {
      System.err.print(
          "commit these first, so that the page can name what was measured:\n" + changes);
      return false;
    }
    String commit = MeasuredCommit.of(project);
    Path results = project.resolve("build/benchmarks").resolve(quick ? "quick" : commit);
    Files.createDirectories(results);
    FieldcalProcess.run(project, List.of("--help")); // builds, when something has changed
    Path document = project.resolve("docs/benchmarks.md");
    String page = Files.readString(document);
    List<Result> measured = new ArrayList<>();
    Matcher blocks = BLOCK.matcher(page);
    StringBuilder filled = new StringBuilder();
    while (blocks.find()) {
      Path file = results.resolve(String.format("%02d.txt", measured.size() + 1));
      Result result = result(file, quick ? little(blocks.group(1)) : blocks.group(1));
      measured.add(result);
      blocks.appendReplacement(
          filled,
          Matcher.quoteReplacement(
              "<!-- measured: " + blocks.group(1) + " -->\n" + result.table() + "\n<!-- end -->"));
    }
    blocks.appendTail(filled);
    String head = "<!-- machine -->\n" + machine(commit, measured) + "\n<!-- end -->";
    String whole = HEAD.matcher(filled).replaceFirst(Matcher.quoteReplacement(head));
    Path written = quick ? results.resolve("benchmarks.md") : document;
    Files.writeString(written, whole);
    out.printf("%nwrote %s%n", project.relativize(written));
    return true;
  }

  /** As little as the benchmarks take. */
  private static String little(String arguments) {
    return arguments
        .replaceAll("--kicks \\d+", QUICK_KICKS)
        .replaceAll("--(runs|minutes) \\d+", "--$1 1")
        .replaceAll("--megabytes \\d+", "--megabytes 5");
  }

  private Result result(Path file, String arguments) throws IOException, InterruptedException {
    Result before = Files.exists(file) ? Result.of(Files.readString(file)) : null;
    if (before != null
        && before.arguments().equals(arguments)
        && (quick || before.others() <= IDLE)) {
      out.printf("%s: was measured%n", arguments);
      return before;
    }
    Path running = file.resolveSibling(file.getFileName() + ".running");
    OwnCpu begin = OwnCpu.now();
    List<String> command =
        new ArrayList<>(
            List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-Dfieldcal.projectDir=" + project,
                "-Dfile.encoding=UTF-8",
                "-cp",
                System.getProperty("java.class.path"),
                Benchmarks.class.getName()));
    command.addAll(List.of(arguments.split(" ")));
    Process block =
        new ProcessBuilder(command)
            .directory(project.toFile())
            .redirectErrorStream(true)
            .redirectOutput(running.toFile())
            .start();
    BrowserCpu browsers = new BrowserCpu(block.toHandle());
    while (!block.waitFor(LOOK, TimeUnit.MILLISECONDS)) {
      browsers.look();
    }
    if (block.exitValue() != 0) {
      throw new IOException(arguments + " ended with " + block.exitValue() + "; see " + running);
    }
    OwnCpu end = OwnCpu.now();
    String text =
        String.format(
            Locale.ROOT,
            "# %s (%s, %.1f s, others %.3f cores)%n%s",
            arguments,
            LocalDate.now(ZoneOffset.UTC),
            end.seconds(begin),
            end.othersSince(begin, browsers.seconds()),
            Files.readString(running));
    Result result = Result.of(text);
    if (result == null) {
      throw new IOException(arguments + " printed no table; see " + running);
    }
    Files.writeString(file, text);
    Files.delete(running);
    out.printf(
        Locale.ROOT,
        "%s: %.0f s, others computed on %.2f cores%n",
        arguments,
        result.seconds(),
        result.others());
    return result;
  }

  private static String machine(String commit, List<Result> measured) {
    LocalDate last = measured.stream().map(Result::date).max(LocalDate::compareTo).orElseThrow();
    double minutes = measured.stream().mapToDouble(Result::seconds).sum() / 60;
    double others = measured.stream().mapToDouble(Result::others).max().orElseThrow();
    String idle =
        others <= IDLE
            ? "Nothing else ran: other programs took at most %.2f cores during a block."
            : "**The machine was busy**: other programs took up to %.2f cores during a block.";
    return String.format(
        Locale.ROOT,
        "Commit %s, %s, %d cores, Java %s, %.0f minutes. " + idle,
        commit,
        last.format(DateTimeFormatter.ofPattern("d MMMM yyyy", Locale.ENGLISH)),
        Runtime.getRuntime().availableProcessors(),
        Runtime.version(),
        minutes,
        others);
  }
}
