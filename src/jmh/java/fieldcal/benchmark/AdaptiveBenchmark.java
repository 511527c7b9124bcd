package fieldcal.benchmark;

import fieldcal.app.play.EmbeddedPlayField;
import fieldcal.app.play.KickResult;
import fieldcal.app.play.PlaySession;
import fieldcal.app.play.SessionRequest;
import fieldcal.calibration.Average;
import fieldcal.calibration.Sample;
import fieldcal.calibration.TwoSigma;
import fieldcal.kick.KickKind;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraSettings;
import java.io.IOException;
import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;

/**
 * How many kicks it takes until every parameter is known to 1 %, by its standard error and by the truth: chosen for what they tell, against speeds spread evenly in random order. 10 fields per run. The
 * truth is asked on drawn fields whose kicks scatter by their spin.
 */
final class AdaptiveBenchmark {
  private static final int FIELDS_PER_RUN = 10;
  private static final double PRECISION = 0.01;
  private static final int MOST = 24;

  /** After so many good kicks the error is looked at. */
  private static final int[] AFTER = {6, 9, 12, 18, 24};

  /** Scatter of spin from kick to kick, in units of rolling spin (chosen: half of what the kicks of ten matches of 2026 had, robots that stand kick more evenly). */
  private static final double SPIN = 0.1;

  /** Sets of kicks that are drawn for each field where nothing is played. */
  private static final int DRAWS = 40;

  /** Error of a kick that is measured without any, next to its scatter. */
  private static final double EXACT = 1e-9;

  private AdaptiveBenchmark() {}

  /** Good cameras, and ones that see little. */
  private enum Vision {
    GOOD("4 cameras, 70 Hz, 2 mm"),
    POOR("2 cameras, 30 Hz, 4 mm");

    private final String text;

    /** On a field whose cameras disagree already. */
    CameraSettings cameras(CameraSettings drawn) {
      return this == GOOD
          ? drawn
          : cameras().withRegistration(drawn.ballPlane(), drawn.disagreement());
    }

    Vision(String text) {
      this.text = text;
    }

    CameraSettings cameras() {
      CameraSettings d = CameraSettings.DEFAULT;
      return this == GOOD
          ? d
          : new CameraSettings(
              2,
              6,
              d.distortion(),
              0.004,
              0.005,
              d.robotAngleNoise(),
              29,
              31,
              d.ballPlane(),
              0,
              d.overlap());
    }
  }

  static void run(BenchmarkSettings settings, PrintStream out) throws IOException {
    int fields = FIELDS_PER_RUN * settings.runs();
    out.printf("kicks made until every standard error is below 1 %%, %d fields each%n", fields);
    out.printf(
        "%-24s %-5s %-9s %6s %7s %5s %10s%n",
        "vision", "kind", "plan", "mean", "median", "most", "field time");
    for (Vision vision : Vision.values()) {
      for (KickKind kind : KickKind.values()) {
        for (boolean adaptive : new boolean[] {false, true}) {
          row(vision, kind, adaptive, fields, settings.seed(), out);
        }
      }
    }
    truth(settings, out);
  }

  /** Largest error of the three parameters by the truth, relative, by the number of good kicks. */
  private static double[] trueErrors(
      SessionRequest request, SimulationSettings world, Map<String, Double> truth)
      throws IOException {
    double[] errors = new double[MOST + 1];
    Arrays.fill(errors, Double.NaN);
    InteractiveField field =
        InteractiveField.of(world, request.first(), request.second(), List.of());
    new PlaySession(
            request,
            new EmbeddedPlayField(field, Double.POSITIVE_INFINITY),
            s -> {
              int good = (int) s.kicks().stream().filter(KickResult::good).count();
              if (good <= MOST && s.model().size() == 3) {
                errors[good] =
                    s.model().entrySet().stream()
                        .mapToDouble(e -> Math.abs(e.getValue().mean() / truth.get(e.getKey()) - 1))
                        .max()
                        .orElseThrow();
              }
            })
        .run();
    return errors;
  }

  /** The first number of good kicks from which on the error stays below the precision; one more than all when it does not. */
  private static int reached(double[] errors) {
    int n = MOST + 1;
    while (n > 1 && errors[n - 1] <= PRECISION) {
      n--;
    }
    return n;
  }

  private static void truth(BenchmarkSettings settings, PrintStream out) throws IOException {
    int fields = FIELDS_PER_RUN * settings.runs();
    out.printf(
        "%nlargest true error of the three parameters, median in %% (share of fields below 1 %%),"
            + " %d fields each; good kicks from which on it stays below 1 %% (%d = never)%n",
        fields, MOST + 1);
    out.printf("%-24s %-5s %-9s", "vision", "kind", "plan");
    for (int n : AFTER) {
      out.printf(" %14s", "after " + n);
    }
    out.printf(" %10s %6s %7s%n", "kicks", "mean", "median");
    for (Vision vision : Vision.values()) {
      for (KickKind kind : KickKind.values()) {
        for (boolean adaptive : new boolean[] {false, true}) {
          trueRow(vision, kind, adaptive, fields, settings.seed(), out);
        }
      }
    }
    for (KickKind kind : KickKind.values()) {
      for (boolean rule : new boolean[] {true, false}) {
        boundRow(kind, rule, fields, settings.seed(), out);
      }
    }
  }

