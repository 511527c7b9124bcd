package fieldcal.app.statistics;

import fieldcal.fit.CameraView;
import fieldcal.fit.CameraViews;
import fieldcal.fit.KickFit;
import fieldcal.kick.KickEnd;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.apache.commons.math3.fitting.PolynomialCurveFitter;
import org.apache.commons.math3.fitting.WeightedObservedPoint;
import org.apache.commons.math3.stat.StatUtils;

/** What the detections of a kick say of the ball's motion without a model: where it stops, how fast it is, how it is braked. */
final class MeasuredMotion {
  /** Half of the time over which a speed is measured, s. */
  private static final double HALF_SPEED_TIME = 0.1;

  /** Half of the time over which an acceleration is measured, s: at 2 mm of noise and 60 detections it is then good to 0.04 m/s². */
  private static final double HALF_ACCELERATION_TIME = 0.2;

  /** Fewest detections of a measurement. */
  private static final int FEWEST = 10;

  /** Stronger braking is sliding, m/s²: between 0.7 (the strongest rolling deceleration of a simulator) and 2 (the weakest sliding of a carpet). */
  private static final double SLIDES = 1.3;

  /** A ball that stands is not braked any more, m/s. */
  private static final double STANDS = 0.05;

  private static final double[] RANGES = {STANDS, 0.3, 1, 2, 3, 5};

  private final KickFit fit;
  private final CameraViews cameras;
  private final Observations seen;

  private MeasuredMotion(KickFit fit, CameraViews cameras) {
    this.fit = fit;
    this.cameras = cameras;
    seen = fit.kick().observations();
  }

  static MeasuredMotion of(KickFit fit, CameraViews cameras) {
    return new MeasuredMotion(fit, cameras);
  }

  /**
   * A range of speeds.
   *
   * @param from m/s
   * @param to m/s
   */
  record Range(double from, double to) {
    String id() {
      return String.format(Locale.ROOT, "%.2f_%.2f", from, to);
    }

    String words() {
      return from <= STANDS
          ? String.format(Locale.ROOT, "less than %.1f m/s", to)
          : String.format(Locale.ROOT, "%.1f to %.1f m/s", from, to);
    }
  }

  /** Distance from the kick to where the ball stopped; empty when it did not. */
  OptionalDouble rolled() {
    if (fit.kick().end() != KickEnd.STOPPED || seen.size() < FEWEST) {
      return OptionalDouble.empty();
    }
    double end = seen.time(seen.size() - 1);
    double x = 0;
    double y = 0;
    int n = 0;
    for (int i = seen.size() - 1; i >= 0 && seen.time(i) > end - HALF_SPEED_TIME; i--) {
      if (fit.used(i)) {
        x += seen.x(i) - offset(i).offsetX();
        y += seen.y(i) - offset(i).offsetY();
        n++;
      }
    }
    return n == 0
        ? OptionalDouble.empty()
        : OptionalDouble.of(
            Math.hypot(x / n - fit.estimate("x").value(), y / n - fit.estimate("y").value()));
  }

  private CameraView offset(int i) {
    return cameras.get(seen.camera(i));
  }

  /** Speed of the reported position some time after the kick. */
  OptionalDouble speedAfter(double seconds) {
    double at = fit.estimate("t0").value() + seconds;
    double[] line = polynomial(at, HALF_SPEED_TIME, 1);
    return line == null ? OptionalDouble.empty() : OptionalDouble.of(Math.hypot(line[1], line[3]));
  }

  /** Deceleration while rolling, median over what was measured, by speed, m/s². */
  Map<Range, Double> braking() {
    Map<Range, List<Double>> found = new LinkedHashMap<>();
    double end = seen.size() == 0 ? 0 : seen.time(seen.size() - 1);
    for (double at = fit.kick().time() + HALF_ACCELERATION_TIME;
        at + HALF_ACCELERATION_TIME <= end;
        at += HALF_ACCELERATION_TIME) {
      double[] p = polynomial(at, HALF_ACCELERATION_TIME, 2);
      if (p == null) {
        continue;
      }
      double speed = Math.hypot(p[1], p[4]);
      double along = (2 * p[2] * p[1] + 2 * p[5] * p[4]) / speed;
      // All of the stretch must be motion: a ball that stops within it is braked less in the mean.
      if (-along > SLIDES || speed + along * HALF_ACCELERATION_TIME < STANDS) {
        continue;
      }
      for (int r = 0; r + 1 < RANGES.length; r++) {
        if (speed >= RANGES[r] && speed < RANGES[r + 1]) {
          found
              .computeIfAbsent(new Range(RANGES[r], RANGES[r + 1]), k -> new ArrayList<>())
              .add(-along);
        }
      }
    }
    Map<Range, Double> medians = new LinkedHashMap<>();
    found.forEach(
        (range, list) ->
            medians.put(
                range, StatUtils.percentile(list.stream().mapToDouble(v -> v).toArray(), 50)));
    return medians;
  }

  /** Coefficients of x and then of y in time about an instant, least squares; null with too few detections. */
  private double[] polynomial(double at, double half, int degree) {
    List<WeightedObservedPoint> x = new ArrayList<>();
    List<WeightedObservedPoint> y = new ArrayList<>();
    for (int i = 0; i < seen.size(); i++) {
      double t = seen.time(i) - at;
      if (Math.abs(t) <= half && fit.used(i)) {
        x.add(new WeightedObservedPoint(1, t, seen.x(i) - offset(i).offsetX()));
        y.add(new WeightedObservedPoint(1, t, seen.y(i) - offset(i).offsetY()));
      }
    }
    if (x.size() < FEWEST) {
      return null;
    }
    PolynomialCurveFitter fitter = PolynomialCurveFitter.create(degree);
    double[] both = Arrays.copyOf(fitter.fit(x), 2 * degree + 2);
    System.arraycopy(fitter.fit(y), 0, both, degree + 1, degree + 1);
    return both;
  }
}
