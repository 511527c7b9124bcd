package fieldcal.app.console;

import com.fasterxml.jackson.databind.JsonNode;
import com.sun.management.OperatingSystemMXBean;
import fieldcal.app.cli.Main;
import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.benchmark.Scratch;
import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * How long an operator with 200 kicks waits, in Debian's chromium: until the page can be used, and for the answer to a click. Times depend on what else the machine does, so that its load is printed; processor times
 * of the page's own thread and of the server depend on it little.
 */
public final class ConsoleBenchmark {
  /** Two of them are hidden by a robot. */
  private static final int KICKS = 212;

  private static final int CLICKS = 20;
  private static final Goal USABLE = Goal.atMost(2000, "%.0f");
  private static final Goal ANSWER = Goal.atMost(100, "%.0f");
  private static final Goal MEMORY = Goal.atMost(512, "%.0f");

  /** Notes when the table and one kick's pictures are there first. */
  private static final String WATCH_OPENING =
      """
      window.opening = {};
      new MutationObserver(() => {
        const note = (name, css) => {
          if (!(name in opening) && document.querySelector(css)) opening[name] = performance.now();
        };
        note('table', '#kicks tr[data-kick]');
        note('kick', '#kick[data-shown] canvas');
        note('model', '#parameters canvas');
      }).observe(document, {subtree: true, childList: true, attributes: true});
      """;

  /** Presses, and tells after how many ms the row, the model's numbers and all pictures are new, each with the painting after it. */
  private static final String CLICK =
      """
      const [css, done] = arguments, node = document.querySelector(css), times = {};
      const row = () => document.querySelector('#kicks tr[data-kick="' + node.closest('tr').dataset.kick + '"]').className;
      const mean = () => document.querySelector('#undo').textContent;
      const [oldRow, oldMean, start] = [row(), mean(), performance.now()];
      const look = () => {
        const now = performance.now() - start;
        if (!('row' in times) && row() !== oldRow) times.row = now;
        if (!('model' in times) && mean() !== oldMean) times.model = now;
        if (!('rest' in times) && 'model' in times && !document.querySelector('[data-waiting]')) times.rest = now;
        if ('rest' in times || now > 20000) done([times.row, times.model, times.rest, performance.now() - start]);
        else requestAnimationFrame(look);
      };
      node.click();
      requestAnimationFrame(look);
      """;

  /** Selects a kick, and tells after how many ms its words, its path and all its pictures are there, each with the painting after it. */
  private static final String SELECT =
      """
      const [id, done] = arguments, kick = document.getElementById('kick'), times = {};
      const row = document.querySelector('#kicks tr[data-kick="' + id + '"]');
      const waits = css => document.querySelector(css + '[data-waiting]');
      const start = performance.now();
      const look = () => {
        const now = performance.now() - start;
        const words = row.getAttribute('aria-selected') === 'true' && document.getElementById('kick-title').textContent.startsWith('Kick ' + id + ' ');
        if (!('words' in times) && words) times.words = now;
        if (!('path' in times) && words && !waits('[data-plot=path]')) times.path = now;
        if (kick.dataset.shown === id && !waits('')) done([times.words, times.path, now]);
        else requestAnimationFrame(look);
      };
      row.click();
      requestAnimationFrame(look);
      """;

  private ConsoleBenchmark() {}

