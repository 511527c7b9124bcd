package fieldcal.ball;

import java.util.OptionalDouble;

/**
 * A path made of pieces with constant acceleration, one after the other, with the rests before and after; all questions are
 * answered piece by piece.
 */
abstract class SegmentedTrajectory implements BallTrajectory {
  /** The rest before the kick, the moving pieces, the rest after them. */
  private final Segment[] segments;

  private final double[] ends;

  /** Computed when a distance is first asked for, which fits never do. All threads compute the same values, and the final fields of a record are visible to all of them. */
  private Distances distances;

  /** How far the ball has come where each piece begins, m. */
  private record Distances(double[] atStart) {}

  /**
   * A path.
   *
   * @param moving at least one, each beginning where and when the one before ends, the last one ending at rest
   */
  SegmentedTrajectory(Segment[] moving) {
    int count = moving.length;
    Segment first = moving[0];
    Segment last = moving[count - 1];
    segments = new Segment[count + 2];
    segments[0] = Segment.rest(Phase.RESTING_BEFORE_KICK, first.start, first.x, first.y, first.z);
    System.arraycopy(moving, 0, segments, 1, count);
    double restX = last.xAt(last.duration);
    double restY = last.yAt(last.duration);
    segments[count + 1] = Segment.rest(Phase.STOPPED, last.end(), restX, restY, 0);
    ends = new double[count + 1];
    for (int i = 0; i <= count; i++) {
      ends[i] = segments[i].end();
    }
  }

  private double[] startDistances() {
    Distances known = distances;
    if (known == null) {
      double[] atStart = new double[ends.length + 1];
      for (int i = 0; i < ends.length; i++) {
        atStart[i + 1] = atStart[i] + segments[i].length(segments[i].duration);
      }
      known = new Distances(atStart);
      distances = known;
    }
    return known.atStart;
  }

  @Override
  public final double kickTime() {
    return ends[0];
  }

  @Override
  public final double restTime() {
    return ends[ends.length - 1];
  }

  @Override
  public final double restDistance() {
    return startDistances()[ends.length];
  }

  @Override
  public final BallState stateAt(double t) {
    Segment segment = segments[indexAt(t)];
    return segment.stateAt(segment.tauAt(t));
  }

  @Override
  public final void positionAt(double t, double[] xyz) {
    position(indexAt(t), t, xyz);
  }

  /** Where the ball is at a time in the piece that holds then. */
  final void position(int index, double t, double[] xyz) {
    Segment segment = segments[index];
    double tau = segment.tauAt(t);
    xyz[0] = segment.xAt(tau);
    xyz[1] = segment.yAt(tau);
    xyz[2] = segment.zAt(tau);
  }

  @Override
  public final Phase phaseAt(double t) {
    return segments[indexAt(t)].phase;
  }

  @Override
  public final double distanceAt(double t) {
    int i = indexAt(t);
    return startDistances()[i] + segments[i].length(segments[i].tauAt(t));
  }

  @Override
  public final OptionalDouble timeAtDistance(double distance) {
    Checks.notNegative("distance", distance);
    if (distance > restDistance()) {
      return OptionalDouble.empty();
    }
    double[] atStart = startDistances();
    int i = 0;
    while (distance > atStart[i + 1]) {
      i++;
    }
    double tau = segments[i].timeAtLength(distance - atStart[i]);
    return OptionalDouble.of(segments[i].start + tau);
  }

  @Override
  public final OptionalDouble speedAtDistance(double distance) {
    OptionalDouble time = timeAtDistance(distance);
    return time.isEmpty() ? time : OptionalDouble.of(stateAt(time.getAsDouble()).groundSpeed());
  }

  /**
   * Number of the piece that holds at a time: 0 = before the kick, 1 = the first moving one, {@code movingCount() + 1} = after
   * the rest.
   */
  final int indexAt(double t) {
    for (int i = 0; i < ends.length; i++) {
      if (t < ends[i]) {
        return i;
      }
    }
    if (Double.isNaN(t)) {
      throw new IllegalArgumentException("t must be a number, but is NaN");
    }
    return ends.length;
  }

  final int movingCount() {
    return segments.length - 2;
  }

  final Segment segment(int index) {
    return segments[index];
  }
}
