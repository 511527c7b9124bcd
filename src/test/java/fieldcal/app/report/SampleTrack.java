package fieldcal.app.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;

/** A trajectory along a line, and what two cameras see of it; only for pictures, so nothing here is exact. */
final class SampleTrack {
  private static final double GRAVITY = 9.81;
  private static final double[][] CAMERAS = {{-3, 0, 4}, {3, 0, 4}};

  private final Random random;
  private final double x0;
  private final double y0;
  private final double dx;
  private final double dy;
  private final List<double[]> samples = new ArrayList<>();
  private double squares;
  private int residuals;

  SampleTrack(Random random, double x0, double y0, double dx, double dy) {
    this.random = random;
    this.x0 = x0;
    this.y0 = y0;
    this.dx = dx;
    this.dy = dy;
  }

  static double[] grid(double end, List<Double> extra) {
    List<Double> times = new ArrayList<>(extra);
    for (int i = 0; i <= 100; i++) {
      times.add(end * i / 100);
    }
    return times.stream().mapToDouble(Double::doubleValue).sorted().toArray();
  }

  void add(double t, double distance, double height, double speed) {
    samples.add(new double[] {t, x0 + distance * dx, y0 + distance * dy, height, speed});
  }

  /** Hops of a chip kicked at 45 degrees, then rolling; samples and landings. */
  List<PathEvent> hop(
      double vz0, double first, double other, double bounce, double accRoll, double end) {
    List<PathEvent> events = new ArrayList<>();
    double t0 = 0;
    double s0 = 0;
    double v = vz0;
    double vz = vz0;
    for (int hop = 0; vz * vz / (2 * GRAVITY) > 0.01 || hop == 0; hop++) {
      double flight = 2 * vz / GRAVITY;
      for (int i = 0; i <= 20; i++) {
        double t = flight * i / 20;
        if (t0 + t < end) {
          add(t0 + t, s0 + v * t, vz * t - GRAVITY * t * t / 2, v);
        }
      }
      t0 += flight;
      s0 += v * flight;
      if (t0 < end) {
        events.add(new PathEvent(PathEvent.Type.LANDING, t0, x0 + s0 * dx, y0 + s0 * dy));
      }
      v *= hop == 0 ? first : other;
      vz *= bounce;
    }
    if (t0 < end && accRoll < 0) {
      events.add(new PathEvent(PathEvent.Type.ROLLING, t0, x0 + s0 * dx, y0 + s0 * dy));
      double rest = Math.min(-v / accRoll, end - t0);
      for (int i = 1; i <= 60; i++) {
        double t = rest * i / 60;
        add(t0 + t, s0 + v * t + accRoll * t * t / 2, 0, v + accRoll * t);
      }
    }
    return events;
  }

  /** Ends the trajectory where it leaves the field. */
  boolean cutAtField(Field field) {
    int all = samples.size();
    samples.removeIf(
        s -> Math.abs(s[1]) > field.length() / 2 + 0.1 || Math.abs(s[2]) > field.width() / 2 + 0.1);
    return samples.size() < all;
  }

  double duration() {
    return samples.get(samples.size() - 1)[0];
  }

  PathEvent event(PathEvent.Type type, double t) {
    double[] at = at(Math.min(t, duration()));
    return new PathEvent(type, Math.min(t, duration()), at[1], at[2]);
  }

  private double[] at(double t) {
    if (t <= 0) {
      return samples.get(0);
    }
    int i = 1;
    while (i < samples.size() - 1 && samples.get(i)[0] < t) {
      i++;
    }
    double[] a = samples.get(i - 1);
    double[] b = samples.get(i);
    double part = b[0] > a[0] ? (t - a[0]) / (b[0] - a[0]) : 0;
    double[] mixed = new double[5];
    Arrays.setAll(mixed, k -> a[k] + part * (b[k] - a[k]));
    return mixed;
  }

  List<Observations> observe(double outliers, double noiseMm) {
    List<Observations> seen = new ArrayList<>();
    for (int camera = 0; camera < CAMERAS.length; camera++) {
      List<double[]> rows = new ArrayList<>();
      for (double t = -0.3 + 0.004 * camera; t < duration(); t += 0.015) {
        double jittered = t + 0.0004 * random.nextGaussian();
        double[] ball = at(jittered);
        boolean inView = camera == 0 ? ball[1] < 0.5 : ball[1] > -0.5;
        if (inView && random.nextDouble() > 0.05) {
          rows.add(row(CAMERAS[camera], jittered, ball, random.nextDouble() < outliers, noiseMm));
        }
      }
      if (!rows.isEmpty()) {
        seen.add(observations(camera, rows));
      }
    }
    return seen;
  }

  private double[] row(double[] camera, double t, double[] ball, boolean outlier, double noise) {
    double spread = outlier ? 120 : noise;
    double rx = spread * random.nextGaussian();
    double ry = spread * random.nextGaussian();
    boolean used = Math.hypot(rx, ry) < 6 * noise;
    double stretch = ball[3] / (camera[2] - ball[3]);
    double x = ball[1] + stretch * (ball[1] - camera[0]) + rx / 1000;
    double y = ball[2] + stretch * (ball[2] - camera[1]) + ry / 1000;
    double height = ball[3] + 0.0015 * random.nextGaussian() * (1 + stretch);
    if (used) {
      squares += rx * rx + ry * ry;
      residuals += 2;
    }
    return new double[] {t, x, y, rx, ry, height, used ? 1 : 0};
  }

  private static Observations observations(int camera, List<double[]> rows) {
    boolean[] used = new boolean[rows.size()];
    for (int i = 0; i < used.length; i++) {
      used[i] = rows.get(i)[6] > 0;
    }
    return new Observations(
        camera,
        column(rows, 0),
        column(rows, 1),
        column(rows, 2),
        column(rows, 3),
        column(rows, 4),
        column(rows, 5),
        used);
  }

  private static double[] column(List<double[]> rows, int column) {
    return rows.stream().mapToDouble(r -> r[column]).toArray();
  }

  double rmsMm() {
    return Math.sqrt(squares / residuals);
  }

  FittedPath path() {
    return new FittedPath(
        column(samples, 0),
        column(samples, 1),
        column(samples, 2),
        column(samples, 3),
        column(samples, 4));
  }
}
