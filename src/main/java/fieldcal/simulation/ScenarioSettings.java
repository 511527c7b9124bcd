package fieldcal.simulation;

import fieldcal.simulation.robot.RobotLimits;
import java.util.Objects;

/**
 * Details of a scenario.
 *
 * @param kind what the robots do
 * @param kicks number of kicks to collect, 0 to 100 000, in a match those of both teams; deflections do not count; 0 = a match ends only after its time
 * @param flatSpeedMin slowest flat kick, m/s, 0.3 to 10
 * @param flatSpeedMax fastest flat kick, m/s, not below the slowest, at most 10
 * @param chipSpeedMin slowest chip, m/s, 1 to 10
 * @param chipSpeedMax fastest chip, m/s, not below the slowest, at most 10
 * @param elevation of chips, rad, 0.1 to 1.4
 * @param reception share of the kicks that the receiver tries to stop, 0 to 1
 * @param teamSize robots per team in a match, 1 to 16
 * @param minutes length of a match, min, 0.1 to 10 000, without the break; a match with a number of kicks ends earlier, after the last of them
 * @param yellow limits of yellow robots
 * @param blue limits of blue robots
 * @param manner what the robots of both teams of a match are like beyond that
 */
public record ScenarioSettings(
    ScenarioKind kind,
    int kicks,
    double flatSpeedMin,
    double flatSpeedMax,
    double chipSpeedMin,
    double chipSpeedMax,
    double elevation,
    double reception,
    int teamSize,
    double minutes,
    RobotLimits yellow,
    RobotLimits blue,
    TeamManner manner) {

  /** Length of a match without a number of kicks, min; one with a number of kicks is not shorter. */
  private static final double USUAL_MINUTES = 2;

  /** Time for each kick of a match, min; usually a kick takes an eighth of it, with robots of 0.3 m/s half of it. */
  private static final double MINUTES_PER_KICK = 0.5;

  private static final double LONGEST_MINUTES = 10_000;

  /**
   * Checks the ranges. {@inheritDoc}
   *
   * @throws IllegalArgumentException when one is out of range or NaN
   */
  public ScenarioSettings {
    Objects.requireNonNull(kind, "kind");
    Objects.requireNonNull(yellow, "yellow");
    Objects.requireNonNull(blue, "blue");
    Objects.requireNonNull(manner, "manner");
    range("kicks", kicks, 0, 100_000);
    range("flatSpeedMin", flatSpeedMin, 0.3, 10);
    range("flatSpeedMax", flatSpeedMax, flatSpeedMin, 10);
    range("chipSpeedMin", chipSpeedMin, 1, 10);
    range("chipSpeedMax", chipSpeedMax, chipSpeedMin, 10);
    range("elevation", elevation, 0.1, 1.4);
    range("reception", reception, 0, 1);
    range("teamSize", teamSize, 1, 16);
    range("minutes", minutes, 0.1, LONGEST_MINUTES);
  }

  private static void range(String name, double value, double min, double max) {
    if (!(value >= min && value <= max)) {
      throw new IllegalArgumentException(
          name + " must lie in [" + min + ", " + max + "], but is " + value);
    }
  }

  /**
   * Usual details.
   *
   * @param kind what the robots do
   * @param kicks number of kicks; 0 = a match ends after its time alone
   * @return flat 2–6.5 m/s, chips 3–6.5 m/s at 45°; matches of 6 against 6, of two minutes, or of as many as the kicks take at most
   */
  public static ScenarioSettings of(ScenarioKind kind, int kicks) {
    double minutes = Math.min(LONGEST_MINUTES, Math.max(USUAL_MINUTES, MINUTES_PER_KICK * kicks));
    return new ScenarioSettings(
        kind,
        kicks,
        2,
        6.5,
        3,
        6.5,
        Math.PI / 4,
        0.7,
        6,
        minutes,
        RobotLimits.DEFAULT,
        RobotLimits.DEFAULT,
        TeamManner.USUAL);
  }

  /**
   * Other kick speeds.
   *
   * @param min slowest, m/s
   * @param max fastest, m/s
   * @return the changed settings, for flat kicks and chips
   */
  public ScenarioSettings withSpeeds(double min, double max) {
    return new ScenarioSettings(
        kind, kicks, min, max, min, max, elevation, reception, teamSize, minutes, yellow, blue,
        manner);
  }

  /**
   * Another share of receptions.
   *
   * @param share 0 = the receiver stays away
   * @return the changed settings
   */
  public ScenarioSettings withReception(double share) {
    return new ScenarioSettings(
        kind,
        kicks,
        flatSpeedMin,
        flatSpeedMax,
        chipSpeedMin,
        chipSpeedMax,
        elevation,
        share,
        teamSize,
        minutes,
        yellow,
        blue,
        manner);
  }

  /**
   * Another match.
   *
   * @param size robots per team
   * @param length minutes
   * @return the changed settings
   */
  public ScenarioSettings withMatch(int size, double length) {
    return new ScenarioSettings(
        kind,
        kicks,
        flatSpeedMin,
        flatSpeedMax,
        chipSpeedMin,
        chipSpeedMax,
        elevation,
        reception,
        size,
        length,
        yellow,
        blue,
        manner);
  }

  /**
   * Other robots.
   *
   * @param yellowLimits of yellow
   * @param blueLimits of blue
   * @return the changed settings
   */
  public ScenarioSettings withLimits(RobotLimits yellowLimits, RobotLimits blueLimits) {
    return new ScenarioSettings(
        kind,
        kicks,
        flatSpeedMin,
        flatSpeedMax,
        chipSpeedMin,
        chipSpeedMax,
        elevation,
        reception,
        teamSize,
        minutes,
        yellowLimits,
        blueLimits,
        manner);
  }

  /**
   * Robots with another manner.
   *
   * @param next what they are like
   * @return the changed settings
   */
  public ScenarioSettings withManner(TeamManner next) {
    return new ScenarioSettings(
        kind,
        kicks,
        flatSpeedMin,
        flatSpeedMax,
        chipSpeedMin,
        chipSpeedMax,
        elevation,
        reception,
        teamSize,
        minutes,
        yellow,
        blue,
        next);
  }
}
