package fieldcal.movement;

import fieldcal.vision.RobotId;

/**
 * Follows how one robot turns: makes a steady angle of the orientations that vision reports within ±π, and has it cut into turns.
 *
 * <p>Orientations that the robot cannot have turned to since the last one are misread patterns and are left out; when such orientations agree for a while, the angle begins again.
 */
final class TurnTrack {
  /** Robots do not turn faster, rad/s: twice what the league's fastest do. */
  private static final double FASTEST = 40;

  /** A robot that was not seen for longer may have turned by more than π either way, s. */
  private static final double LONGEST_GAP = Math.PI / FASTEST;

  /** How far an orientation may be off for other reasons: noise, and cameras that disagree, rad. */
  private static final double TOLERANCE = 0.3;

  /** Orientations refused in a row after which the robot is believed to have turned. */
  private static final int PERSISTENT = 6;

  private final PathBlocks path;
  private double time = Double.NEGATIVE_INFINITY;
  private double angle;
  private int refusedInARow;

  TurnTrack(RobotId id, ManoeuvreFinder finder) {
    path = new PathBlocks(id, finder);
  }

  /** Takes an orientation, rad; one that is not finite does not count. */
  void accept(double at, int camera, double orientation) {
    if (!Double.isFinite(orientation)) {
      return;
    }
    double dt = Math.abs(at - time);
    if (!(dt < LONGEST_GAP)) {
      end();
      angle = orientation;
    } else {
      double turned = Math.IEEEremainder(orientation - angle, 2 * Math.PI);
      if (Math.abs(turned) > TOLERANCE + FASTEST * dt) {
        if (++refusedInARow < PERSISTENT) {
          return;
        }
        end();
        angle = orientation;
      } else {
        angle += turned;
      }
    }
    refusedInARow = 0;
    // Cameras are out of order by a frame at most; the later of two times is the reference.
    time = Math.max(time, at);
    path.add(at, angle, 0, 0, camera);
  }

  /** The path breaks off here. */
  void end() {
    path.end();
    time = Double.NEGATIVE_INFINITY;
    refusedInARow = 0;
  }
}
