package fieldcal.diagnosis.hidden;

import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.FieldSize;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.SimulatedEffect;
import fieldcal.simulation.SimulationSettings;
import fieldcal.vision.RobotId;
import java.util.List;
import java.util.Locale;

/**
 * Draws the strengths of effects. They grow with the cameras' noise: what can be seen depends on both only by their ratio. They spread over a factor of eight; what came out clear and what
 * marginal is measured, see {@link Visibility}.
 */
final class EffectDraw {
  private static final double USUAL_NOISE = 0.0015;

  /** Session time of a kick of the calibration scenarios, s (measured). */
  private static final double SECONDS_PER_KICK = 7;

  private final RandomStream random;
  private final SimulationSettings world;
  private final List<RobotId> kickers;
  private final double noise;
  private final boolean strong;

  EffectDraw(RandomStream random, SimulationSettings world, List<RobotId> kickers, boolean strong) {
    this.random = random;
    this.world = world;
    this.kickers = kickers;
    this.strong = strong;
    noise = world.cameras().ballNoise() / USUAL_NOISE;
  }

  /** A strength around a usual one, of either sign. */
  private double about(double usual) {
    return (random.happens(0.5) ? 1 : -1) * positive(usual);
  }

  private double positive(double usual) {
    double lowest = strong ? 0.9 : 0.4;
    return usual * noise * lowest * Math.pow(3.2 / lowest, random.uniform(0, 1));
  }

  private double angle() {
    return random.uniform(-Math.PI, Math.PI);
  }

  private static double limited(double value, double min, double max) {
    return Math.max(min, Math.min(max, value));
  }

  EffectSetting setting(SimulatedEffect effect) {
    return switch (effect) {
      case AIR_DRAG -> set(effect, "cd", limited(positive(0.4), 0, 1.9));
      case MAGNUS -> set(effect, "cl", limited(about(2), -1.95, 1.95));
      case KICK_SPIN ->
          set(effect, "fraction", random.uniform(-0.5, 0.3))
              .with("scatter", number(limited(positive(0.04), 0, 0.4)));
      case SIDE_SPIN ->
          set(effect, "fraction", limited(about(0.06), -0.8, 0.8))
              .with("scatter", number(random.happens(0.5) ? limited(positive(0.03), 0, 0.3) : 0));
      case FIELD_SLOPE ->
          set(effect, "percent", limited(positive(0.06), 0, 2)).with("direction", number(angle()));
      case CARPET_NAP ->
          set(effect, "amplitude", limited(positive(0.022), 0, 0.7))
              .with("direction", number(angle()));
      case SPEED_DEPENDENT_ROLL -> set(effect, "slope", limited(about(0.01), -0.03, 0.5));
      case WORN_REGION ->
          set(effect, "change", limited(about(0.085), -0.6, 2)).with("region", region());
      case CAMERA_OFFSET -> {
        double size = positive(8);
        double direction = angle();
        yield set(effect, "x_mm", size * Math.cos(direction))
            .with("y_mm", number(size * Math.sin(direction)))
            .with("camera", camera());
      }
      case CAMERA_TIME_OFFSET -> set(effect, "ms", about(6)).with("camera", camera());
      case CAMERA_POSE_ERROR -> pose();
      case CAMERA_POSITION_ERROR -> {
        double direction = angle();
        double size = positive(50);
        yield set(effect, "x_mm", size * Math.cos(direction))
            .with("y_mm", number(size * Math.sin(direction)))
            .with("height_mm", number(random.happens(0.5) ? about(80) : 0))
            .with("camera", camera());
      }
      case LENS_DISTORTION_ERROR ->
          set(effect, "delta", limited(about(0.013), -0.08, 0.08)).with("camera", camera());
      case BALL_HEIGHT_ERROR -> set(effect, "mm", limited(about(9), -25, 45));
      // Below −0.1 a fast chip would keep more of its speed than any carpet leaves it.
      case SPEED_DEPENDENT_RESTITUTION -> set(effect, "slope", limited(about(0.12), -0.1, 0.28));
      // 2/7 is a ball that grips.
      case BOUNCE_SPIN_COUPLING -> set(effect, "coefficient", limited(positive(0.13), 0, 0.2857));
      case DRIFT -> set(effect, "percent_per_10min", limited(about(17), -120, 400));
      case ROBOT_KICK_BIAS -> {
        RobotId robot = kickers.get(random.below(kickers.size()));
        double size = Math.pow(8, random.uniform(0, 1)) * (random.happens(0.5) ? 1 : -1);
        boolean aside = random.happens(0.5);
        yield set(effect, "percent", aside ? 0 : 1.5 * size)
            .with("yaw", number(aside || random.happens(0.3) ? 0.006 * size : 0))
            .with("team", robot.team().label())
            .with("robot", robot.number());
      }
      case CLOCK_SKEW -> set(effect, "ppm", about(75)).with("camera", camera());
      case ROLLING_SHUTTER -> set(effect, "ms", limited(positive(9), 0, 30));
      case WIND ->
          set(effect, "speed", limited(positive(0.35), 0.05, 5)).with("direction", number(angle()));
      case SLIP_DEPENDENT_FRICTION -> set(effect, "slope", limited(about(0.22), -0.35, 0.8));
      case CAMERA_MOVED -> {
        double size = positive(14);
        double direction = angle();
        yield set(effect, "x_mm", size * Math.cos(direction))
            .with("y_mm", number(size * Math.sin(direction)))
            .with("at", number(duringTheSession()))
            .with("camera", camera());
      }
      case BALL_CHANGED ->
          set(effect, "roll", limited(about(0.025), -0.5, 1))
              .with("slide", number(limited(about(0.012), -0.4, 0.6)))
              .with("at", number(duringTheSession()));
      // About the −0.1 to −0.3 and beyond of engines that integrate the contact. At 0 the contact
      // point
      // sticks, and
      // fixed dampings describe that exactly.
      case CONTACT_IMPACTS ->
          set(effect, "reversed", random.uniform(-0.5, -0.1))
              .with("friction", number(random.uniform(0.25, 0.6)));
      // Through the middle, where most kicks cross it.
      case CARPET_SEAM ->
          set(effect, "loss", limited(positive(0.015), 0, 0.5))
              .with("turn", number(limited(about(0.003), -0.2, 0.2)))
              .with("normal", number(angle()))
              .with("distance", number(random.uniform(-1.2, 1.2)));
      case UNNAMED_RESTITUTION_PLACE ->
          set(effect, "change", limited(about(0.05), -0.3, 0.3)).with("direction", number(angle()));
      case UNNAMED_ROLL_SQUARE -> set(effect, "slope", limited(positive(0.004), 0, 0.3));
      case UNNAMED_ROLL_BUMP ->
          set(effect, "height", limited(about(0.08), -0.7, 3))
              .with("speed", number(random.uniform(0.8, 2.5)))
              .with("width", number(random.uniform(0.25, 0.6)));
      case UNNAMED_FADING_FRICTION ->
          set(effect, "change", limited(about(0.8), -0.7, 4))
              .with("duration", number(random.uniform(0.1, 0.4)));
      case UNNAMED_RING -> {
        double inner = random.uniform(0.8, 2);
        yield set(effect, "change", limited(about(0.2), -0.6, 3))
            .with("inner", number(inner))
            .with("outer", number(inner + random.uniform(0.4, 1)));
      }
      case UNNAMED_ONCE_PER_TURN -> set(effect, "amplitude", limited(positive(2), 0, 6));
      case UNNAMED_FOUR_WAYS ->
          set(effect, "amplitude", limited(about(0.04), -0.5, 0.5))
              .with("direction", number(angle()));
      case UNNAMED_IMPACT_SPEED -> set(effect, "slope", limited(about(0.03), -0.1, 0.1));
      case UNNAMED_SIDE_FORCE -> set(effect, "rate", limited(about(0.0022), -0.5, 0.5));
      case UNNAMED_PATCHES ->
          set(effect, "change", limited(positive(0.6), 0, 6))
              .with("pitch", number(random.uniform(0.6, 1.5)));
      case UNNAMED_LENS_SHEAR -> set(effect, "mm", about(40)).with("camera", camera());
      case CARPET_WAVES ->
          set(effect, "amplitude", limited(positive(0.09), 0, 0.85))
              .with("wavelength", number(random.uniform(1.2, 4)));
      case CAMERA_SHAKE ->
          set(effect, "amplitude_mm", positive(10))
              .with("hz", number(random.uniform(0.4, 3)))
              .with("camera", camera());
      case TORQUE_LIMITED, DIRECTIONAL ->
          throw new IllegalArgumentException("no effect on the ball: " + effect);
    };
  }