  /**
   * What no choice of kicks is better than: on the same fields, each kick is measured without any error, and only what differs from kick to kick is left. The parameter that its spin changes most decides: of a ball with the fraction f of rolling spin, kSwitch and the first
   * hop's damping p become p + (1 − p)·f, since f of the slip is gone.
   */
  private static void boundRow(
      KickKind kind, boolean rule, int fields, long firstSeed, PrintStream out) {
    String name = kind == KickKind.FLAT ? "kSwitch" : "dampingXyFirstHop";
    double[][] errors = new double[fields * DRAWS][MOST + 1];
    for (int i = 0; i < errors.length; i++) {
      long seed = seed(firstSeed, i / DRAWS);
      double truth = DrawnField.of(seed).truth().get(name);
      SplittableRandom random = new SplittableRandom(seed * DRAWS + i % DRAWS);
      List<Sample> samples = new ArrayList<>();
      for (int n = 1; n <= MOST; n++) {
        double value = truth + (1 - truth) * SPIN * random.nextGaussian();
        samples.add(new Sample(n, name, value, EXACT, Optional.empty()));
        List<Sample> judged = rule ? TwoSigma.repeated(samples) : samples;
        errors[i][n] = Math.abs(Average.of(judged).mean() / truth - 1);
      }
    }
    print("no error at all", kind, rule ? "2σ rule" : "all kicks", errors, out);
  }

  private static long seed(long firstSeed, int field) {
    return 61_000 + 1000 * firstSeed + field;
  }

  private static void trueRow(
      Vision vision, KickKind kind, boolean adaptive, int fields, long firstSeed, PrintStream out)
      throws IOException {
    double[][] errors = new double[fields][];
    for (int i = 0; i < fields; i++) {
      long seed = seed(firstSeed, i);
      DrawnField drawn = DrawnField.of(seed);
      SimulationSettings world =
          drawn.settings().withCameras(vision.cameras(drawn.settings().cameras()));
      errors[i] =
          trueErrors(
              SessionRequest.of(kind, MOST).withChoice(adaptive, seed),
              world.withKickBehaviour(world.kickBehaviour().withRollSpin(0, SPIN)),
              drawn.truth());
    }
    print(vision.text, kind, adaptive ? "adaptive" : "spread", errors, out);
  }

  private static void print(
      String vision, KickKind kind, String plan, double[][] errors, PrintStream out) {
    int fields = errors.length;
    out.printf("%-24s %-5s %-9s", vision, kind.id(), plan);
    for (int n : AFTER) {
      double[] now = Arrays.stream(errors).mapToDouble(e -> e[n]).sorted().toArray();
      long well = Arrays.stream(now).filter(e -> e <= PRECISION).count();
      out.printf(" %6.2f (%3.0f %%)", 100 * now[fields / 2], 100.0 * well / fields);
    }
    int[] reached = Arrays.stream(errors).mapToInt(AdaptiveBenchmark::reached).sorted().toArray();
    double mean = Arrays.stream(reached).average().orElse(Double.NaN);
    out.printf(" %10s %6.2f %7d%n", "", mean, reached[fields / 2]);
  }

  private static void row(
      Vision vision, KickKind kind, boolean adaptive, int fields, long firstSeed, PrintStream out)
      throws IOException {
    double[] made = new double[fields];
    double time = 0;
    for (int i = 0; i < fields; i++) {
      long seed = 31_000 + 1000 * firstSeed + i;
      SessionRequest request = SessionRequest.of(kind, MOST).withChoice(adaptive, seed, PRECISION);
      InteractiveField field =
          InteractiveField.of(
              SimulationSettings.DEFAULT.withSeed(seed).withCameras(vision.cameras()),
              request.first(),
              request.second(),
              List.of());
      PlaySession.Outcome outcome =
          new PlaySession(request, new EmbeddedPlayField(field, Double.POSITIVE_INFINITY), s -> {})
              .run();
      made[i] = outcome.last().kicks().size();
      time += outcome.last().time();
    }
    Arrays.sort(made);
    out.printf(
        "%-24s %-5s %-9s %6.2f %7.0f %5.0f %8.0f s%n",
        vision.text,
        kind.id(),
        adaptive ? "adaptive" : "spread",
        Arrays.stream(made).sum() / fields,
        made[fields / 2],
        made[fields - 1],
        time / fields);
  }
}
