package fieldcal.app.compare;

import fieldcal.app.calibrate.CommandFile;
import fieldcal.app.compare.FieldComparison.Named;
import fieldcal.app.diagnose.DiagnosisSession;
import fieldcal.app.recording.LogOpener;
import fieldcal.app.simulation.RecordingFiles;
import fieldcal.app.wording.EffectName;
import fieldcal.benchmark.BenchmarkSettings;
import fieldcal.benchmark.CpuTime;
import fieldcal.benchmark.Findings;
import fieldcal.benchmark.Goal;
import fieldcal.benchmark.Scratch;
import fieldcal.benchmark.ShareGoal;
import fieldcal.diagnosis.Diagnosis;
import fieldcal.fit.FitSettings;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.TruePrediction;
import fieldcal.simulation.truth.Truth;
import java.io.IOException;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;

/**
 * {@code compare} on drawn pairs of fields: which differences it names, which it invents, and the share of the prediction error of each beside that of the simulator's own physics. Five pairs per run, the
 * last of which differ in nothing.
 */
public final class CompareBenchmark {
  private static final int PAIRS_PER_RUN = 5;

  /** Flat kicks and chips of each side, half of each. */
  private static final int KICKS = 32;

  private static final double CLOSE = 0.15;
  private static final ShareGoal NAMED = ShareGoal.atLeast(0.95);
  private static final ShareGoal INVENTED = ShareGoal.atMost(0.01);
  private static final ShareGoal SHARES = ShareGoal.atLeast(0.95);

  private final PrintStream out;
  private final Map<String, int[]> byPart = new LinkedHashMap<>();
  private int drawn;
  private int named;
  private int invented;
  private int alike;
  private int alikeInvented;
  private int shares;
  private int close;

  private CompareBenchmark(PrintStream out) {
    this.out = out;
    DrawnDifference.PARTS.forEach(p -> byPart.put(p, new int[2]));
  }

  /**
   * Prints each pair, and the counts beside their goals.
   *
   * @param settings runs and seed
   * @param out where to
   * @param findings the numbers of the page
   * @throws IOException when a recording cannot be written
   */
  public static void run(BenchmarkSettings settings, PrintStream out, Findings findings)
      throws IOException {
    CompareBenchmark benchmark = new CompareBenchmark(out);
    for (int i = 0; i < PAIRS_PER_RUN * settings.runs(); i++) {
      benchmark.pair(i, DrawnPair.of(settings.seed(), i));
    }
    benchmark.summary();
    benchmark.tell(findings);
  }

  private void pair(int index, DrawnPair pair) throws IOException {
    try (Scratch scratch = new Scratch("fieldcal-compare-benchmark")) {
      RecordingFiles field = RecordingFiles.besides(scratch.path().resolve("field.log"));
      RecordingFiles simulator = RecordingFiles.besides(scratch.path().resolve("simulator.log"));
      Truth truth = field.write(pair.field(KICKS), share -> {});
      simulator.write(pair.simulator(KICKS), share -> {});
      double before = CpuTime.seconds();
      CompareSession.Outcome outcome =
          new CompareSession(FitSettings.defaults(), LogOpener.USUAL)
              .run(
                  List.of(field.log()),
                  CommandFile.read(field.commands()),
                  List.of(simulator.log()),
                  CommandFile.read(simulator.commands()),
                  List.of(DiagnosisSession.Progress.UNSEEN, DiagnosisSession.Progress.UNSEEN));
      FieldComparison found = outcome.comparison();
      out.printf(
          Locale.ROOT,
          "pair %d: %d differences, compared in %.1f s of CPU%n",
          index + 1,
          pair.differences().size(),
          CpuTime.seconds() - before);
      for (int i = 0; i < pair.differences().size(); i++) {
        String side = pair.ofTheField().get(i) ? "the field" : "the simulator";
        out.printf("  %s: %s%n", side, pair.differences().get(i).words());
      }
      explained("the field", outcome.real());
      explained("the simulator", outcome.sim());
      judge(pair, found);
      shares(pair, found, truth);
    }
  }

  /** What the diagnosis of a side found: where it took another cause than the drawn one, its ball differs for no other reason. */
  private void explained(String name, Side side) {
    Diagnosis d = side.diagnosis().diagnosis();
    List<String> effects = d.model().effects().stream().map(e -> EffectName.of(e)).toList();
    out.printf(
        "  %s was explained by: %s%s%n",
        name,
        effects.isEmpty() ? "nothing" : String.join(", ", effects),
        d.unexplained().significant() ? ", not all" : "");
  }

