package fieldcal.ball;

import java.util.OptionalDouble;

/** A path made of pieces with constant acceleration, one after the other; all questions are answered piece by piece. */
abstract class SegmentedTrajectory implements BallTrajectory {
  private final Segment[] segments;
  private final double[] ends;
  private final double[] startDistances;
  private final double kickX;
  private final double kickY;
  private final double kickZ;
  private final double restX;
  private final double restY;
  private final double kickTime;
  private final double restTime;
  private final double restDistance;

  /**
   * A path.
   *
   * @param segments at least one, each beginning where and when the one before ends, the last one ending at rest; not copied
   */
  SegmentedTrajectory(Segment[] segments) {
    this.segments = segments;
    this.ends = new double[segments.length];
    this.startDistances = new double[segments.length];
    double distance = 0;
    for (int i = 0; i < segments.length; i++) {
      ends[i] = segments[i].end();
      startDistances[i] = distance;
      distance += segments[i].length(segments[i].duration);
    }
    Segment first = segments[0];
    Segment last = segments[segments.length - 1];
    kickX = first.x;
    kickY = first.y;
    kickZ = first.z;
    restX = last.xAt(last.duration);
    restY = last.yAt(last.duration);
    kickTime = first.start;
    restTime = last.end();
    restDistance = distance;
  }

  @Override
  public final double kickTime() {
    return kickTime;
  }

  @Override
  public final double restTime() {
    return restTime;
  }

  @Override
  public final double restDistance() {
    return restDistance;
  }

  @Override
  public final BallState stateAt(double t) {
    if (t < kickTime) {
      return new BallState(kickX, kickY, kickZ, 0, 0, 0);
    }
    int i = indexAt(t);
    if (i == segments.length) {
      return new BallState(restX, restY, 0, 0, 0, 0);
    }
    return segments[i].stateAt(t - segments[i].start);
  }

  @Override
  public final void positionAt(double t, double[] xyz) {
    if (t < kickTime) {
      xyz[0] = kickX;
      xyz[1] = kickY;
      xyz[2] = kickZ;
      return;
    }
    int i = indexAt(t);
    if (i == segments.length) {
      xyz[0] = restX;
      xyz[1] = restY;
      xyz[2] = 0;
      return;
    }
    Segment segment = segments[i];
    double tau = t - segment.start;
    xyz[0] = segment.xAt(tau);
    xyz[1] = segment.yAt(tau);
    xyz[2] = segment.zAt(tau);
  }

  @Override
  public final Phase phaseAt(double t) {
    if (t < kickTime) {
      return Phase.RESTING_BEFORE_KICK;
    }
    int i = indexAt(t);
    return i == segments.length ? Phase.STOPPED : segments[i].phase;
  }

  @Override
  public final double distanceAt(double t) {
    if (t < kickTime) {
      return 0;
    }
    int i = indexAt(t);
    return i == segments.length
        ? restDistance
        : startDistances[i] + segments[i].length(t - segments[i].start);
  }

  @Override
  public final OptionalDouble timeAtDistance(double distance) {
    Checks.notNegative("distance", distance);
    if (distance > restDistance) {
      return OptionalDouble.empty();
    }
    int i = 0;
    while (i + 1 < segments.length && distance > startDistances[i + 1]) {
      i++;
    }
    double tau = segments[i].timeAtLength(distance - startDistances[i]);
    return OptionalDouble.of(segments[i].start + tau);
  }

  @Override
  public final OptionalDouble speedAtDistance(double distance) {
    OptionalDouble time = timeAtDistance(distance);
    return time.isEmpty() ? time : OptionalDouble.of(stateAt(time.getAsDouble()).groundSpeed());
  }

  /**
   * Which piece holds at a time that is not before the kick.
   *
   * @return its index, or the number of pieces when the ball rests
   * @throws IllegalArgumentException when {@code t} is NaN
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

  final int segmentCount() {
    return segments.length;
  }

  final Segment segment(int index) {
    return segments[index];
  }
}