  /**
   * Measures and prints.
   *
   * @param settings how much
   * @param out where to
   * @param findings the numbers of the page
   * @throws IOException when a recording cannot be made
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings)
      throws IOException {
    try (Scratch scratch = new Scratch("fieldcal-console")) {
      Path session = Files.createDirectory(scratch.path().resolve("session"));
      record(session, settings.seed());
      try (RunningConsole console = RunningConsole.start(session);
          Browser browser = new Browser()) {
        JsonNode kicks = console.settled().at("/calibration/report/kicks");
        long observations = 0;
        for (JsonNode kick : kicks) {
          observations += kick.path("observations").asLong();
        }
        out.printf(Locale.ROOT, "%d kicks, %d observations%n", kicks.size(), observations);
        open(console, browser, settings.runs(), out, findings);
        decide(browser, out, findings);
        // What the decisions brought about is not what is measured next.
        browser.awaitGone("#refining");
        console.settled();
        select(browser, out, findings);
        memory(out, findings);
      }
    }
  }

  private static void record(Path session, long seed) throws IOException {
    StringWriter err = new StringWriter();
    int status =
        Main.commandLine()
            .setOut(new PrintWriter(new StringWriter()))
            .setErr(new PrintWriter(err))
            .execute(
                "simulate",
                "--scenario=mixed",
                "--kicks=" + KICKS,
                "--cameras=8",
                "--reception=0.3",
                "--seed=" + seed,
                "--out=" + session.resolve("practice.log.gz"));
    if (status != 0) {
      throw new IOException(err.toString());
    }
  }

  private static void open(
      RunningConsole console, Browser browser, int runs, PrintStream out, Findings findings) {
    browser.command("Page.addScriptToEvaluateOnNewDocument", Map.of("source", WATCH_OPENING));
    browser.command("Performance.enable", Map.of("timeDomain", "threadTicks"));
    double[][] times = new double[4][runs];
    for (int i = 0; i < runs; i++) {
      browser.open("about:blank");
      double before = pageCpu(browser);
      browser.open(console.url());
      browser.await(
          "the page is there",
          d ->
              Boolean.TRUE.equals(browser.script("return 'kick' in opening && 'model' in opening"))
                  ? true
                  : null);
      times[0][i] = number(browser.script("return opening.table"));
      times[1][i] = number(browser.script("return opening.model"));
      times[2][i] = number(browser.script("return opening.kick"));
      times[3][i] = pageCpu(browser) - before;
    }
    tell(findings, "page opened: until the table is there", times[0], USABLE);
    tell(findings, "page opened: until all plots are there", times[2], USABLE);
    print(out, "page opened: the table is there, ms", times[0], USABLE);
    print(out, "  the model's plots", times[1], USABLE);
    print(out, "  the pictures of a kick", times[2], USABLE);
    print(out, "  processor time of the page, ms", times[3], null);
  }

  private static void decide(Browser browser, PrintStream out, Findings findings) {
    double[][] times = new double[5][CLICKS];
    for (int i = 0; i < CLICKS; i++) {
      String css = "#kicks tr[data-kick='" + (3 + 2 * i) + "'] button.use";
      measure(browser, css, times, i);
    }
    tell(findings, "kick dropped by a click: until its row says so", times[0], ANSWER);
    tell(findings, "kick dropped by a click: until the model's numbers are new", times[1], ANSWER);
    print(out, "kick dropped by a click: its row says so, ms", times[0], ANSWER);
    print(out, "  the model's numbers are new", times[1], ANSWER);
    print(out, "  everything is drawn", times[2], null);
    print(out, "  processor time of the page, ms", times[3], null);
    print(out, "  processor time of the server, ms", times[4], null);
  }

  private static void measure(Browser browser, String css, double[][] times, int i) {
    double page = pageCpu(browser);
    double server = serverCpu();
    List<?> answer = (List<?>) browser.scriptThatAnswers(CLICK, css);
    for (int k = 0; k < 3; k++) {
      times[k][i] = number(answer.get(k));
    }
    times[3][i] = pageCpu(browser) - page;
    times[4][i] = serverCpu() - server;
  }

  private static void select(Browser browser, PrintStream out, Findings findings) {
    double[][] times = new double[4][CLICKS];
    for (int i = 0; i < CLICKS; i++) {
      double before = pageCpu(browser);
      List<?> answer = (List<?>) browser.scriptThatAnswers(SELECT, Integer.toString(KICKS / 2 + i));
      for (int k = 0; k < 3; k++) {
        times[k][i] = number(answer.get(k));
      }
      times[3][i] = pageCpu(browser) - before;
    }
    tell(findings, "kick selected by a click: until its numbers are there", times[0], ANSWER);
    tell(findings, "kick selected by a click: until its path is there", times[1], ANSWER);
    tell(findings, "kick selected by a click: until all its plots are there", times[2], ANSWER);
    print(out, "kick selected by a click: its row and its numbers, ms", times[0], ANSWER);
    print(out, "  its path on the field", times[1], ANSWER);
    print(out, "  all its pictures", times[2], ANSWER);
    print(out, "  processor time of the page, ms", times[3], null);
  }

  private static void memory(PrintStream out, Findings findings) {
    double before = heap();
    System.gc();
    out.printf(
        Locale.ROOT,
        "heap of the server with the recording's makers: %.0f MB, %.0f MB after a collection (goal"
            + " %s: %s)%n",
        before,
        heap(),
        MEMORY,
        MEMORY.verdict(heap()));
    findings.value("heap after a collection", "%.0f MB", heap(), MEMORY);
  }

  private static double heap() {
    return ManagementFactory.getMemoryMXBean().getHeapMemoryUsage().getUsed() / 1e6;
  }

  private static double serverCpu() {
    return ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class).getProcessCpuTime()
        / 1e6;
  }

  /** Processor time of the page's own thread until now, ms. */
  private static double pageCpu(Browser browser) {
    List<?> metrics = (List<?>) browser.command("Performance.getMetrics", Map.of()).get("metrics");
    return metrics.stream()
        .map(metric -> (Map<?, ?>) metric)
        .filter(metric -> metric.get("name").equals("TaskDuration"))
        .mapToDouble(metric -> 1000 * number(metric.get("value")))
        .findFirst()
        .orElse(Double.NaN);
  }

  private static double number(Object value) {
    return value instanceof Number n ? n.doubleValue() : Double.NaN;
  }

  private static void tell(Findings findings, String what, double[] values, Goal goal) {
    double[] sorted = values.clone();
    Arrays.sort(sorted);
    findings.value(what + ", median, ms", "%.0f", sorted[sorted.length / 2], goal);
  }

  private static void print(PrintStream out, String what, double[] values, Goal goal) {
    double[] sorted = IntStream.range(0, values.length).mapToDouble(i -> values[i]).toArray();
    Arrays.sort(sorted);
    double median = sorted[sorted.length / 2];
    out.printf(
        Locale.ROOT,
        "%-50s %7.0f (%.0f–%.0f) %8s  %s  load %.1f%n",
        what,
        median,
        sorted[0],
        sorted[sorted.length - 1],
        goal == null ? "" : goal,
        goal == null ? "" : goal.verdict(median),
        ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
  }
}
