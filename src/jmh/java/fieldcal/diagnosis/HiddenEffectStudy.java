package fieldcal.diagnosis;

import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Findings;
import fieldcal.diagnosis.hidden.FrozenCases;
import fieldcal.diagnosis.hidden.HiddenCase;
import fieldcal.diagnosis.hidden.StudiedCase;
import fieldcal.diagnosis.hidden.Visibility;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CompletionService;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorCompletionService;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * {@code ./gradlew hiddenEffectStudy}: hundreds of drawn cases, diagnosed without the truth and judged with it. Cases are told as they come; the summary is the same for the same seed, times aside.
 */
public final class HiddenEffectStudy {
  private static final String USAGE =
      """
      usage: hiddenEffectStudy -PstudyArgs="…"
        --cases N      how many cases (default 500)
        --seed S       of the whole study (default 1): cases have the seeds S·1000000 and up
        --first N      leaves out the first N cases that would be taken (default 0): shard k of n cases has --first k·n
        --only WHAT    only single, pair, mixture, unnamed or null, or only cases that hide an effect
                       (several: separated by commas)
        --case SEED    this case alone, with everything that the diagnosis tells on its way
        --seeds A,B    exactly these cases, as of failed ones
        --threads N    cases at a time (default 2)
        --rows FILE    appends a line for each case to a file
        --summary A,B  studies nothing: summarizes files of rows
        --small        only cases of at most 14 kicks and 4 cameras
        --list         only prints lines as the list of frozen cases has them
        --classes      only measures how visible the effects are; nothing is diagnosed\
      """;

  private static final long SEEDS = 1_000_000;

  /** Of a study as one of the benchmarks. */
  private static final int CASES_PER_RUN = 12;

  private HiddenEffectStudy() {}

  private static final class Options {
    int cases = 500;
    long seed = 1;
    Optional<Long> one = Optional.empty();
    List<Long> seeds = List.of();
    List<String> only = List.of();
    long first;
    int threads = 2;
    Optional<Path> rows = Optional.empty();
    List<Path> summary = List.of();
    boolean classes;
    boolean small;
    boolean list;
  }

  /**
   * Runs the study.
   *
   * @param args options
   * @throws Exception when it is interrupted
   */
  public static void main(String[] args) throws Exception {
    PrintStream out = new PrintStream(System.out, true, StandardCharsets.UTF_8);
    Options options;
    try {
      options = parse(args);
    } catch (IllegalArgumentException wrong) {
      System.err.println(wrong.getMessage());
      System.err.println(USAGE);
      System.exit(2);
      return;
    }
    if (options.one.isPresent()) {
      new CaseDetails(out).print(HiddenCase.draw(options.one.get()));
      return;
    }
    if (!options.summary.isEmpty()) {
      List<CaseRow> rows = new ArrayList<>();
      for (Path file : options.summary) {
        Files.readAllLines(file).stream().map(CaseRow::parse).forEach(rows::add);
      }
      new StudySummary(rows).print(out);
      return;
    }
    if (options.list) {
      cases(options).forEach(c -> out.println(FrozenCases.line(c, StudiedCase.visibility(c))));
      return;
    }
    List<CaseRow> results = run(options, out);
    if (!options.classes) {
      new StudySummary(results).print(out);
    }
  }

  /**
   * Diagnoses twelve small cases per run, two at a time.
   *
   * @param settings runs and seed
   * @param out told each case and the summary
   * @param findings the rates that have goals
   * @throws Exception when it is interrupted
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings)
      throws Exception {
    Options options = new Options();
    options.cases = CASES_PER_RUN * settings.runs();
    options.seed = settings.seed();
    options.small = true;
    StudySummary summary = new StudySummary(run(options, out));
    summary.print(out);
    summary.tell(findings);
  }

  private static Options parse(String[] args) {
    Options o = new Options();
    for (int i = 0; i < args.length; i++) {
      switch (args[i]) {
        case "--classes" -> o.classes = true;
        case "--small" -> o.small = true;
        case "--list" -> o.list = true;
        default -> i += value(o, args, i);
      }
    }
    return o;
  }

  /** Reads an option with a value; returns how many words that is more than one. */
  private static int value(Options o, String[] args, int i) {
    if (i + 1 == args.length) {
      throw new IllegalArgumentException("'" + args[i] + "' is no option or lacks its value");
    }
    String value = args[i + 1];
    switch (args[i]) {
      case "--cases" -> o.cases = Integer.parseInt(value);
      case "--seed" -> o.seed = Long.parseLong(value);
      case "--case" -> o.one = Optional.of(Long.parseLong(value));
      case "--seeds" -> o.seeds = Arrays.stream(value.split(",")).map(Long::valueOf).toList();
      case "--only" -> o.only = List.of(value.split(","));
      case "--first" -> o.first = Long.parseLong(value);
      case "--rows" -> o.rows = Optional.of(Path.of(value));
      case "--summary" -> o.summary = Arrays.stream(value.split(",")).map(Path::of).toList();
      case "--threads" -> o.threads = Integer.parseInt(value);
      default -> throw new IllegalArgumentException("unknown option " + args[i]);
    }
    return 1;
  }

  private static List<HiddenCase> cases(Options o) {
    if (!o.seeds.isEmpty()) {
      return o.seeds.stream().map(HiddenCase::draw).toList();
    }
    List<HiddenCase> cases = new ArrayList<>();
    long taken = 0;
    for (long i = 0; i < SEEDS && cases.size() < o.cases; i++) {
      HiddenCase c = HiddenCase.draw(o.seed * SEEDS + i);
      boolean wanted = o.only.isEmpty() || o.only.stream().anyMatch(what -> is(c, what));
      boolean fits = !o.small || FrozenCases.small(c);
      if (wanted && fits && taken++ >= o.first) {
        cases.add(c);
      }
    }
    return cases;
  }

  private static boolean is(HiddenCase c, String what) {
    return c.category().name().equalsIgnoreCase(what) || c.hides(what);
  }

  private static List<CaseRow> run(Options o, PrintStream out)
      throws InterruptedException, ExecutionException, IOException {
    List<HiddenCase> cases = cases(o);
    ExecutorService pool = Executors.newFixedThreadPool(o.threads);
    CompletionService<StudiedCase> done = new ExecutorCompletionService<>(pool);
    List<CaseRow> results = new ArrayList<>();
    try {
      for (HiddenCase c : cases) {
        done.submit(() -> o.classes ? visible(c, out) : studied(c));
      }
      for (int n = 1; n <= cases.size(); n++) {
        StudiedCase result = done.take().get();
        if (!o.classes) {
          CaseRow row = CaseRow.of(result);
          results.add(row);
          out.printf(Locale.ROOT, "[%d/%d] %s%n", n, cases.size(), result);
          if (o.rows.isPresent()) {
            Files.writeString(
                o.rows.get(), row + "\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND);
          }
        }
      }
    } finally {
      pool.shutdownNow();
    }
    return results;
  }

  private static StudiedCase studied(HiddenCase c) {
    return StudiedCase.of(c, StudiedCase.visibility(c));
  }

  private static StudiedCase visible(HiddenCase c, PrintStream out) {
    for (Visibility v : StudiedCase.visibility(c)) {
      out.printf(
          Locale.ROOT,
          "%s: left %.2f σ, beside camera offsets %.2f σ: %s%n",
          c,
          v.left(),
          v.leftWithOffsets(),
          v.level());
    }
    return null;
  }
}
