package fieldcal.app.twin;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.app.calibrate.InputException;
import fieldcal.app.calibrate.JsonFiles;
import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.camera.CameraCalibration;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.FieldSize;
import fieldcal.simulation.KickBehaviour;
import fieldcal.simulation.KickBehaviour.Bias;
import fieldcal.simulation.SimulatedEffect;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraErrors;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.CameraSettings.Exposure;
import fieldcal.simulation.imaging.InstalledCamera;
import fieldcal.simulation.imaging.InstalledCamera.NoiseGrowth;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.ExtraLaw;
import fieldcal.simulation.physics.ImpactLaw.FixedLoss;
import fieldcal.simulation.physics.Region;
import fieldcal.simulation.physics.TabulatedLaw;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.vision.BallModels;
import fieldcal.vision.Team;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * {@code twin.json}: a simulated field, one field of the file for each setting of the simulation. {@code docs/twin.md} describes it. What is read is what was written.
 */
public final class TwinFile {
  /** What the file says it is. */
  static final String SCHEMA = "fieldcal.twin/1";

  private TwinFile() {}

  /**
   * Writes.
   *
   * @param twin what to write; its physics must be {@linkplain BallPhysics#ideal ideal} with tabulated laws
   * @param file where
   * @throws IOException when it cannot be written
   */
  public static void write(Twin twin, Path file) throws IOException {
    JsonFiles.write(document(twin), file);
  }

  /** The document. */
  static ObjectNode document(Twin twin) {
    SimulationSettings s = twin.settings();
    ObjectNode root = new ObjectMapper().createObjectNode();
    root.put("schema", SCHEMA);
    twin.sources().forEach(root.putArray("sources")::add);
    twin.notes().forEach(root.putArray("notes")::add);
    ObjectNode field = root.putObject("field");
    field.put("length", s.field().length());
    field.put("width", s.field().width());
    field.put("boundary", s.field().boundary());
    field.put("goal_width", s.field().goalWidth());
    field.put("goal_depth", s.field().goalDepth());
    ball(s.physics(), root.putObject("ball"));
    ArrayNode causes = root.putArray("causes");
    for (EffectSetting effect : s.effects()) {
      ObjectNode cause = causes.addObject();
      cause.put("effect", effect.effect().id());
      ObjectNode parameters = cause.putObject("parameters");
      effect.values().forEach((name, value) -> put(parameters, name, value));
    }
    ArrayNode learned = root.putArray("learned");
    for (ExtraLaw law : s.physics().extras()) {
      LearnedDocument.add((TabulatedLaw) law, learned);
    }
    s.kickBehaviour().spinTables().forEach(table -> LearnedDocument.add(table, learned));
    for (InstalledCamera c : s.installed()) {
      c.errors().tables().forEach(table -> LearnedDocument.add(table, c.id(), learned));
    }
    ObjectNode vision = root.putObject("vision");
    vision.put("ball_plane", s.cameras().ballPlane());
    vision.put("exposure", label(s.cameras().exposure()));
    ArrayNode cameras = root.putArray("cameras");
    s.installed().forEach(c -> camera(c, cameras.addObject()));
    kickers(s.kickBehaviour(), root.putObject("kickers"));
    ObjectNode robots = root.putObject("robots");
    robots(s.scenario().yellow(), robots.putObject("yellow"));
    robots(s.scenario().blue(), robots.putObject("blue"));
    published(s.publishedModels(), root.putObject("published"));
    return root;
  }

  private static void put(ObjectNode node, String name, String value) {
    try {
      double number = Double.parseDouble(value);
      if (number == Math.rint(number) && Math.abs(number) < 1e9) {
        node.put(name, (long) number);
      } else {
        node.put(name, number);
      }
    } catch (NumberFormatException e) {
      node.put(name, value);
    }
  }

  private static String label(Enum<?> value) {
    return value.name().toLowerCase(Locale.ROOT);
  }

  private static void ball(BallPhysics p, ObjectNode node) {
    FixedLoss loss = (FixedLoss) p.impact().tangential();
    node.put("acc_slide", -p.ground().slidingFriction() * BallPhysics.GRAVITY);
    node.put("acc_roll", -p.ground().rollingDeceleration());
    node.put("k_switch", p.ball().kSwitch());
    node.put("damping_xy_first_hop", loss.firstHop());
    node.put("damping_xy_other_hops", loss.otherHops());
    node.put("damping_z", p.impact().dampingZOtherHops());
  }

