package fieldcal.app.play;

import fieldcal.kick.KickKind;
import fieldcal.play.PlayLimits;
import fieldcal.play.PlayLine.Half;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;

/**
 * What an operator wants of a session.
 *
 * @param kind flat kicks or chips
 * @param kicks how many good ones
 * @param first one robot
 * @param second the other
 * @param half which part of the field, for flat kicks
 * @param across where the line of chips crosses the x axis, m
 * @param slowest kick, m/s
 * @param fastest kick, m/s
 * @param elevation of chips, rad
 * @param adaptive whether the next kick is chosen by what it tells
 * @param precision the session ends early when every parameter is known that well, relative standard error; 0 = never
 * @param seed of the order of the kicks
 * @param limits speeds and time-outs
 * @param margin how far outside the lines robots may get, m; empty = as wide as the boundary allows
 * @param directory for the recording; empty = nothing is recorded
 */
public record SessionRequest(
    KickKind kind,
    int kicks,
    RobotId first,
    RobotId second,
    Half half,
    double across,
    double slowest,
    double fastest,
    double elevation,
    boolean adaptive,
    double precision,
    long seed,
    PlayLimits limits,
    Optional<Double> margin,
    Optional<Path> directory) {

  /** More kicks than a day of field time has room for; chosen. */
  public static final int MOST_KICKS = 1000;

  /**
   * Checks the parts. {@inheritDoc}
   *
   * @throws NullPointerException when one is null
   * @throws IllegalArgumentException when there is no kick or a range is empty
   */
  public SessionRequest {
    Objects.requireNonNull(kind, "kind");
    Objects.requireNonNull(half, "half");
    Objects.requireNonNull(limits, "limits");
    Objects.requireNonNull(margin, "margin");
    Objects.requireNonNull(directory, "directory");
    if (kicks < 1 || kicks > MOST_KICKS) {
      throw new IllegalArgumentException(
          "kicks must lie in [1, " + MOST_KICKS + "], but are " + kicks);
    }
    if (!(precision >= 0 && precision < 1)) {
      throw new IllegalArgumentException("precision must lie in [0, 1), but is " + precision);
    }
    if (!(slowest >= 0.7 && fastest >= slowest && fastest <= 10)) {
      throw new IllegalArgumentException(
          "kick speeds must lie in [0.7, 10] m/s, slowest first, but are "
              + slowest
              + " to "
              + fastest);
    }
  }

  /**
   * Usual kicks by yellow 0 and yellow 1.
   *
   * @param kind flat kicks of 2 to 6.5 m/s over the whole field, or chips of 3 to 5.5 m/s at 45° along the half-way line: higher ones leave the images where cameras overlap by little
   * @param kicks how many good ones
   * @return the request, without a directory
   */
  public static SessionRequest of(KickKind kind, int kicks) {
    boolean chip = kind == KickKind.CHIP;
    return new SessionRequest(
        kind,
        kicks,
        new RobotId(Team.YELLOW, 0),
        new RobotId(Team.YELLOW, 1),
        Half.WHOLE,
        0,
        chip ? 3 : 2,
        chip ? 5.5 : 6.5,
        chip ? Math.PI / 4 : 0,
        false,
        0,
        1,
        PlayLimits.DEFAULT,
        Optional.empty(),
        Optional.empty());
  }

  /**
   * Other robots.
   *
   * @param newFirst one robot
   * @param newSecond the other
   * @return the changed request
   */
  public SessionRequest withRobots(RobotId newFirst, RobotId newSecond) {
    return new SessionRequest(
        kind, kicks, newFirst, newSecond, half, across, slowest, fastest, elevation, adaptive,
        precision, seed, limits, margin, directory);
  }

  /**
   * Another part of the field.
   *
   * @param newHalf for flat kicks
   * @param newAcross for chips, m
   * @return the changed request
   */
  public SessionRequest withPlace(Half newHalf, double newAcross) {
    return new SessionRequest(
        kind, kicks, first, second, newHalf, newAcross, slowest, fastest, elevation, adaptive,
        precision, seed, limits, margin, directory);
  }

  /**
   * Other kicks.
   *
   * @param newSlowest m/s
   * @param newFastest m/s
   * @param newElevation of chips, rad
   * @return the changed request
   */
  public SessionRequest withSpeeds(double newSlowest, double newFastest, double newElevation) {
    double angle = kind == KickKind.CHIP ? newElevation : 0;
    return new SessionRequest(
        kind,
        kicks,
        first,
        second,
        half,
        across,
        newSlowest,
        newFastest,
        angle,
        adaptive,
        precision,
        seed,
        limits,
        margin,
        directory);
  }

  /**
   * Another choice of kicks.
   *
   * @param newAdaptive whether the next kick is chosen by what it tells
   * @param newSeed of the order of the kicks
   * @return the changed request
   */
  public SessionRequest withChoice(boolean newAdaptive, long newSeed) {
    return withChoice(newAdaptive, newSeed, precision);
  }

  /**
   * Another choice of kicks, and when it is enough.
   *
   * @param newAdaptive whether the next kick is chosen by what it tells
   * @param newSeed of the order of the kicks
   * @param newPrecision relative standard error of every parameter that is enough; 0 = never
   * @return the changed request
   */
  public SessionRequest withChoice(boolean newAdaptive, long newSeed, double newPrecision) {
    return new SessionRequest(
        kind,
        kicks,
        first,
        second,
        half,
        across,
        slowest,
        fastest,
        elevation,
        newAdaptive,
        newPrecision,
        newSeed,
        limits,
        margin,
        directory);
  }

  /**
   * Other limits.
   *
   * @param newLimits speeds and time-outs
   * @param newMargin how far outside the lines robots may get, m
   * @return the changed request
   */
  public SessionRequest withLimits(PlayLimits newLimits, Optional<Double> newMargin) {
    return new SessionRequest(
        kind, kicks, first, second, half, across, slowest, fastest, elevation, adaptive, precision,
        seed, newLimits, newMargin, directory);
  }

  /**
   * A place for the recording.
   *
   * @param newDirectory made if needed
   * @return the changed request
   */
  public SessionRequest into(Path newDirectory) {
    return new SessionRequest(
        kind,
        kicks,
        first,
        second,
        half,
        across,
        slowest,
        fastest,
        elevation,
        adaptive,
        precision,
        seed,
        limits,
        margin,
        Optional.of(newDirectory));
  }
}
