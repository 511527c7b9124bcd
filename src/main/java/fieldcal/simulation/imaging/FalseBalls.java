package fieldcal.simulation.imaging;

import fieldcal.simulation.RandomStream;
import fieldcal.vision.BallDetection;
import java.util.List;

/** False detections of balls: single ones anywhere, and series at one place near a robot (its pattern, a reflection). */
final class FalseBalls {
  private final Nuisance nuisance;
  private final RandomStream random;
  private final double[] pixel = new double[2];

  private int clusterFrames;
  private int clusterRobot;
  private double clusterX;
  private double clusterY;
  private double clusterZ;

  FalseBalls(Nuisance nuisance, RandomStream random) {
    this.nuisance = nuisance;
    this.random = random;
  }

  void addTo(List<BallDetection> balls, List<RobotView> robots, SimulatedCamera camera) {
    if (random.happens(nuisance.falseBallRate())) {
      camera.anywhere(random, pixel);
      add(balls, camera);
    }
    if (clusterFrames == 0 && random.happens(nuisance.falseClusterRate())) {
      clusterFrames = 3 + random.below(25);
      clusterRobot = random.below(1000);
      clusterX = random.gaussian(0.06);
      clusterY = random.gaussian(0.06);
      clusterZ = random.uniform(0.02, 0.15);
    }
    if (clusterFrames > 0) {
      clusterFrames--;
      if (robots.isEmpty()) {
        return;
      }
      RobotView robot = robots.get(clusterRobot % robots.size());
      if (random.happens(0.7)
          && camera.imageOf(robot.x() + clusterX, robot.y() + clusterY, clusterZ, pixel)) {
        pixel[0] += random.gaussian(1.5);
        pixel[1] += random.gaussian(1.5);
        add(balls, camera);
      }
    }
  }

  private void add(List<BallDetection> balls, SimulatedCamera camera) {
    int area = 15 + random.below(120);
    double confidence = random.uniform(0.3, 0.95);
    boolean before = random.happens(0.5);
    BallDetection detection = camera.report(pixel[0], pixel[1], area, confidence);
    if (detection != null) {
      balls.add(before ? 0 : balls.size(), detection);
    }
  }
}