  private static void camera(InstalledCamera c, ObjectNode node) {
    node.put("id", c.id());
    calibration(c.vision(), node.putObject("vision"));
    if (c.announced().equals(c.vision())) {
      node.putNull("announced");
    } else {
      calibration(c.announced(), node.putObject("announced"));
    }
    node.put("reports_pixels", c.reportsPixels());
    if (c.view().equals(Region.NONE)) {
      node.putNull("view");
    } else {
      Region v = c.view();
      node.putArray("view").add(v.x0()).add(v.x1()).add(v.y0()).add(v.y1());
    }
    node.put("ball_noise", c.ballNoise());
    node.put("noise_growth", label(c.noiseGrowth()));
    node.put("robot_noise", c.robotNoise());
    node.put("robot_angle_noise", c.robotAngleNoise());
    node.put("rate", c.rate());
    node.put("phase", c.phase());
    node.put("latency", c.latency());
    node.put("latency_spread", c.latencySpread());
    Nuisance n = c.nuisance();
    node.put("jitter", n.jitter());
    node.put("stamp_noise", n.stampNoise());
    node.put("lost_frames", n.frameDrop());
    node.put("interruptions_per_second", n.burstRate());
    node.put("duplicates", n.duplicates());
    node.put("missed_balls", n.ballMiss());
    node.put("missed_robots", n.robotMiss());
    node.put("false_balls", n.falseBallRate());
    node.put("false_ball_series", n.falseClusterRate());
    node.put("robots_hide_balls", n.shadows());
  }

  private static void calibration(CameraCalibration c, ObjectNode node) {
    node.put("focal_length", c.focalLength());
    node.putArray("principal_point").add(c.principalPointX()).add(c.principalPointY());
    node.put("distortion", c.distortion());
    node.putArray("rotation").add(c.q0()).add(c.q1()).add(c.q2()).add(c.q3());
    node.putArray("translation").add(c.tx()).add(c.ty()).add(c.tz());
    if (Double.isNaN(c.derivedWorldX())) {
      node.putNull("position");
    } else {
      node.putArray("position")
          .add(c.derivedWorldX())
          .add(c.derivedWorldY())
          .add(c.derivedWorldZ());
    }
    node.putArray("image").add(c.imageWidth()).add(c.imageHeight());
  }

  private static void kickers(KickBehaviour k, ObjectNode node) {
    node.put("speed_scatter", k.speedScatter());
    node.put("direction_scatter", k.directionScatter());
    node.put("elevation_scatter", k.elevationScatter());
    node.put("roll_spin", k.rollSpin());
    node.put("roll_spin_scatter", k.rollSpinScatter());
    node.put("chip_spin", k.chipSpin());
    node.put("side_spin", k.sideSpin());
    node.put("side_spin_scatter", k.sideSpinScatter());
    ArrayNode robots = node.putArray("robots");
    for (Bias bias : k.biases()) {
      ObjectNode robot = robots.addObject();
      robot.put("team", bias.team().label());
      bias.number().ifPresentOrElse(n -> robot.put("robot", n), () -> robot.putNull("robot"));
      robot.put("gain", 1 + bias.speed());
      robot.put("yaw", bias.yaw());
    }
  }

  private static void robots(RobotLimits l, ObjectNode node) {
    node.put("velocity", l.velocity());
    node.put("acceleration", l.acceleration());
    node.put("braking", l.braking());
    node.put("angular_velocity", l.angularVelocity());
    node.put("angular_acceleration", l.angularAcceleration());
    node.put("torque_limited", l.torqueLoss());
    node.put("directional", l.directionality());
  }

  private static void published(BallModels models, ObjectNode node) {
    if (models.flat().isPresent()) {
      FlatModel f = models.flat().get();
      node.putObject("flat")
          .put("acc_slide", f.accSlide())
          .put("acc_roll", f.accRoll())
          .put("k_switch", f.kSwitch());
    } else {
      node.putNull("flat");
    }
    if (models.chip().isPresent()) {
      ChipModel c = models.chip().get();
      node.putObject("chip")
          .put("damping_xy_first_hop", c.dampingXyFirstHop())
          .put("damping_xy_other_hops", c.dampingXyOtherHops())
          .put("damping_z", c.dampingZ())
          .put("acc_roll", c.accRoll());
    } else {
      node.putNull("chip");
    }
  }

