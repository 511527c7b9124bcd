package fieldcal.app.compare;

import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.KickBehaviour;
import fieldcal.simulation.KickBehaviour.Bias;
import fieldcal.simulation.RandomStream;
import fieldcal.simulation.imaging.InstalledCamera;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.vision.Team;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * One thing that a simulator has otherwise than the field.
 *
 * @param words what it is, with its size
 * @param part of the field that it concerns: ball, causes, cameras, kickers or robots
 * @param named ids of {@code compare.json} that name it, up to a dot
 * @param follows ids of what it changes also: nobody must name these, and none of them is invented
 * @param change makes it
 */
record DrawnDifference(
    String words,
    String part,
    List<String> named,
    List<String> follows,
    UnaryOperator<FieldDraw> change) {
  static final List<String> PARTS = List.of("ball", "causes", "cameras", "kickers", "robots");

  private static final List<String> BALL =
      List.of(
          "accSlide", "accRoll", "kSwitch", "dampingXyFirstHop", "dampingXyOtherHops", "dampingZ");

  /** Smallest and largest change of each parameter, as a share: what carpets and halls differ by. */
  private static final double[][] BALL_CHANGES = {
    {0.06, 0.2}, {0.08, 0.3}, {0.02, 0.06}, {0.03, 0.1}, {0.02, 0.05}, {0.03, 0.1}
  };

  static final int KINDS_OF_BALL = BALL.size();
  static final int KINDS_OF_CAUSES = 6;
  static final int KINDS_OF_CAMERAS = 7;
  static final int KINDS_OF_KICKERS = 4;
  static final int KINDS_OF_LIMITS = 3;

  static DrawnDifference ball(int parameter, RandomStream random) {
    double[] range = BALL_CHANGES[parameter];
    double share = (random.happens(0.5) ? 1 : -1) * random.uniform(range[0], range[1]);
    return new DrawnDifference(
        words("%s %+.1f %%", BALL.get(parameter), 100 * share),
        "ball",
        List.of(BALL.get(parameter)),
        List.of(),
        f -> f.withBall(parameter, f.ball()[parameter] * (1 + share)));
  }

  /** A cause that the simulator has and the field lacks; the other way round by {@link DrawnPair}. */
  static DrawnDifference cause(int kind, RandomStream random) {
    double sign = random.happens(0.5) ? 1 : -1;
    String angle = words("direction=%.3f", random.uniform(-Math.PI, Math.PI));
    double size = random.uniform(1, 2);
    String effect =
        switch (kind) {
          case 0 -> words("air_drag:cd=%.3f", 0.3 * size);
          case 1 -> words("field_slope:percent=%.3f,%s", 0.1 * size, angle);
          case 2 -> words("carpet_nap:amplitude=%.3f,%s", 0.05 * size, angle);
          case 3 -> words("speed_dependent_roll:slope=%.4f", 0.02 * size);
          // The same spin of all kicks is another kSwitch and nothing else.
          case 4 -> words("kick_spin:fraction=%.3f,scatter=%.3f", sign * 0.12 * size, 0.05 * size);
          default -> words("speed_dependent_restitution:slope=%.3f", 0.08 * size);
        };
    EffectSetting setting = EffectSetting.parse(effect);
    return new DrawnDifference(
        effect, "causes", List.of(setting.effect().id()), List.of(), f -> f.with(setting));
  }

  static DrawnDifference camera(int kind, RandomStream random) {
    int id = random.below(FieldDraw.CAMERAS);
    double size = random.uniform(1, 2);
    double angle = random.uniform(-Math.PI, Math.PI);
    String of = "." + id;
    return switch (kind) {
      case 0 ->
          camera(
              words("noise of camera %d x %.2f", id, 1 + 0.4 * size),
              id,
              List.of("noise" + of),
              List.of(),
              c ->
                  camera(c, c.ballNoise() * (1 + 0.4 * size), c.rate(), c.latency(), c.nuisance()));
      case 1 ->
          camera(
              words("rate of camera %d - %.0f %%", id, 8 * size),
              id,
              List.of("interval" + of),
              List.of("interval_scatter" + of),
              c ->
                  camera(
                      c, c.ballNoise(), c.rate() * (1 - 0.08 * size), c.latency(), c.nuisance()));
      case 2 ->
          camera(
              words("delay of camera %d + %.1f ms", id, 4 * size),
              id,
              List.of("delay" + of),
              List.of(),
              c -> c.withLatency(c.latency() + 0.004 * size));
      case 3 ->
          camera(
              words("camera %d loses %.1f %% of its frames", id, 4 * size),
              id,
              List.of("lost" + of),
              List.of("interval" + of, "interval_scatter" + of),
              c -> c(c, nuisance(c.nuisance(), c.nuisance().ballMiss(), 0.04 * size)));
      case 4 ->
          camera(
              words("camera %d misses %.1f %% of the balls", id, 5 * size),
              id,
              List.of("missed_balls" + of),
              List.of(),
              c -> c(c, nuisance(c.nuisance(), 0.05 * size, c.nuisance().frameDrop())));
      case 5 ->
          camera(
              words("camera %d offset %.0f mm towards %.1f rad", id, 10 * size, angle),
              id,
              List.of("offset_x" + of, "offset_y" + of),
              // Offsets count from the mean of all cameras.
              List.of("offset_x", "offset_y"),
              c ->
                  c.withErrors(
                      c.errors()
                          .withOffset(
                              0.01 * size * Math.cos(angle), 0.01 * size * Math.sin(angle))));
      default ->
          camera(
              words("camera %d sees %.1f %% false balls", id, 2 * size),
              id,
              List.of("false_balls"),
              List.of(),
              c -> c(c, falseBalls(c.nuisance(), 0.02 * size)));
    };
  }

  private static DrawnDifference camera(
      String words,
      int id,
      List<String> named,
      List<String> follows,
      UnaryOperator<InstalledCamera> change) {
    return new DrawnDifference(words, "cameras", named, follows, f -> f.withCamera(id, change));
  }

  static DrawnDifference kicker(int kind, RandomStream random) {
    double sign = random.happens(0.5) ? 1 : -1;
    double size = random.uniform(1, 2);
    return switch (kind) {
      case 0 ->
          kicker(
              words("kicks %+.1f %% faster", sign * 3 * size),
              "kick_gain",
              k -> k.withBiases(biases(sign * 0.03 * size, 0)));
      case 1 ->
          kicker(
              words("kicks %+.0f mrad to the left", sign * 12 * size),
              "kick_aim",
              k -> k.withBiases(biases(0, sign * 0.012 * size)));
      case 2 ->
          kicker(
              words("speeds scatter x %.1f", 2 * size),
              "kick_scatter",
              k -> scattered(k, 2 * size, 1));
      default ->
          kicker(
              words("directions scatter x %.1f", 2 * size),
              "kick_aim_scatter",
              k -> scattered(k, 1, 2 * size));
    };
  }

  private static DrawnDifference kicker(
      String words, String id, UnaryOperator<KickBehaviour> change) {
    return new DrawnDifference(
        words, "kickers", List.of(id), List.of(), f -> f.withKicker(change.apply(f.kicker())));
  }

  static DrawnDifference limit(int kind, RandomStream random) {
    double factor = 1 + (random.happens(0.5) ? 1 : -1) * random.uniform(0.15, 0.3);
    String name = List.of("velocity", "acceleration", "braking").get(kind);
    return new DrawnDifference(
        words("largest %s x %.2f", name, factor),
        "robots",
        List.of("limit.yellow." + name, "limit.blue." + name),
        List.of(),
        f -> f.withLimits(limits(f.limits(), kind, factor)));
  }

  private static RobotLimits limits(RobotLimits l, int kind, double factor) {
    return new RobotLimits(
        l.velocity() * (kind == 0 ? factor : 1),
        l.acceleration() * (kind == 1 ? factor : 1),
        l.braking() * (kind == 2 ? factor : 1),
        l.angularVelocity(),
        l.angularAcceleration(),
        l.torqueLoss(),
        l.directionality());
  }

  private static List<Bias> biases(double speed, double yaw) {
    return List.of(
        new Bias(speed, yaw, Team.YELLOW, Optional.empty()),
        new Bias(speed, yaw, Team.BLUE, Optional.empty()));
  }

  private static KickBehaviour scattered(KickBehaviour k, double speed, double direction) {
    return new KickBehaviour(
        k.speedScatter() * speed,
        k.directionScatter() * direction,
        k.elevationScatter(),
        k.rollSpin(),
        k.rollSpinScatter(),
        k.chipSpin(),
        k.sideSpin(),
        k.sideSpinScatter(),
        k.biases(),
        k.spinTables());
  }

  private static InstalledCamera c(InstalledCamera c, Nuisance nuisance) {
    return camera(c, c.ballNoise(), c.rate(), c.latency(), nuisance);
  }

  private static InstalledCamera camera(
      InstalledCamera c, double noise, double rate, double latency, Nuisance nuisance) {
    return new InstalledCamera(
        c.vision(),
        c.announced(),
        c.reportsPixels(),
        c.view(),
        noise,
        c.noiseGrowth(),
        c.robotNoise(),
        c.robotAngleNoise(),
        rate,
        c.phase(),
        latency,
        c.latencySpread(),
        nuisance,
        c.errors());
  }

  private static Nuisance nuisance(Nuisance n, double miss, double drop) {
    return new Nuisance(
        n.falseBallRate(),
        n.falseClusterRate(),
        miss,
        n.robotMiss(),
        drop,
        n.burstRate(),
        n.jitter(),
        n.stampNoise(),
        n.duplicates(),
        n.shadows(),
        n.outages());
  }

  private static Nuisance falseBalls(Nuisance n, double rate) {
    return new Nuisance(
        rate,
        n.falseClusterRate(),
        n.ballMiss(),
        n.robotMiss(),
        n.frameDrop(),
        n.burstRate(),
        n.jitter(),
        n.stampNoise(),
        n.duplicates(),
        n.shadows(),
        n.outages());
  }

  private static String words(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }

  /** Whether an id names it. */
  boolean isNamedBy(String id) {
    return named.stream().anyMatch(n -> isOrIsOf(id, n));
  }

  /** Whether an id follows from it. */
  boolean explains(String id) {
    return isNamedBy(id) || follows.stream().anyMatch(f -> isOrIsOf(id, f));
  }

  private static boolean isOrIsOf(String id, String name) {
    return id.equals(name) || id.startsWith(name + ".");
  }
}
