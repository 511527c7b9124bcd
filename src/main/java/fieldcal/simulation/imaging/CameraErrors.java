package fieldcal.simulation.imaging;

import java.util.ArrayList;
import java.util.List;

/**
 * What is wrong with one camera: published minus true, and time stamps. Start from {@link #NONE}.
 *
 * @param tilt rotation of the published pose about {@code tiltAxis}, rad
 * @param tiltAxis direction of the horizontal axis in the field, rad
 * @param heightError published minus true height, m
 * @param shiftX published minus true position, m
 * @param shiftY published minus true position, m
 * @param distortionError published minus true radial distortion (–)
 * @param offsetX added to everything it reports, m
 * @param offsetY added to everything it reports, m
 * @param timeOffset added to its time stamps, s
 * @param clockSkew its clock gains that much per second (–)
 * @param shakeAmplitude everything it reports swings along x by that much, m
 * @param shakeRate how often it swings, 1/s
 * @param knocks what moved it during the session
 * @param shear an error of the lens that is not radial: what it reports is shifted along x by shear·ξ²·η, with ξ, η = place relative to the point below the camera over its height, m
 * @param tables errors that were measured and have no formula
 * @param misstated announced minus the position with which vision computes
 */
public record CameraErrors(
    double tilt,
    double tiltAxis,
    double heightError,
    double shiftX,
    double shiftY,
    double distortionError,
    double offsetX,
    double offsetY,
    double timeOffset,
    double clockSkew,
    double shakeAmplitude,
    double shakeRate,
    List<Knock> knocks,
    double shear,
    List<TabulatedError> tables,
    Misstated misstated) {

  /** Nothing is wrong. */
  public static final CameraErrors NONE =
      new CameraErrors(
          0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, List.of(), 0, List.of(), new Misstated(0, 0, 0));

  /** Copies the list. {@inheritDoc} */
  public CameraErrors {
    knocks = List.copyOf(knocks);
    tables = List.copyOf(tables);
  }

  /**
   * Somebody knocked the camera: from then on everything it reports is shifted.
   *
   * @param x m
   * @param y m
   * @param at session time, s
   */
  public record Knock(double x, double y, double at) {}

  /**
   * A position in the geometry messages with which vision itself does not compute: announced minus used.
   *
   * @param x along x of the field, m
   * @param y along y of the field, m
   * @param height above the carpet, m
   */
  public record Misstated(double x, double y, double height) {}

  /**
   * Another tilt of the published pose.
   *
   * @param angle rad
   * @param axis direction of the horizontal axis in the field, rad
   * @return the changed errors
   */
  public CameraErrors withTilt(double angle, double axis) {
    return new CameraErrors(
        angle,
        axis,
        heightError,
        shiftX,
        shiftY,
        distortionError,
        offsetX,
        offsetY,
        timeOffset,
        clockSkew,
        shakeAmplitude,
        shakeRate,
        knocks,
        shear,
        tables,
        misstated);
  }

  /**
   * Another published position.
   *
   * @param x published minus true, m
   * @param y published minus true, m
   * @param height published minus true, m
   * @return the changed errors
   */
  public CameraErrors withShift(double x, double y, double height) {
    return new CameraErrors(
        tilt,
        tiltAxis,
        height,
        x,
        y,
        distortionError,
        offsetX,
        offsetY,
        timeOffset,
        clockSkew,
        shakeAmplitude,
        shakeRate,
        knocks,
        shear,
        tables,
        misstated);
  }

  /**
   * Another published lens.
   *
   * @param error published minus true radial distortion
   * @return the changed errors
   */
  public CameraErrors withDistortion(double error) {
    return new CameraErrors(
        tilt,
        tiltAxis,
        heightError,
        shiftX,
        shiftY,
        error,
        offsetX,
        offsetY,
        timeOffset,
        clockSkew,
        shakeAmplitude,
        shakeRate,
        knocks,
        shear,
        tables,
        misstated);
  }

  /**
   * Another offset of everything it reports.
   *
   * @param x m
   * @param y m
   * @return the changed errors
   */
  public CameraErrors withOffset(double x, double y) {
    return new CameraErrors(
        tilt,
        tiltAxis,
        heightError,
        shiftX,
        shiftY,
        distortionError,
        x,
        y,
        timeOffset,
        clockSkew,
        shakeAmplitude,
        shakeRate,
        knocks,
        shear,
        tables,
        misstated);
  }

  /**
   * Another clock.
   *
   * @param offset added to time stamps, s
   * @param skew gain per second (–)
   * @return the changed errors
   */
  public CameraErrors withTiming(double offset, double skew) {
    return new CameraErrors(
        tilt,
        tiltAxis,
        heightError,
        shiftX,
        shiftY,
        distortionError,
        offsetX,
        offsetY,
        offset,
        skew,
        shakeAmplitude,
        shakeRate,
        knocks,
        shear,
        tables,
        misstated);
  }

  /**
   * A mount that swings.
   *
   * @param amplitude m
   * @param rate 1/s
   * @return the changed errors
   */
  public CameraErrors withShake(double amplitude, double rate) {
    return new CameraErrors(
        tilt,
        tiltAxis,
        heightError,
        shiftX,
        shiftY,
        distortionError,
        offsetX,
        offsetY,
        timeOffset,
        clockSkew,
        amplitude,
        rate,
        knocks,
        shear,
        tables,
        misstated);
  }

  /**
   * Knocked once more.
   *
   * @param x shift, m
   * @param y shift, m
   * @param at session time, s
   * @return the changed errors
   */
  public CameraErrors withKnock(double x, double y, double at) {
    List<Knock> all = new ArrayList<>(knocks);
    all.add(new Knock(x, y, at));
    return with(all, shear, tables, misstated);
  }

  /**
   * Another error of the lens that is not radial.
   *
   * @param metres shift along x at ξ = η = 1, m
   * @return the changed errors
   */
  public CameraErrors withShear(double metres) {
    return with(knocks, metres, tables, misstated);
  }

  /**
   * One more error that has no formula.
   *
   * @param table what it is
   * @return the changed errors
   */
  public CameraErrors withTable(TabulatedError table) {
    List<TabulatedError> all = new ArrayList<>(tables);
    all.add(table);
    return with(knocks, shear, all, misstated);
  }

  /**
   * Another announced position.
   *
   * @param x announced minus the one with which vision computes, m
   * @param y the same, m
   * @param height the same, m
   * @return the changed errors
   */
  public CameraErrors withMisstated(double x, double y, double height) {
    return with(knocks, shear, tables, new Misstated(x, y, height));
  }

  private CameraErrors with(
      List<Knock> newKnocks,
      double newShear,
      List<TabulatedError> newTables,
      Misstated newMisstated) {
    return new CameraErrors(
        tilt,
        tiltAxis,
        heightError,
        shiftX,
        shiftY,
        distortionError,
        offsetX,
        offsetY,
        timeOffset,
        clockSkew,
        shakeAmplitude,
        shakeRate,
        newKnocks,
        newShear,
        newTables,
        newMisstated);
  }

  /**
   * Both at once; of two tilts and of two swings the larger one stays.
   *
   * @param other more errors
   * @return the sum
   */
  public CameraErrors plus(CameraErrors other) {
    CameraErrors tilted = Math.abs(tilt) >= Math.abs(other.tilt) ? this : other;
    CameraErrors shaken = Math.abs(shakeAmplitude) >= Math.abs(other.shakeAmplitude) ? this : other;
    List<Knock> all = new ArrayList<>(knocks);
    all.addAll(other.knocks);
    List<TabulatedError> both = new ArrayList<>(tables);
    both.addAll(other.tables);
    Misstated announced =
        new Misstated(
            misstated.x + other.misstated.x,
            misstated.y + other.misstated.y,
            misstated.height + other.misstated.height);
    return NONE.with(all, shear + other.shear, both, announced)
        .withTilt(tilted.tilt, tilted.tiltAxis)
        .withShift(shiftX + other.shiftX, shiftY + other.shiftY, heightError + other.heightError)
        .withDistortion(distortionError + other.distortionError)
        .withOffset(offsetX + other.offsetX, offsetY + other.offsetY)
        .withTiming(timeOffset + other.timeOffset, clockSkew + other.clockSkew)
        .withShake(shaken.shakeAmplitude, shaken.shakeRate);
  }

  /** Shift along x by the swinging mount at a time, m. */
  double shakeAt(double time) {
    return shakeAmplitude == 0 ? 0 : shakeAmplitude * Math.sin(2 * Math.PI * shakeRate * time);
  }

  /**
   * By how much what is reported of a place is shifted at a time.
   *
   * @param time session time, s
   * @param dx place relative to the point below the camera, m
   * @param dy the same, m
   * @param height of the camera, m
   * @param shift gets x and y, m
   */
  void shiftAt(double time, double dx, double dy, double height, double[] shift) {
    double xi = dx / height;
    double eta = dy / height;
    shift[0] = offsetX + shakeAt(time) + shear * xi * xi * eta;
    shift[1] = offsetY;
    for (Knock knock : knocks) {
      shift[0] += time < knock.at() ? 0 : knock.x();
      shift[1] += time < knock.at() ? 0 : knock.y();
    }
    for (TabulatedError table : tables) {
      table.addShift(time, dx, dy, shift);
    }
  }

  /** What is added to time stamps at a time, s. */
  double stampErrorAt(double time) {
    double error = timeOffset + clockSkew * time;
    for (TabulatedError table : tables) {
      error += table.stampError(time);
    }
    return error;
  }
}