  /**
   * Reads.
   *
   * @param file from where
   * @return the twin, with the scenario and seed of {@link SimulationSettings#DEFAULT}
   * @throws InputException when there is no such file or it is no twin, with file and field
   * @throws IOException when it cannot be read
   */
  public static Twin read(Path file) throws IOException {
    Fields root = Fields.of(file, JsonFiles.read(file));
    String schema = root.text("schema");
    if (!schema.equals(SCHEMA)) {
      throw root.wrong("schema", "must be " + SCHEMA + ", but is " + schema);
    }
    List<String> sources = root.texts("sources");
    List<String> notes = root.texts("notes");
    FieldSize field = field(root.object("field"));
    LearnedDocument learned = LearnedDocument.read(root.objects("learned"));
    BallPhysics physics = ball(root.object("ball"));
    for (TabulatedLaw law : learned.laws()) {
      physics = physics.withExtra(law);
    }
    List<EffectSetting> effects = new ArrayList<>();
    for (Fields cause : root.objects("causes")) {
      effects.add(cause(cause));
    }
    KickBehaviour kickers = kickers(root.object("kickers")).withSpinTables(learned.spins());
    List<InstalledCamera> cameras = new ArrayList<>();
    for (Fields camera : root.objects("cameras")) {
      cameras.add(camera(camera, learned));
    }
    if (cameras.isEmpty()) {
      throw root.wrong("cameras", "must not be empty");
    }
    SimulationSettings base = SimulationSettings.DEFAULT;
    CameraSettings vision = vision(root.object("vision"), base.cameras());
    Fields robots = root.object("robots");
    RobotLimits yellow = limits(robots.object("yellow"));
    RobotLimits blue = limits(robots.object("blue"));
    robots.close();
    BallModels models = published(root.object("published"));
    BallPhysics whole = physics;
    SimulationSettings settings =
        root.made(
            () ->
                base.withScenario(base.scenario().withLimits(yellow, blue))
                    .withField(field)
                    .withKickBehaviour(kickers)
                    .withCameras(vision)
                    .withNuisance(Nuisance.NONE)
                    .withPublishedModels(models)
                    .withInstalled(cameras)
                    .withEffects(effects)
                    .withPhysics(whole));
    return new Twin(sources, settings, notes);
  }

  private static FieldSize field(Fields f) throws InputException {
    return f.made(
        () ->
            new FieldSize(
                f.number("length"),
                f.number("width"),
                f.number("boundary"),
                f.number("goal_width"),
                f.number("goal_depth")));
  }

  private static BallPhysics ball(Fields f) throws InputException {
    return f.made(
        () ->
            BallPhysics.ideal(
                f.number("acc_slide"),
                f.number("acc_roll"),
                f.number("k_switch"),
                f.number("damping_xy_first_hop"),
                f.number("damping_xy_other_hops"),
                f.number("damping_z")));
  }

  private static EffectSetting cause(Fields f) throws InputException {
    return f.made(
        () -> {
          SimulatedEffect effect = SimulatedEffect.of(f.text("effect"));
          Fields parameters = f.object("parameters");
          Map<String, String> values = new LinkedHashMap<>();
          for (String name : parameters.names()) {
            values.put(name, parameters.written(name));
          }
          return new EffectSetting(effect, values);
        });
  }

  private static CameraSettings vision(Fields f, CameraSettings base) throws InputException {
    return f.made(
        () ->
            base.withRegistration(f.number("ball_plane"), 0)
                .withExposure(choice(f, "exposure", Exposure.class)));
  }

  private static <E extends Enum<E>> E choice(Fields f, String name, Class<E> type)
      throws InputException {
    String text = f.text(name);
    for (E value : type.getEnumConstants()) {
      if (label(value).equals(text)) {
        return value;
      }
    }
    List<String> known = new ArrayList<>();
    for (E value : type.getEnumConstants()) {
      known.add(label(value));
    }
    throw f.wrong(name, "must be one of " + known + ", but is " + text);
  }

