package fieldcal.app.compare;

import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.FieldSize;
import fieldcal.simulation.KickBehaviour;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.ScenarioKind;
import fieldcal.simulation.ScenarioSettings;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraErrors;
import fieldcal.simulation.imaging.CameraRig;
import fieldcal.simulation.imaging.InstalledCamera;
import fieldcal.simulation.imaging.InstalledCamera.NoiseGrowth;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.Region;
import fieldcal.simulation.robot.RobotLimits;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;

/**
 * A field that is drawn, part by part, so that another can differ from it in one of them.
 *
 * @param ball accSlide, accRoll (m/s²), kSwitch, dampingXyFirstHop, dampingXyOtherHops, dampingZ
 * @param effects what is wrong with it
 * @param cameras the cameras one by one
 * @param kicker how kicks differ from commands
 * @param limits of the robots of both teams
 */
record FieldDraw(
    double[] ball,
    List<EffectSetting> effects,
    List<InstalledCamera> cameras,
    KickBehaviour kicker,
    RobotLimits limits) {
  static final int CAMERAS = 4;
  private static final double HEIGHT = 5.3;
  private static final double OVERLAP = 0.5;

  /** 1/(1+β) of a solid sphere: the catalogue's causes of a rolling ball are those of a golf ball. */
  private static final double SOLID = 1 / 1.4;

  /** The scenario drives at most 2.5 m/s; no recording of it shows more. */
  private static final RobotLimits LIMITS = new RobotLimits(1.9, 3, 3.5, 10, 40, 0, 0);

  static FieldDraw of(RandomStream random, boolean solid) {
    double[] ball = {
      -random.uniform(2.6, 3.8),
      -random.uniform(0.22, 0.36),
      random.uniform(0.6, 0.68),
      random.uniform(0.68, 0.82),
      random.uniform(0.88, 0.94),
      random.uniform(0.46, 0.56)
    };
    if (solid) {
      ball[2] = SOLID;
    }
    List<InstalledCamera> cameras = new ArrayList<>();
    for (int id = 0; id < CAMERAS; id++) {
      cameras.add(camera(id, random));
    }
    return new FieldDraw(ball, List.of(), cameras, KickBehaviour.DEFAULT, LIMITS);
  }

  private static InstalledCamera camera(int id, RandomStream random) {
    FieldSize field = FieldSize.DIVISION_A;
    double halfX = field.length() / 4;
    double halfY = field.width() / 4;
    double x = (id / 2 == 0 ? -1 : 1) * halfX + random.gaussian(0.05);
    double y = (id % 2 == 0 ? -1 : 1) * halfY + random.gaussian(0.05);
    Region area =
        new Region(
            x - halfX - OVERLAP, x + halfX + OVERLAP, y - halfY - OVERLAP, y + halfY + OVERLAP);
    var looks = CameraRig.lookingDown(id, x, y, HEIGHT * (1 + random.gaussian(0.01)), area);
    double noise = random.uniform(0.001, 0.002);
    return new InstalledCamera(
        looks,
        looks,
        true,
        Region.NONE,
        noise,
        NoiseGrowth.IMAGE,
        1.75 * noise,
        0.008,
        random.uniform(68, 76),
        random.uniform(0, 0.013),
        random.uniform(0.008, 0.015),
        0.001,
        Nuisance.TYPICAL,
        CameraErrors.NONE);
  }

  FieldDraw withBall(int parameter, double value) {
    double[] other = ball.clone();
    other[parameter] = value;
    return new FieldDraw(other, effects, cameras, kicker, limits);
  }

  FieldDraw with(EffectSetting effect) {
    List<EffectSetting> more = new ArrayList<>(effects);
    more.add(effect);
    return new FieldDraw(ball, more, cameras, kicker, limits);
  }

  FieldDraw withCamera(int id, UnaryOperator<InstalledCamera> change) {
    List<InstalledCamera> others = new ArrayList<>(cameras);
    others.set(id, change.apply(others.get(id)));
    return new FieldDraw(ball, effects, others, kicker, limits);
  }

  FieldDraw withKicker(KickBehaviour other) {
    return new FieldDraw(ball, effects, cameras, other, limits);
  }

  FieldDraw withLimits(RobotLimits other) {
    return new FieldDraw(ball, effects, cameras, kicker, other);
  }

  SimulationSettings settings(int kicks, long seed) {
    return SimulationSettings.DEFAULT
        .withScenario(ScenarioSettings.of(ScenarioKind.MIXED, kicks).withLimits(limits, limits))
        .withSeed(seed)
        .withPhysics(BallPhysics.ideal(ball[0], ball[1], ball[2], ball[3], ball[4], ball[5]))
        .withKickBehaviour(kicker)
        .withNuisance(Nuisance.NONE)
        .withCameras(SimulationSettings.DEFAULT.cameras().withCount(CAMERAS))
        .withInstalled(cameras)
        .withEffects(effects);
  }
}
