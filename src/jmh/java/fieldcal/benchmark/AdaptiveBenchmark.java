package fieldcal.benchmark;

import fieldcal.app.play.EmbeddedPlayField;
import fieldcal.app.play.PlaySession;
import fieldcal.app.play.SessionRequest;
import fieldcal.kick.KickKind;
import fieldcal.simulation.InteractiveField;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraSettings;
import java.io.IOException;
import java.io.PrintStream;
import java.util.Arrays;
import java.util.List;

/** How many kicks it takes until every parameter has a standard error of 1 %: chosen for what they tell, against speeds spread evenly in random order. 10 fields per run. */
final class AdaptiveBenchmark {
  private static final int FIELDS_PER_RUN = 10;
  private static final double PRECISION = 0.01;
  private static final int MOST = 24;

  private AdaptiveBenchmark() {}

  /** Good cameras, and ones that see little. */
  private enum Vision {
    GOOD("4 cameras, 70 Hz, 2 mm"),
    POOR("2 cameras, 30 Hz, 4 mm");

    private final String text;

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
