package fieldcal.movement;

import fieldcal.vision.Team;

/** The counts of both teams, and of the detections themselves. Statistics of several recordings merge exactly, in any order. Mutable, for one thread. */
public final class MovementStatistics {
  private final TeamStatistics yellow = new TeamStatistics();
  private final TeamStatistics blue = new TeamStatistics();
  private final Grid standing = Grid.centred(0.5, 48);
  private final Histogram standingSquares = new Histogram(0.02, 5000);
  long detections;
  long counted;
  long refused;
  long repeatedFrames;
  long surplusFrames;
  boolean refereeSeen;

  /** Creates empty statistics. */
  public MovementStatistics() {}

  /**
   * The statistics of one team.
   *
   * @param team which
   * @return its statistics
   */
  public TeamStatistics of(Team team) {
    return team == Team.YELLOW ? yellow : blue;
  }

  /**
   * Adds all that other statistics have counted.
   *
   * @param other stays as it is
   */
  public void merge(MovementStatistics other) {
    yellow.merge(other.yellow);
    blue.merge(other.blue);
    standing.merge(other.standing);
    standingSquares.merge(other.standingSquares);
    detections += other.detections;
    counted += other.counted;
    refused += other.refused;
    repeatedFrames += other.repeatedFrames;
    surplusFrames += other.surplusFrames;
    refereeSeen |= other.refereeSeen;
  }

  /** Forgets everything except whether there is a referee. */
  public void clear() {
    yellow.clear();
    blue.clear();
    standing.clear();
    standingSquares.clear();
    detections = 0;
    counted = 0;
    refused = 0;
    repeatedFrames = 0;
    surplusFrames = 0;
  }

  /**
   * Deviations of standing robots' detections from their mean while the referee says halt, mm.
   *
   * @return the live histogram, x and y in mm
   */
  public Grid standing() {
    return standing;
  }

  Histogram standingSquares() {
    return standingSquares;
  }

  /**
   * Noise of one coordinate of standing robots' detections.
   *
   * @return standard deviation, mm; NaN when none stood in a halt
   */
  public double standingNoiseMm() {
    return StandingNoise.standardDeviation(standingSquares);
  }

  /**
   * Detections of robots.
   *
   * @return all detections, counted or not
   */
  public long detections() {
    return detections;
  }

  /**
   * Detections while movements counted.
   *
   * @return without the refused ones
   */
  public long counted() {
    return counted;
  }

  /**
   * Detections that cannot have been the robot they name: exchanged identities, misread patterns, jumps.
   *
   * @return their number
   */
  public long refused() {
    return refused;
  }

  /**
   * Frames that came twice or after a later one of the same camera.
   *
   * @return their number
   */
  public long repeatedFrames() {
    return repeatedFrames;
  }

  /**
   * Frames that were left out, since eight other cameras sent frames at the time.
   *
   * @return how many
   */
  public long surplusFrames() {
    return surplusFrames;
  }

  /**
   * Whether a referee said when the ball was in play.
   *
   * @return false when everything was counted
   */
  public boolean refereeSeen() {
    return refereeSeen;
  }
}
