package fieldcal.simulation.imaging;

import fieldcal.camera.Camera;
import java.util.List;

/** Whether robots stand between a camera and the ball. */
final class Occlusion {
  private static final double BALL_RADIUS = Camera.BALL_RADIUS;

  private Occlusion() {}

  /** Share of the ball that is visible, 0 … 1, by how close the ray passes the robots' cylinders. */
  static double visibleShare(Camera camera, double[] ball, List<RobotView> robots) {
    double share = 1;
    double centre = ball[2] + BALL_RADIUS;
    for (RobotView robot : robots) {
      if (centre >= robot.height()) {
        continue;
      }
      // The part of the ray below the robot's top, seen from above.
      double part = (robot.height() - centre) / (camera.positionZ() - centre);
      double dx = part * (camera.positionX() - ball[0]);
      double dy = part * (camera.positionY() - ball[1]);
      double toX = robot.x() - ball[0];
      double toY = robot.y() - ball[1];
      double squared = dx * dx + dy * dy;
      double along = squared == 0 ? 0 : Math.max(0, Math.min(1, (toX * dx + toY * dy) / squared));
      double distance = Math.hypot(toX - along * dx, toY - along * dy);
      double free = (distance - RobotView.RADIUS + BALL_RADIUS) / (2 * BALL_RADIUS);
      // A ball at a dribbler overlaps the circle without being hidden from its own side.
      if (along > 0 || distance < RobotView.RADIUS) {
        share = Math.min(share, Math.max(0, free));
      }
    }
    return share;
  }
}