  private static InstalledCamera camera(Fields f, LearnedDocument learned) throws InputException {
    int id = f.whole("id");
    CameraCalibration vision = calibration(id, f.object("vision"));
    CameraCalibration announced =
        f.has("announced") ? calibration(id, f.object("announced")) : vision;
    Region view = Region.NONE;
    if (f.has("view")) {
      double[] v = four(f, "view", 4);
      try {
        view = new Region(v[0], v[1], v[2], v[3]);
      } catch (IllegalArgumentException e) {
        throw f.wrong("view", e.getMessage());
      }
    }
    Region area = view;
    CameraErrors errors = learned.errors(id);
    return f.made(
        () ->
            new InstalledCamera(
                vision,
                announced,
                f.flag("reports_pixels"),
                area,
                f.number("ball_noise"),
                choice(f, "noise_growth", NoiseGrowth.class),
                f.number("robot_noise"),
                f.number("robot_angle_noise"),
                f.number("rate"),
                f.number("phase"),
                f.number("latency"),
                f.number("latency_spread"),
                nuisance(f),
                errors));
  }

  private static Nuisance nuisance(Fields f) throws InputException {
    return new Nuisance(
        f.number("false_balls"),
        f.number("false_ball_series"),
        f.number("missed_balls"),
        f.number("missed_robots"),
        f.number("lost_frames"),
        f.number("interruptions_per_second"),
        f.number("jitter"),
        f.number("stamp_noise"),
        f.number("duplicates"),
        f.flag("robots_hide_balls"),
        List.of());
  }

  private static double[] four(Fields f, String name, int count) throws InputException {
    double[] values = f.numbers(name);
    if (values.length != count) {
      throw f.wrong(name, "must be " + count + " numbers, but are " + values.length);
    }
    return values;
  }

  private static CameraCalibration calibration(int id, Fields f) throws InputException {
    return f.made(
        () -> {
          double[] p = four(f, "principal_point", 2);
          double[] q = four(f, "rotation", 4);
          double[] t = four(f, "translation", 3);
          double[] position =
              f.has("position")
                  ? four(f, "position", 3)
                  : new double[] {Double.NaN, Double.NaN, Double.NaN};
          double[] image = four(f, "image", 2);
          return new CameraCalibration(
              id,
              f.number("focal_length"),
              p[0],
              p[1],
              f.number("distortion"),
              q[0],
              q[1],
              q[2],
              q[3],
              t[0],
              t[1],
              t[2],
              position[0],
              position[1],
              position[2],
              (int) image[0],
              (int) image[1]);
        });
  }

  private static KickBehaviour kickers(Fields f) throws InputException {
    List<Bias> biases = new ArrayList<>();
    for (Fields robot : f.objects("robots")) {
      biases.add(
          robot.made(
              () ->
                  new Bias(
                      robot.number("gain") - 1,
                      robot.number("yaw"),
                      choice(robot, "team", Team.class),
                      robot.has("robot") ? Optional.of(robot.whole("robot")) : Optional.empty())));
    }
    return f.made(
        () ->
            new KickBehaviour(
                f.number("speed_scatter"),
                f.number("direction_scatter"),
                f.number("elevation_scatter"),
                f.number("roll_spin"),
                f.number("roll_spin_scatter"),
                f.has("chip_spin") ? f.number("chip_spin") : 0,
                f.number("side_spin"),
                f.number("side_spin_scatter"),
                biases,
                List.of()));
  }

  private static RobotLimits limits(Fields f) throws InputException {
    return f.made(
        () ->
            new RobotLimits(
                f.number("velocity"),
                f.number("acceleration"),
                f.number("braking"),
                f.number("angular_velocity"),
                f.number("angular_acceleration"),
                f.number("torque_limited"),
                f.number("directional")));
  }

  private static BallModels published(Fields f) throws InputException {
    Optional<FlatModel> flat = Optional.empty();
    Optional<ChipModel> chip = Optional.empty();
    if (f.has("flat")) {
      Fields m = f.object("flat");
      flat =
          Optional.of(
              m.made(
                  () ->
                      new FlatModel(
                          m.number("acc_slide"), m.number("acc_roll"), m.number("k_switch"))));
    }
    if (f.has("chip")) {
      Fields m = f.object("chip");
      chip =
          Optional.of(
              m.made(
                  () ->
                      new ChipModel(
                          m.number("damping_xy_first_hop"),
                          m.number("damping_xy_other_hops"),
                          m.number("damping_z"),
                          m.number("acc_roll"))));
    }
    f.close();
    return new BallModels(flat, chip);
  }
}