  private static List<String> ids(FieldComparison found) {
    return Stream.of(
            found.differences().stream().map(Named::id),
            found.cameras().stream()
                .filter(k -> k.differs(FieldComparison.ALPHA))
                .map(c -> c.statistic().id()),
            found.others().stream().filter(Row::differs).map(Row::id))
        .flatMap(s -> s)
        .toList();
  }

  private static List<String> compared(FieldComparison found) {
    return Stream.of(
            found.parameters().stream().map(Row::id),
            found.cameras().stream().map(c -> c.statistic().id()),
            found.others().stream().map(Row::id))
        .flatMap(s -> s)
        .toList();
  }

  private void judge(DrawnPair pair, FieldComparison found) {
    List<String> ids = ids(found);
    List<String> compared = compared(found);
    for (DrawnDifference d : pair.differences()) {
      boolean is = ids.stream().anyMatch(d::isNamedBy);
      drawn++;
      byPart.get(d.part())[0]++;
      if (is) {
        named++;
        byPart.get(d.part())[1]++;
      } else {
        boolean tried = d.part().equals("causes") || compared.stream().anyMatch(d::isNamedBy);
        out.printf("  MISSED %s%s%n", d.words(), tried ? "" : ", which was not compared");
      }
    }
    List<String> strange =
        ids.stream()
            .filter(id -> pair.differences().stream().noneMatch(d -> d.explains(id)))
            .toList();
    strange.forEach(id -> out.printf("  INVENTED %s%s%n", id, sizes(found, id)));
    invented += strange.size();
    if (pair.differences().isEmpty()) {
      alike++;
      alikeInvented += strange.isEmpty() ? 0 : 1;
    }
  }

  private static String sizes(FieldComparison found, String id) {
    List<String> words = new ArrayList<>();
    found.differences().stream()
        .filter(n -> n.id().equals(id))
        .forEach(
            n ->
                words.add(
                    String.format(
                        Locale.ROOT,
                        ": %.5g ± %.2g and %.5g ± %.2g",
                        n.real(),
                        n.realError(),
                        n.sim(),
                        n.simError())));
    found.cameras().stream()
        .filter(c -> c.statistic().id().equals(id))
        .forEach(
            c ->
                words.add(
                    String.format(
                        Locale.ROOT, ": %.5g and %.5g, p %.1g", c.first(), c.second(), c.p())));
    found.others().stream()
        .filter(r -> r.id().equals(id))
        .forEach(
            r ->
                words.add(
                    String.format(
                        Locale.ROOT,
                        ": %.5g ± %.2g and %.5g ± %.2g",
                        r.real(),
                        r.realError(),
                        r.sim(),
                        r.simError())));
    return String.join("", words);
  }

  /** The shares of the named differences of the ball beside those of the simulator's own physics. */
  private void shares(DrawnPair pair, FieldComparison found, Truth truth) {
    SimulationSettings field = pair.field(KICKS);
    TruePrediction prediction = new TruePrediction(field, truth.commandedKicks());
    double total = prediction.error(pair.simulator(KICKS));
    for (DrawnDifference d : pair.differences()) {
      for (Named n : found.differences()) {
        if (d.isNamedBy(n.id())) {
          double left = prediction.error(pair.simulatorBut(d, KICKS));
          double share = (total - left) / total;
          boolean near = Math.abs(share - n.shareOfError()) <= CLOSE;
          shares++;
          close += near ? 1 : 0;
          if (!near) {
            out.printf(
                Locale.ROOT,
                "  SHARE of %s is %.0f %%, said to be %.0f %%; of %.1f and %.1f mm%n",
                n.id(),
                100 * share,
                100 * n.shareOfError(),
                1000 * total,
                1000 * found.predictionError().getOrDefault(Cost.SHARE_HORIZON, Double.NaN));
          }
        }
      }
    }
  }

  private void tell(Findings findings) {
    findings.share("differences named", named, drawn, NAMED);
    findings.share("of these named: not there", invented, named + invented, INVENTED);
    findings.share(
        "share of the prediction error within 15 % of the true one", close, shares, SHARES);
    findings.value(
        "pairs without a difference that have one named, of " + alike,
        "%.0f",
        alikeInvented,
        Goal.atMost(0, "%.0f"));
  }

  private void summary() {
    out.println();
    byPart.forEach((part, n) -> out.printf("%-10s %d of %d named%n", part, n[1], n[0]));
    out.printf("%d of %d pairs without a difference have one named%n", alikeInvented, alike);
    out.println();
    out.println(NAMED.row("differences named", named, drawn));
    out.println(INVENTED.row("named and not there", invented, named + invented));
    out.println(SHARES.row("shares of the error within 15 %", close, shares));
  }
}
