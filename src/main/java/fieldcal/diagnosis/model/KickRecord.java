package fieldcal.diagnosis.model;

import fieldcal.ball.BallState;
import fieldcal.ball.BallTrajectory;
import fieldcal.camera.Camera;
import fieldcal.effect.Sightings;
import fieldcal.fit.CameraView;
import fieldcal.fit.KickFit;
import fieldcal.fit.Whitening;
import fieldcal.kick.Kick;
import fieldcal.kick.KickKind;
import fieldcal.kick.Observations;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The observations of one kick as the joint fits need them: as reported, whitened, without detections of something else, and gathered into short blocks of one camera. Immutable.
 *
 * <p>A block's residual is the sum of its detections' whitened residuals over the square root of their number: of unit variance for noise, as strong as before for anything that changes slowly against {@link #BLOCK_TIME}. That makes
 * the fits several times as fast and loses nothing that a model could explain.
 */
public final class KickRecord {
  /** Most detections in a block. */
  private static final int BLOCK = 4;

  /** Longest block, s: in that time a sliding ball (4 m/s²) departs from a straight line by 0.7 mm, below every camera's noise. */
  private static final double BLOCK_TIME = 0.05;

  /** If a fit starts farther than this from where the ball lay, it has lost the resting ball, m; cameras disagree by less. */
  private static final double LOST_REST = 0.1;

  /** How long before the kick a detection must be to show the resting ball, s: the time of the kick is known more closely. */
  private static final double BEFORE_KICK = 0.1;

  /** Fewest detections that determine where a ball lay. */
  static final int LEAST_REST = 3;

  final Kick kick;
  final KickKind kind;

  /** Where the kick's own fit ended, cameras' offsets taken out: position, velocity, time. */
  final double[] start;

  /** Chi-square for each residual that the kick's own fit leaves, with its own ball parameters. */
  final double alone;

  final int flights;
  final int size;
  final double[] time;
  final double[] x;
  final double[] y;
  final double[] row;
  final int[] camera;
  final double[] cameraHeight;
  final double[] w11;
  final double[] w21;
  final double[] w22;
  final Sightings sightings;
  final boolean[] used;
  final int usedCount;

  /** Indices of the detections of each block, and the blocks' mean sighting and whitening. */
  final int[][] blocks;

  final Sightings blockSightings;
  final double[] blockTime;
  final double[] blockHeight;
  final double[] block11;
  final double[] block21;
  final double[] block22;

  private final MovingNoise noise;

  /** Whether detections of the resting ball pin where the kick begins. */
  final boolean fromRest;

  /** The same kick with all detections that its own fit used. */
  final KickRecord whole;

  /** The same kick with the noise of the cameras alone. */
  private final KickRecord asSeen;

  /**
   * A kick.
   *
   * @param fit the kick's own fit, not a failed one
   * @param kept which detections are the ball
   * @param noise of the cameras and their time stamps
   */
  public KickRecord(KickFit fit, boolean[] kept, MovingNoise noise) {
    whole = this;
    asSeen = this;
    this.noise = noise;
    kick = fit.kick();
    kind = fit.kind();
    int own = ownSize(kind);
    start = Arrays.copyOf(fit.values(), own);
    startAtRest();
    flights = fit.statistics().flights();
    Observations seen = kick.observations();
    size = seen.size();
    time = new double[size];
    x = new double[size];
    y = new double[size];
    row = new double[size];
    camera = new int[size];
    cameraHeight = new double[size];
    w11 = new double[size];
    w21 = new double[size];
    w22 = new double[size];
    used = kept.clone();
    Whitening whitening = new Whitening();
    BallTrajectory path = fit.trajectory();
    for (int i = 0; i < size; i++) {
      time[i] = seen.time(i);
      x[i] = seen.x(i);
      y[i] = seen.y(i);
      row[i] = seen.pixelY(i);
      camera[i] = seen.camera(i);
      CameraView view = noise.cameras().get(camera[i]);
      // Without geometry: infinitely high, so that a ball is reported where it is.
      cameraHeight[i] = view.camera().map(Camera::heightAboveBallPlane).orElse(1e9);
      BallState state = path.stateAt(time[i]);
      double late = noise.stampNoise();
      whitening.at(view, x[i], y[i], late * state.vx(), late * state.vy());
      w11[i] = whitening.w11();
      w21[i] = whitening.w21();
      w22[i] = whitening.w22();
    }
    usedCount = count();
    alone = alone(fit);
    sightings = new Sightings(camera, time, row);
    fromRest = kick.fromRest() && restCount() >= LEAST_REST;
    blocks = makeBlocks();
    blockTime = new double[blocks.length];
    blockHeight = new double[blocks.length];
    block11 = new double[blocks.length];
    block21 = new double[blocks.length];
    block22 = new double[blocks.length];
    blockSightings = meanSightings();
  }

  /** The same with other detections, and so many times the noise. */
  private KickRecord(KickRecord of, boolean[] kept, double times) {
    whole = times == 1 ? of.whole : of.whole == of ? this : of.whole.withNoise(times);
    asSeen = times == 1 && of.asSeen == of ? this : of.asSeen.withUsed(kept);
    noise = of.noise;
    kick = of.kick;
    kind = of.kind;
    start = of.start;
    alone = of.alone;
    flights = of.flights;
    size = of.size;
    time = of.time;
    x = of.x;
    y = of.y;
    row = of.row;
    camera = of.camera;
    cameraHeight = of.cameraHeight;
    w11 = divided(of.w11, times);
    w21 = divided(of.w21, times);
    w22 = divided(of.w22, times);
    sightings = of.sightings;
    used = kept;
    usedCount = count();
    fromRest = kick.fromRest() && restCount() >= LEAST_REST;
    blocks = makeBlocks();
    blockTime = new double[blocks.length];
    blockHeight = new double[blocks.length];
    block11 = new double[blocks.length];
    block21 = new double[blocks.length];
    block22 = new double[blocks.length];
    blockSightings = meanSightings();
  }

  private static double[] divided(double[] values, double by) {
    return by == 1 ? values : Arrays.stream(values).map(v -> v / by).toArray();
  }

  private double alone(KickFit fit) {
    double sum = 0;
    double[] r = new double[2];
    for (int i = 0; i < size; i++) {
      if (used[i]) {
        whiten(i, fit.residualX(i), fit.residualY(i), r);
        sum += r[0] * r[0] + r[1] * r[1];
      }
    }
    return sum / Math.max(1, 2 * usedCount);
  }

  private int count() {
    int n = 0;
    for (boolean u : used) {
      n += u ? 1 : 0;
    }
    return n;
  }

  /** Moves the start to where the ball lay, if the kick's own fit has lost the resting ball because no path of its model leads from there. */
  private void startAtRest() {
    double[] rest = rest();
    if (rest != null && Math.hypot(start[0] - rest[0], start[1] - rest[1]) > LOST_REST) {
      start[0] = rest[0];
      start[1] = rest[1];
      start[timeIndex()] = kick.time();
    }
  }

  /** Where the ball lay before the kick: the median of its detections, which does not depend on a model; null when it did not rest. */
  private double[] rest() {
    Observations seen = kick.observations();
    int n = 0;
    while (n < seen.size() && seen.time(n) < kick.time() - BEFORE_KICK) {
      n++;
    }
    if (!kick.fromRest() || n < LEAST_REST) {
      return null;
    }
    double[] xs = new double[n];
    double[] ys = new double[n];
    for (int i = 0; i < n; i++) {
      xs[i] = seen.x(i);
      ys[i] = seen.y(i);
    }
    Arrays.sort(xs);
    Arrays.sort(ys);
    return new double[] {xs[n / 2], ys[n / 2]};
  }

  private int restCount() {
    int n = 0;
    for (int i = 0; i < size && time[i] < kick.time(); i++) {
      n += used[i] ? 1 : 0;
    }
    return n;
  }

  private int[][] makeBlocks() {
    List<int[]> found = new ArrayList<>();
    for (int id : kick.observations().cameras()) {
      int[] block = new int[BLOCK];
      int n = 0;
      for (int i = 0; i < size; i++) {
        if (!used[i] || camera[i] != id) {
          continue;
        }
        boolean ends =
            n == BLOCK
                || n > 0 && time[i] - time[block[0]] > BLOCK_TIME
                || n > 0 && time[block[0]] < kick.time() != time[i] < kick.time();
        if (ends) {
          found.add(Arrays.copyOf(block, n));
          n = 0;
        }
        block[n++] = i;
      }
      if (n > 0) {
        found.add(Arrays.copyOf(block, n));
      }
    }
    // In order of time, in which predictions are fastest.
    found.sort((a, b) -> Double.compare(time[a[0]], time[b[0]]));
    return found.toArray(int[][]::new);
  }

  private Sightings meanSightings() {
    int[] cameras = new int[blocks.length];
    double[] rows = new double[blocks.length];
    for (int b = 0; b < blocks.length; b++) {
      int[] block = blocks[b];
      cameras[b] = camera[block[0]];
      double root = rootOfSum(block.length);
      for (int i : block) {
        blockTime[b] += time[i] / block.length;
        rows[b] += row[i] / block.length;
        blockHeight[b] += cameraHeight[i] / block.length;
        block11[b] += w11[i] / root;
        block21[b] += w21[i] / root;
        block22[b] += w22[i] / root;
      }
    }
    return new Sightings(cameras, blockTime, rows);
  }

  /**
   * Standard deviation of the sum of whitened residuals of successive detections of a camera, where these are noise.
   *
   * @param count how many
   * @return their root where the noise of each is its own
   */
  public double rootOfSum(int count) {
    return Math.sqrt(count * noise.inflation(count));
  }

  /**
   * Variance of the difference of whitened residuals of two successive detections of a camera, where these are noise.
   *
   * @return 2 where the noise of each is its own
   */
  public double varianceOfDifference() {
    return 2 * (1 - noise.correlation());
  }

  /**
   * What the kick's own fit leaves, with its own ball parameters.
   *
   * @return chi-square for each residual
   */
  public double alone() {
    return alone;
  }

  /**
   * The kick with other detections.
   *
   * @param kept which of all detections count
   * @return the changed copy
   */
  public KickRecord withUsed(boolean[] kept) {
    return new KickRecord(this, kept.clone(), 1);
  }

  /**
   * The kick with more noise: a model then need not explain what it leaves beyond the cameras' noise.
   *
   * @param times how many times the noise, at least 1
   * @return the changed copy
   */
  public KickRecord withNoise(double times) {
    return new KickRecord(this, used, times);
  }

  /**
   * The noise of this record, as a multiple of the noise of the cameras.
   *
   * @return 1 unless it was given more
   */
  public double timesNoise() {
    return size == 0 ? 1 : asSeen.w11[0] / w11[0];
  }

  /**
   * The kick with the noise of the cameras alone.
   *
   * @return itself unless it was given more
   */
  public KickRecord asSeen() {
    return asSeen;
  }

  /**
   * The kick with all detections that are the ball.
   *
   * @return itself when nothing was cut
   */
  public KickRecord whole() {
    return whole;
  }

  /**
   * Whitens a residual of a detection.
   *
   * @param i which
   * @param rx seen minus predicted, m
   * @param ry seen minus predicted, m
   * @param out receives two numbers of unit variance
   */
  public void whiten(int i, double rx, double ry, double[] out) {
    out[0] = w11[i] * rx;
    out[1] = w21[i] * rx + w22[i] * ry;
  }

  /**
   * The kick.
   *
   * @return as found
   */
  public Kick kick() {
    return kick;
  }

  /**
   * What it is taken for.
   *
   * @return flat or chip
   */
  public KickKind kind() {
    return kind;
  }

  /**
   * How many detections it has.
   *
   * @return their number, including those that are not used
   */
  public int size() {
    return size;
  }

  /**
   * Which detections count.
   *
   * @return a copy
   */
  public boolean[] used() {
    return used.clone();
  }

  /**
   * How many count.
   *
   * @return their number
   */
  public int usedCount() {
    return usedCount;
  }

  /**
   * Where its own fit ended.
   *
   * @return x, y (m), vx, vy, of chips also vz (m/s), t0 (s) in the field frame; a copy
   */
  public double[] start() {
    return start.clone();
  }

  /**
   * Camera of a detection.
   *
   * @param i which
   * @return its id
   */
  public int camera(int i) {
    return camera[i];
  }

  /**
   * Time stamp of a detection.
   *
   * @param i which
   * @return s
   */
  public double time(int i) {
    return time[i];
  }

  /**
   * Reported place.
   *
   * @param i which
   * @return x, m
   */
  public double x(int i) {
    return x[i];
  }

  /**
   * Reported place.
   *
   * @param i which
   * @return y, m
   */
  public double y(int i) {
    return y[i];
  }

  /**
   * Variance of a detection's place, mean of the two axes.
   *
   * @param i which
   * @return m²
   */
  public double variance(int i) {
    // Half the trace of the covariance, whose Cholesky factor's inverse is w.
    double l11 = 1 / w11[i];
    double l22 = 1 / w22[i];
    double l21 = -w21[i] * l11 * l22;
    return 0.5 * (l11 * l11 + l21 * l21 + l22 * l22);
  }

  /**
   * Whether detections of the resting ball pin where the kick begins.
   *
   * @return true when they do
   */
  public boolean fromRest() {
    return fromRest;
  }

  /**
   * How many unknowns a kick has of its own.
   *
   * @param kind flat or chip
   * @return position, velocity, time
   */
  public static int ownSize(KickKind kind) {
    return kind == KickKind.FLAT ? 5 : 6;
  }

  /**
   * Index of the kick's time among its own parameters.
   *
   * @return the last of them without random effects
   */
  public int timeIndex() {
    return ownSize(kind) - 1;
  }
}
