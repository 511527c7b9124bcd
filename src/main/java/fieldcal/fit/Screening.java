package fieldcal.fit;

import java.util.Arrays;
import java.util.Objects;

/**
 * Data screening of one kick: distinguishes detections of something other than the ball from good ones that a wrong model does not explain. Calibration, live monitoring and diagnosis all use it.
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

  /** Number of detections compared on each side. The median of 5 is good as long as three of them are: with 5 % false ones, on all but one side in 900. */
  private static final int NEIGHBOURS = 5;

  /** With fewer on a side their median may be a false detection's. */
  private static final int FEWEST_NEIGHBOURS = 3;

  /** A detection is off like its neighbours only if one of this many nearest ones on each side is off, too. */
  private static final int CLOSEST = 2;

  /** Neighbours are not farther away in time than this, s: five frames at 60 Hz and four that are lost. */
  private static final double NEAR_IN_TIME = 0.15;

  /**
   * Largest share of a residual that its neighbours may lack. Chosen: half. Less would cost detections where a model goes wrong fast, so that neighbours are off less or more; of a detection that stands
   * alone the neighbours lack nearly all.
   */
  private static final double NOT_SHARED = 0.5;

  /** A detection farther from the path is not the ball, m: no effect of DESIGN moves it so far from where the kick's own fit has it. */
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
            Math.hypot(rx[i], ry[i]) < TOO_FAR && isShared(data, rx, ry, i, squared[i]);
        verdicts[i] = shared ? Verdict.LACK_OF_FIT : Verdict.OUTLIER;
      }
    }
    return new Screening(verdicts, scale);
  }

  private static boolean isShared(
      FlightData data, double[] rx, double[] ry, int i, double squared) {
    double most = NOT_SHARED * NOT_SHARED * squared;
    int[] before = neighbours(data, i, -1);
    int[] after = neighbours(data, i, 1);
    if (!isOffAlike(data, rx, ry, i, before, most) && !isOffAlike(data, rx, ry, i, after, most)) {
      return false;
    }
    double bx = median(rx, before);
    double by = median(ry, before);
    double ax = median(rx, after);
    double ay = median(ry, after);
    // A side without enough neighbours is NaN, and so is its distance, which is then no reason to
    // keep.
    return data.squared(i, rx[i] - bx, ry[i] - by) <= most
        || data.squared(i, rx[i] - ax, ry[i] - ay) <= most
        || data.squared(i, rx[i] - 0.5 * (bx + ax), ry[i] - 0.5 * (by + ay)) <= most;
  }

  private static boolean isOffAlike(
      FlightData data, double[] rx, double[] ry, int i, int[] neighbours, double most) {
    for (int k = 0; k < Math.min(CLOSEST, neighbours.length); k++) {
      int other = neighbours[k];
      if (data.squared(i, rx[i] - rx[other], ry[i] - ry[other]) <= most) {
        return true;
      }
    }
    return false;
  }

  /** The nearest of the same camera in one direction of time, the nearest first. */
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
    return Arrays.copyOf(found, n);
  }

  /** NaN when there are too few. */
  private static double median(double[] values, int[] of) {
    int n = of.length;
    if (n < FEWEST_NEIGHBOURS) {
      return Double.NaN;
    }
    double[] sorted = new double[n];
    for (int k = 0; k < n; k++) {
      sorted[k] = values[of[k]];
    }
    Arrays.sort(sorted);
    return 0.5 * (sorted[(n - 1) / 2] + sorted[n / 2]);
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
    return verdicts.length
        + " detections, "
        + outliers
        + " outliers, "
        + lackOfFit
        + " that the model does not explain";
  }
}
