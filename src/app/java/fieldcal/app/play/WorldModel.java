package fieldcal.app.play;

import fieldcal.play.PlayWorld;
import fieldcal.play.PlayWorld.Permission;
import fieldcal.play.PlayWorld.Robot;
import fieldcal.play.VisionDelay;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** From frames to the world that the play is told: ball and robots over all cameras. Not thread-safe. */
public final class WorldModel {
  private static final double FORGET = 10;

  private final CameraOffsets offsets = new CameraOffsets();
  private final BallTracker ball = new BallTracker(offsets);
  private final Map<RobotId, RobotTracker> robots = new TreeMap<>();
  private final VisionDelay vision = new VisionDelay();
  private double newest = Double.NEGATIVE_INFINITY;

  /** Nothing seen yet. */
  public WorldModel() {}

  /**
   * Takes the next frame.
   *
   * @param frame of any camera
   */
  public void accept(VisionFrame frame) {
    newest = frame.captureTime();
    ball.accept(frame);
    for (RobotDetection robot : frame.robots()) {
      robots
          .computeIfAbsent(robot.id(), id -> new RobotTracker(id, offsets))
          .accept(frame.cameraId(), robot, frame.captureTime());
    }
  }

  /**
   * The world at a time.
   *
   * @param now s, on the clock of the frames
   * @param permission what the referee allows
   * @return what is known
   */
  public PlayWorld at(double now, Permission permission) {
    vision.update(now, newest, 0);
    List<Robot> seen = new ArrayList<>();
    for (RobotTracker tracker : robots.values()) {
      if (!tracker.known()) {
        continue;
      }
      Robot robot = tracker.at(now, vision.delay());
      if (now - robot.seen() < FORGET) {
        seen.add(robot);
      }
    }
    return new PlayWorld(now, newest, ball.ball(now), seen, permission);
  }

  /**
   * How late frames arrive, as {@link #at} has found in every tick.
   *
   * @return s
   */
  public double visionDelay() {
    return vision.delay();
  }
}
