package fieldcal.kick;

import fieldcal.ball.BallTrajectory;
import fieldcal.camera.Camera;
import fieldcal.vision.BallDetection;
import fieldcal.vision.FieldGeometry;
import fieldcal.vision.RobotDetection;
import fieldcal.vision.RobotId;
import fieldcal.vision.Team;
import fieldcal.vision.VisionFrame;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.DoubleFunction;

/** Frames of a small scene: balls and robots that follow given paths, seen by cameras with offset, noise and a part of the field. */
final class FrameScene {
  static final RobotId KICKER = new RobotId(Team.YELLOW, 3);
  static final RobotId OTHER = new RobotId(Team.BLUE, 7);

  /** A place on the field at a time: x, y, z; null when it is not there. */
  interface Path extends DoubleFunction<double[]> {}

  private record Eye(Camera camera, double dx, double dy, double xMin, double xMax) {}

  private final List<Eye> eyes = new ArrayList<>();
  private final List<Path> balls = new ArrayList<>();
  private final Map<RobotId, Path> robots = new HashMap<>();
  private final SplittableRandom random = new SplittableRandom(17);
  private double noise = 0.001;

  /** A camera 6 m above (x, 0) that adds (dx, dy) to what it sees and sees xMin to xMax. */
  FrameScene camera(double x, double dx, double dy, double xMin, double xMax) {
    eyes.add(new Eye(Camera.ofPosition(eyes.size(), x, 0, 6), dx, dy, xMin, xMax));
    return this;
  }

  FrameScene noise(double sigma) {
    noise = sigma;
    return this;
  }

  FrameScene ball(Path path) {
    balls.add(path);
    return this;
  }

  FrameScene ball(BallTrajectory trajectory) {
    return ball(along(trajectory));
  }

  static Path along(BallTrajectory trajectory) {
    return t -> {
      double[] p = new double[3];
      trajectory.positionAt(t, p);
      return p;
    };
  }

  FrameScene robot(RobotId id, double x, double y) {
    return robot(id, t -> new double[] {x, y, 0});
  }

  FrameScene robot(RobotId id, Path path) {
    robots.put(id, path);
    return this;
  }

  FieldGeometry geometry() {
    return FieldGeometry.of(12, 9, 1.8, 0.18, 0.3, List.of());
  }

  Map<Integer, Camera> cameras() {
    Map<Integer, Camera> map = new HashMap<>();
    for (int id = 0; id < eyes.size(); id++) {
      map.put(id, eyes.get(id).camera());
    }
    return map;
  }

  /** What all cameras see at 73 Hz between two times, in order of capture. */
  List<VisionFrame> frames(double from, double to) {
    List<VisionFrame> frames = new ArrayList<>();
    for (int id = 0; id < eyes.size(); id++) {
      for (int k = 0; k < (to - from) * 73; k++) {
        frames.add(frame(id, k, from + k / 73.0 + 0.004 * id));
      }
    }
    frames.sort(Comparator.comparingDouble(VisionFrame::captureTime));
    return frames;
  }

  VisionFrame frame(int id, int number, double t) {
    Eye eye = eyes.get(id);
    List<BallDetection> seen = new ArrayList<>();
    for (Path path : balls) {
      double[] p = path.apply(t);
      double nx = noise * gaussian();
      double ny = noise * gaussian();
      if (p == null) {
        continue;
      }
      double[] ground = new double[2];
      eye.camera().projectToGround(p[0], p[1], p[2], ground);
      if (ground[0] >= eye.xMin() && ground[0] <= eye.xMax()) {
        seen.add(
            new BallDetection(
                ground[0] + eye.dx() + nx, ground[1] + eye.dy() + ny, Double.NaN, 1, 60, 0, 0));
      }
    }
    List<RobotDetection> machines = new ArrayList<>();
    robots.forEach(
        (robot, path) -> {
          double[] p = path.apply(t);
          if (p != null && p[0] >= eye.xMin() && p[0] <= eye.xMax()) {
            machines.add(
                new RobotDetection(robot, p[0] + eye.dx(), p[1] + eye.dy(), 0, 1, Double.NaN));
          }
        });
    return new VisionFrame(id, number, t, t + 0.01, Double.NaN, seen, machines);
  }

  private double gaussian() {
    return Math.sqrt(-2 * Math.log(1 - random.nextDouble()))
        * Math.cos(2 * Math.PI * random.nextDouble());
  }

  /** The kicks found in frames of this scene. */
  List<Kick> kicks(List<VisionFrame> frames) {
    List<Kick> kicks = new ArrayList<>();
    KickFinder finder = new KickFinder(KickFinderSettings.defaults(), kicks::add);
    finder.geometry(geometry(), cameras());
    frames.forEach(finder::accept);
    finder.finish();
    return kicks;
  }

  List<Kick> kicks(double from, double to) {
    return kicks(frames(from, to));
  }
}
