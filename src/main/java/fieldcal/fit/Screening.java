package fieldcal.fit;

import java.util.Arrays;
import java.util.Objects;

/**
 * Data screening of one kick: tells detections of something else than the ball from what a wrong model makes of good ones. Calibration, live monitoring and
 * diagnosis all ask here.
 *
 * <p>An outlier stands alone: it is far from the fitted path and also from where the same camera saw the ball just before and after. A detection that is far
 * from the path while its neighbours are off alike is no outlier but lack of fit: it is kept, and counted. What the neighbours say needs no model of the
 * ball: their median residual, on each side and between both. Immutable.
 */
public final class Screening {
  /** What a detection is. */
  public enum Verdict {
    /** Within the limit of the fitted path. */
    FITS,
    /** Far from the path, but neighbours of the same camera are off alike: the model is wrong there. Kept. */
    LACK_OF_FIT,
    /** Far from the path and from its neighbours, or too far to be the ball. Left out. */
    OUTLIER
  }

  /** Detections compared on each side: of three, the median is good as long as two are, so that up to two false ones in a row stand alone. */
  private static final int NEIGHBOURS = 3;

  /** Neighbours are not farther away than that, s: three frames at 60 Hz and two that are lost. */
  private static final double NEAR_IN_TIME = 0.085;

  /** The scatter of a residual about a median of three: the median's variance is 0.449 of one detection's. */
  private static final double SCATTER_ABOUT_MEDIAN = Math.sqrt(1 + 0.449);

  /** Share of a residual that its neighbours may lack: where the model goes wrong fast, they are off less or more. Chosen: half. */
  private static final double NOT_SHARED = 0.5;

  /** Beyond that distance from the path, m, nothing is the ball: no effect of DESIGN moves it so far from where the kick's own fit has it. */
  private static final double TOO_FAR = 0.25;

  private final Verdict[] verdicts;
  private final double robustScale;
  private final int outliers;
  private final int lackOfFit;

  private Screening(Verdict[] verdicts, double robustScale) {
    this.verdicts = verdicts;
    this.robustScale = robustScale;
    outliers = count(verdicts, Verdict.OUTLIER);
    lackOfFit = count(verdicts, Verdict.LACK_OF_FIT);
  }

  private static int count(Verdict[] verdicts, Verdict which) {
    return (int) Arrays.stream(verdicts).filter(v -> v == which).count();
  }

  /**
   * Screens the detections of a fitted kick.
   *
   * @param fit not a failed one
   * @param views cameras with their noise
   * @param settings the outlier distance
   * @return the verdict on each detection
   */
  public static Screening of(KickFit fit, CameraViews views, FitSettings settings) {
    FlightData data = FlightData.of(fit.kick().observations(), views);
    double[] rx = new double[data.size];
    double[] ry = new double[data.size];
    for (int i = 0; i < data.size; i++) {
      rx[i] = fit.residualX(i);
      ry[i] = fit.residualY(i);
    }
    return of(data, rx, ry, settings.outlierDistance());
  }

  /**
   * Which detections of a fitted kick are the ball.
   *
   * @param fit not a failed one
   * @param views cameras with their noise
   * @return by index of the observation; false for outliers
   */
  public static boolean[] kept(KickFit fit, CameraViews views) {
    return of(fit, views, FitSettings.defaults()).kept();
  }

  /**
   * Screens residuals.
   *
   * @param distance from the path at which a detection is judged by its neighbours, in robust standard deviations, which are at least the cameras' noise
   */
  static Screening of(FlightData data, double[] rx, double[] ry, double distance) {
    double[] squared = new double[data.size];
    for (int i = 0; i < data.size; i++) {
      squared[i] = data.squared(i, rx[i], ry[i]);
    }
    double scale = data.size == 0 ? 1 : RobustScale.ofSquaredDistances(squared);
    double limit = distance * Math.max(1, scale);
    Verdict[] verdicts = new Verdict[data.size];
    for (int i = 0; i < data.size; i++) {
      if (squared[i] <= limit * limit) {
        verdicts[i] = Verdict.FITS;
      } else {
        boolean shared =
            Math.hypot(rx[i], ry[i]) < TOO_FAR && isShared(data, rx, ry, i, limit, squared[i]);
        verdicts[i] = shared ? Verdict.LACK_OF_FIT : Verdict.OUTLIER;
      }
    }
    return new Screening(verdicts, scale);
  }

  private static boolean isShared(
      FlightData data, double[] rx, double[] ry, int i, double limit, double squared) {
    int[] before = neighbours(data, i, -1);
    int[] after = neighbours(data, i, 1);
    double most = Math.max(limit * SCATTER_ABOUT_MEDIAN, NOT_SHARED * Math.sqrt(squared));
    double bx = median(rx, before);
    double by = median(ry, before);
    double ax = median(rx, after);
    double ay = median(ry, after);
    // A side without enough neighbours is NaN, and so is its distance, which is then no reason to
    // keep.
    return isWithin(data, i, rx[i] - bx, ry[i] - by, most)
        || isWithin(data, i, rx[i] - ax, ry[i] - ay, most)
        || isWithin(data, i, rx[i] - 0.5 * (bx + ax), ry[i] - 0.5 * (by + ay), most);
  }

  private static boolean isWithin(FlightData data, int i, double dx, double dy, double most) {
    return data.squared(i, dx, dy) <= most * most;
  }

  /** The nearest of the same camera in one direction of time; null when there are too few. */
  private static int[] neighbours(FlightData data, int i, int step) {
    int[] found = new int[NEIGHBOURS];
    int n = 0;
    for (int k = i + step; k >= 0 && k < data.size && n < NEIGHBOURS; k += step) {
      if (Math.abs(data.time[k] - data.time[i]) > NEAR_IN_TIME) {
        break;
      }
      if (data.camera[k] == data.camera[i]) {
        found[n++] = k;
      }
    }
    return n == NEIGHBOURS ? found : null;
  }

  private static double median(double[] values, int[] of) {
    if (of == null) {
      return Double.NaN;
    }
    double a = values[of[0]];
    double b = values[of[1]];
    double c = values[of[2]];
    return Math.max(Math.min(a, b), Math.min(Math.max(a, b), c));
  }

  /**
   * Number of detections.
   *
   * @return count
   */
  public int size() {
    return verdicts.length;
  }

  /**
   * What a detection is.
   *
   * @param i index of the observation
   * @return the verdict
   */
  public Verdict verdict(int i) {
    return verdicts[Objects.checkIndex(i, verdicts.length)];
  }

  /**
   * Whether a detection is the ball.
   *
   * @param i index of the observation
   * @return false for outliers
   */
  public boolean kept(int i) {
    return verdict(i) != Verdict.OUTLIER;
  }

  /**
   * Which detections are the ball.
   *
   * @return a new array by index of the observation; false for outliers
   */
  public boolean[] kept() {
    boolean[] kept = new boolean[verdicts.length];
    for (int i = 0; i < kept.length; i++) {
      kept[i] = kept(i);
    }
    return kept;
  }

  /**
   * Number of detections that are left out.
   *
   * @return count
   */
  public int outliers() {
    return outliers;
  }

  /**
   * Number of detections that are kept though the model does not explain them.
   *
   * @return count
   */
  public int lackOfFit() {
    return lackOfFit;
  }

  /**
   * How many times larger than the cameras' noise a typical residual is.
   *
   * @return from the median, so that what the model does not explain hardly moves it
   */
  public double robustScale() {
    return robustScale;
  }

  @Override
  public String toString() {
    return verdicts.length + " detections, " + outliers + " outliers, " + lackOfFit
        + " that the model does not explain";
  }
}