  private EffectSetting pose() {
    SimulatedEffect effect = SimulatedEffect.CAMERA_POSE_ERROR;
    EffectSetting camera = set(effect, "tilt_mrad", 0).with("camera", camera());
    double direction = angle();
    return switch (random.below(3)) {
      case 0 -> camera.with("tilt_mrad", number(positive(2.2))).with("axis", number(direction));
      case 1 -> camera.with("height_mm", number(about(30)));
      default -> {
        double size = positive(12);
        yield camera
            .with("shift_x_mm", number(size * Math.cos(direction)))
            .with("shift_y_mm", number(size * Math.sin(direction)));
      }
    };
  }

  /** Some time in the middle: a kick, with what is before and after it, takes about that long. */
  private double duringTheSession() {
    return world.scenario().kicks() * SECONDS_PER_KICK * random.uniform(0.3, 0.7);
  }

  private int camera() {
    return random.below(world.cameras().count());
  }

  /** A half, a quarter, or a rectangle around a place that the diagonals cross. */
  private String region() {
    FieldSize field = world.field();
    double x = field.length() / 2 + 0.3;
    double y = field.width() / 2 + 0.3;
    double side = random.happens(0.5) ? 1 : -1;
    if (random.happens(0.3)) {
      return side > 0 ? region(0, x, -y, y) : region(-x, 0, -y, y);
    }
    double centreX = side * random.uniform(0.1, 0.32) * field.length();
    double centreY = centreX / field.length() * field.width() * (random.happens(0.5) ? 1 : -1);
    double halfX = random.uniform(0.1, 0.18) * field.length();
    double halfY = random.uniform(0.15, 0.35) * field.width();
    return region(
        Math.max(-x, centreX - halfX),
        Math.min(x, centreX + halfX),
        Math.max(-y, centreY - halfY),
        Math.min(y, centreY + halfY));
  }

  private static String region(double x0, double x1, double y0, double y1) {
    return String.format(Locale.ROOT, "[%.2f,%.2f,%.2f,%.2f]", x0, x1, y0, y1);
  }

  private static EffectSetting set(SimulatedEffect effect, String name, double value) {
    return EffectSetting.of(effect, name, Double.parseDouble(number(value)));
  }

  /** Four digits, so that a case can be typed. */
  private static String number(double value) {
    return String.format(Locale.ROOT, "%.4g", value);
  }
}
