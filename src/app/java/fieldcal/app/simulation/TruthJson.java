package fieldcal.app.simulation;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import fieldcal.camera.CameraCalibration;
import fieldcal.simulation.EffectParameter;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.KickBehaviour;
import fieldcal.simulation.SimulationSettings;
import fieldcal.simulation.imaging.CameraErrors;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.imaging.InstalledCamera;
import fieldcal.simulation.imaging.Nuisance;
import fieldcal.simulation.physics.AirLaw;
import fieldcal.simulation.physics.BallEvent;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.GroundLaw;
import fieldcal.simulation.physics.ImpactLaw;
import fieldcal.simulation.physics.Seam;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.simulation.truth.BallHold;
import fieldcal.simulation.truth.CameraTruth;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.simulation.truth.KickTruth.Vector3;
import fieldcal.simulation.truth.RefereePhase;
import fieldcal.simulation.truth.RobotTruth;
import fieldcal.simulation.truth.Truth;
import fieldcal.vision.RobotId;
import java.util.List;
import java.util.Locale;

/**
 * The truth as JSON. Positions are millimetres where the name says so, else SI; z is the height of the ball's centre. Field names follow those of the recordings that come with the project, so
 * that one script reads both.
 */
public final class TruthJson {
  private static final JsonNodeFactory JSON = JsonNodeFactory.instance;

  private TruthJson() {}

  /**
   * Turns a truth into JSON.
   *
   * @param truth of a recording
   * @return the root object
   */
  public static ObjectNode of(Truth truth) {
    SimulationSettings settings = truth.settings();
    ObjectNode root = JSON.objectNode();
    root.put("format", "fieldcal.truth/1");
    root.put("scenario", settings.scenario().kind().label());
    root.put("seed", settings.seed());
    root.put("null", settings.effects().isEmpty());
    ObjectNode effects = root.putObject("effects");
    settings.effects().forEach(effect -> add(effects, effect));
    root.put(
        "units",
        "positions mm where the name says so, else SI; z is the height of the ball centre");
    root.put("unix_base", truth.epoch().unixSeconds(0));
    root.put("duration", rounded(truth.duration(), 6));
    ObjectNode field = root.putObject("field");
    field.put("length_mm", 1000 * settings.field().length());
    field.put("width_mm", 1000 * settings.field().width());
    root.set("ball", ball(truth.physics()));
    root.set("ideal_model", idealModel(truth));
    root.set("kicker", kicker(truth.kickBehaviour()));
    root.set("vision", vision(truth));
    if (settings.installed().isEmpty()) {
      root.set("nuisance", nuisance(settings.nuisance()));
    } else {
      ArrayNode each = root.putArray("nuisance");
      settings.installed().forEach(c -> each.add(nuisance(c.nuisance())));
    }
    root.set("cameras", cameras(truth));
    ArrayNode robots = root.putArray("robots");
    truth.robots().forEach(robot -> robots.add(robot(robot)));
    ArrayNode phases = root.putArray("phases");
    truth.phases().forEach(phase -> phases.add(phase(phase)));
    ArrayNode holds = root.putObject("info").putArray("ball_carried");
    for (BallHold hold : truth.holds()) {
      ObjectNode node = robotId(hold.robot());
      node.put("t0", rounded(hold.from(), 4));
      node.put("t1", rounded(hold.to(), 4));
      holds.add(node);
    }
    ArrayNode kicks = root.putArray("kicks");
    truth.kicks().forEach(kick -> kicks.add(kick(kick, truth)));
    return root;
  }

  /** An effect that is set several times, of several cameras for example, becomes an array. */
  private static void add(ObjectNode effects, EffectSetting setting) {
    String id = setting.effect().id();
    ObjectNode node = effect(setting);
    if (!effects.has(id)) {
      effects.set(id, node);
    } else if (effects.get(id) instanceof ArrayNode several) {
      several.add(node);
    } else {
      effects.set(id, JSON.arrayNode().add(effects.get(id)).add(node));
    }
  }

  private static ObjectNode effect(EffectSetting setting) {
    ObjectNode node = JSON.objectNode();
    setting
        .values()
        .forEach(
            (name, value) -> {
              boolean number =
                  setting.effect().parameter(name).map(EffectParameter::kind).orElseThrow()
                      == EffectParameter.Kind.NUMBER;
              if (number) {
                node.put(name, Double.parseDouble(value));
              } else if (value.matches("\\d+")) {
                node.put(name, Integer.parseInt(value));
              } else {
                node.put(name, value);
              }
            });
    return node;
  }

  private static ObjectNode ball(BallPhysics physics) {
    ObjectNode node = JSON.objectNode();
    node.put("g", BallPhysics.GRAVITY);
    node.put("mass", physics.ball().mass());
    node.put("radius", physics.ball().radius());
    node.put("beta", physics.ball().inertiaFactor());
    GroundLaw ground = physics.ground();
    node.put("mu_k", ground.slidingFriction());
    node.put("a_roll", ground.rollingDeceleration());
    node.put("a_roll1", ground.rollingPerSpeed());
    node.put("a_roll2", ground.rollingPerSpeedSquared());
    node.put("slope_x", ground.slopeX());
    node.put("slope_y", ground.slopeY());
    node.put("nap_roll", ground.napAmplitude());
    node.put("nap_dir", ground.napDirection());
    node.put("worn_change", ground.wornChange());
    node.putArray("worn_region")
        .add(ground.worn().x0())
        .add(ground.worn().x1())
        .add(ground.worn().y0())
        .add(ground.worn().y1());
    node.put("roll_scale_rate", ground.driftPerSecond());
    node.put("slip_slope", ground.slipSlope());
    node.put("wave_amplitude", ground.waveAmplitude());
    node.put("wave_length", ground.waveLength());
    ImpactLaw impact = physics.impact();
    node.put("e_z", impact.dampingZFirstHop());
    node.put("e_z_other", impact.dampingZOtherHops());
    node.put("e_z_speed", impact.speedSlope());
    node.put("spin_coupling", impact.spinCoupling());
    node.put("min_hop", impact.minHopHeight());
    if (impact.tangential() instanceof ImpactLaw.FixedLoss loss) {
      node.put("bounce_model", "fixed_loss");
      node.put("e_xy1", loss.firstHop());
      node.put("e_xy", loss.otherHops());
    } else if (impact.tangential() instanceof ImpactLaw.Contact contact) {
      node.put("bounce_model", "contact");
      node.put("e_t", contact.restitution());
      node.put("mu_impact", contact.friction());
      node.put("impact_loss", contact.loss());
    }
    AirLaw air = physics.air();
    node.put("drag_cd", air.dragCoefficient());
    node.put("magnus_cl", air.liftCoefficient());
    node.put("air_density", air.density());
    node.put("spin_decay", air.spinDecay());
    node.put("wind_x", air.windX());
    node.put("wind_y", air.windY());
    ArrayNode seams = node.putArray("seams");
    for (Seam seam : physics.seams()) {
      ObjectNode s = seams.addObject();
      s.put("loss", seam.loss());
      s.put("turn", seam.turn());
      s.put("normal", seam.normal());
      s.put("distance", seam.distance());
    }
    ArrayNode extras = node.putArray("extras");
    physics.extras().forEach(extra -> extras.add(extra.toString()));
    return node;
  }

  /** The league's parameters that come closest to the physics, and whether they are all there is. */
  private static ObjectNode idealModel(Truth truth) {
    BallPhysics p = truth.physics();
    GroundLaw g = p.ground();
    KickBehaviour k = truth.kickBehaviour();
    boolean noAir = p.air().dragCoefficient() == 0 && p.air().liftCoefficient() == 0;
    boolean plainGround =
        g.equals(
            new GroundLaw(
                g.slidingFriction(),
                g.rollingDeceleration(),
                0,
                0,
                0,
                0,
                0,
                g.napDirection(),
                g.worn(),
                0,
                0,
                g.verticalSpinDecay(),
                0,
                0,
                g.waveLength()));
    boolean noSpin =
        k.rollSpin() == 0
            && k.rollSpinScatter() == 0
            && k.chipSpin() == 0
            && k.sideSpin() == 0
            && k.sideSpinScatter() == 0;
    boolean fixedLoss =
        p.impact().tangential() instanceof ImpactLaw.FixedLoss
            && p.impact().speedSlope() == 0
            && p.impact().spinCoupling() == 0
            && p.impact().dampingZFirstHop() == p.impact().dampingZOtherHops();
    boolean nothingElse = p.extras().isEmpty() && p.seams().isEmpty();
    ObjectNode node = JSON.objectNode();
    node.put("acc_slide", -g.slidingFriction() * BallPhysics.GRAVITY);
    node.put("acc_roll", -g.rollingDeceleration());
    node.put("k_switch", p.ball().kSwitch());
    if (p.impact().tangential() instanceof ImpactLaw.FixedLoss loss) {
      node.put("damping_xy_first_hop", loss.firstHop());
      node.put("damping_xy_other_hops", loss.otherHops());
    } else {
      node.putNull("damping_xy_first_hop");
      node.putNull("damping_xy_other_hops");
    }
    node.put("damping_z", p.impact().dampingZFirstHop());
    node.put("exact_flat", noAir && plainGround && noSpin && nothingElse);
    node.put("exact_chip", noAir && plainGround && fixedLoss && noSpin && nothingElse);
    return node;
  }

  private static ObjectNode kicker(KickBehaviour k) {
    ObjectNode node = JSON.objectNode();
    node.put("speed_scatter", k.speedScatter());
    node.put("direction_scatter", k.directionScatter());
    node.put("elevation_scatter", k.elevationScatter());
    node.put("roll_spin", k.rollSpin());
    node.put("roll_spin_scatter", k.rollSpinScatter());
    node.put("chip_spin", k.chipSpin());
    node.put("side_spin", k.sideSpin());
    node.put("side_spin_scatter", k.sideSpinScatter());
    return node;
  }

  private static ObjectNode vision(Truth truth) {
    CameraSettings cameras = truth.settings().cameras();
    ObjectNode node = JSON.objectNode();
    List<InstalledCamera> installed = truth.settings().installed();
    if (installed.isEmpty()) {
      node.put("ball_noise_mm_at_nadir", 1000 * cameras.ballNoise());
      node.put("robot_sigma_mm", 1000 * cameras.robotNoise());
      node.put("robot_sigma_rad", cameras.robotAngleNoise());
    } else {
      ArrayNode noises = node.putArray("ball_noise_mm_at_nadir");
      installed.forEach(c -> noises.add(1000 * c.ballNoise()));
      ArrayNode robots = node.putArray("robot_sigma_mm");
      installed.forEach(c -> robots.add(1000 * c.robotNoise()));
      ArrayNode angles = node.putArray("robot_sigma_rad");
      installed.forEach(c -> angles.add(c.robotAngleNoise()));
    }
    node.put("assumed_ball_height_mm", rounded(1000 * truth.ballPlane(), 6));
    node.put("disagreement_mm", 1000 * cameras.disagreement());
    node.put("rolling_shutter_ms", 1000 * truth.rollingShutter());
    ArrayNode rates = node.putArray("frame_rates");
    ArrayNode frames = node.putArray("frames");
    for (CameraTruth camera : truth.cameras()) {
      rates.add(rounded(camera.rate(), 3));
      frames.add(camera.frames());
    }
    return node;
  }

  private static ObjectNode nuisance(Nuisance n) {
    ObjectNode node = JSON.objectNode();
    node.put("false_ball_rate", n.falseBallRate());
    node.put("false_cluster_rate", n.falseClusterRate());
    node.put("ball_miss", n.ballMiss());
    node.put("robot_miss", n.robotMiss());
    node.put("frame_drop", n.frameDrop());
    node.put("frame_burst_rate", n.burstRate());
    node.put("frame_jitter_ms", 1000 * n.jitter());
    node.put("stamp_noise_ms", 1000 * n.stampNoise());
    node.put("duplicates", n.duplicates());
    node.put("shadows", n.shadows());
    return node;
  }

  private static ObjectNode cameras(Truth truth) {
    ObjectNode node = JSON.objectNode();
    ArrayNode actual = node.putArray("true");
    ArrayNode published = node.putArray("published");
    ArrayNode errors = node.putArray("errors");
    for (CameraTruth camera : truth.cameras()) {
      actual.add(calibration(camera.trueCalibration()));
      published.add(calibration(camera.publishedCalibration()));
      errors.add(errors(camera));
    }
    return node;
  }

  private static ObjectNode calibration(CameraCalibration c) {
    ObjectNode node = JSON.objectNode();
    node.put("id", c.id());
    node.put("focal_length", c.focalLength());
    node.putArray("principal_point").add(c.principalPointX()).add(c.principalPointY());
    node.put("distortion", c.distortion());
    node.putArray("q").add(c.q0()).add(c.q1()).add(c.q2()).add(c.q3());
    node.putArray("t").add(1000 * c.tx()).add(1000 * c.ty()).add(1000 * c.tz());
    node.putArray("position")
        .add(1000 * c.derivedWorldX())
        .add(1000 * c.derivedWorldY())
        .add(1000 * c.derivedWorldZ());
    node.putArray("image").add(c.imageWidth()).add(c.imageHeight());
    return node;
  }

  private static ObjectNode errors(CameraTruth camera) {
    CameraErrors e = camera.errors();
    ObjectNode node = JSON.objectNode();
    node.put("id", camera.trueCalibration().id());
    node.put("tilt_mrad", 1000 * e.tilt());
    node.put("tilt_axis", e.tiltAxis());
    node.put("height_mm", 1000 * e.heightError());
    node.put("shift_x_mm", 1000 * e.shiftX());
    node.put("shift_y_mm", 1000 * e.shiftY());
    node.put("distortion", e.distortionError());
    node.put("offset_x_mm", 1000 * e.offsetX());
    node.put("offset_y_mm", 1000 * e.offsetY());
    node.put("time_offset_ms", 1000 * e.timeOffset());
    node.put("clock_skew_ppm", 1e6 * e.clockSkew());
    node.put("shake_mm", 1000 * e.shakeAmplitude());
    node.put("shake_hz", e.shakeRate());
    node.put("shear_mm", 1000 * e.shear());
    ArrayNode knocks = node.putArray("knocks");
    for (CameraErrors.Knock knock : e.knocks()) {
      ObjectNode k = knocks.addObject();
      k.put("x_mm", 1000 * knock.x());
      k.put("y_mm", 1000 * knock.y());
      k.put("at", knock.at());
    }
    return node;
  }

  private static ObjectNode robot(RobotTruth robot) {
    ObjectNode node = robotId(robot.id());
    node.put("height_mm", rounded(1000 * robot.height(), 1));
    RobotLimits limits = robot.limits();
    ObjectNode l = node.putObject("limits");
    l.put("v_max", limits.velocity());
    l.put("acc", limits.acceleration());
    l.put("brake", limits.braking());
    l.put("w_max", limits.angularVelocity());
    l.put("w_acc", limits.angularAcceleration());
    l.put("torque_c", limits.torqueLoss());
    l.put("directional_d", limits.directionality());
    return node;
  }

  private static ObjectNode robotId(RobotId id) {
    ObjectNode node = JSON.objectNode();
    node.put("team", id.team().label());
    node.put("id", id.number());
    return node;
  }

  private static ObjectNode phase(RefereePhase phase) {
    ObjectNode node = JSON.objectNode();
    node.put("t", rounded(phase.time(), 6));
    node.put("command", phase.command());
    node.put("stage", phase.stage());
    node.putArray("score").add(phase.yellowScore()).add(phase.blueScore());
    return node;
  }

  private static ObjectNode kick(KickTruth kick, Truth truth) {
    double radius = truth.physics().ball().radius();
    Vector3 v = kick.velocity();
    ObjectNode node = JSON.objectNode();
    node.put("index", kick.index());
    node.put("kind", kick.kind().label());
    node.put("purpose", kick.purpose());
    node.put("t0_unix", truth.epoch().unixSeconds(kick.time()));
    node.put("t0", rounded(kick.time(), 6));
    node.put("duration", rounded(kick.duration(), 6));
    node.put("end_reason", kick.end().label());
    node.set("pos_mm", millimetres(kick.position(), radius));
    node.set("vel", vector(v, 6));
    node.put("speed", rounded(v.norm(), 6));
    node.put("direction_deg", rounded(Math.toDegrees(v.direction()), 5));
    node.put("elevation_deg", rounded(Math.toDegrees(Math.atan2(v.z(), v.horizontal())), 5));
    node.set("spin", vector(kick.spin(), 4));
    node.put("spin_fraction", rounded(kick.rollFraction(radius), 6));
    node.put("side_spin_fraction", rounded(kick.sideFraction(radius), 6));
    node.set("robot", robotId(kick.robot()));
    node.set("robot_pose", vector(kick.robotPose(), 5));
    ObjectNode commanded = node.putObject("commanded");
    commanded.put("speed", rounded(kick.command().speed(), 6));
    commanded.put("direction_deg", rounded(Math.toDegrees(kick.command().direction()), 5));
    commanded.put("elevation_deg", rounded(Math.toDegrees(kick.command().elevation()), 5));
    ArrayNode events = node.putArray("events");
    kick.events().forEach(event -> events.add(event(event, kick.time(), radius)));
    ObjectNode path = node.putObject("trajectory");
    path.put("dt", kick.pathStep());
    ArrayNode x = path.putArray("x_mm");
    ArrayNode y = path.putArray("y_mm");
    ArrayNode z = path.putArray("z_mm");
    for (Vector3 point : kick.path()) {
      x.add(rounded(1000 * point.x(), 3));
      y.add(rounded(1000 * point.y(), 3));
      z.add(rounded(1000 * (point.z() + radius), 3));
    }
    kick.endRobot().ifPresent(robot -> node.set("end_robot", robotId(robot)));
    return node;
  }

  private static ObjectNode event(BallEvent event, double kickTime, double radius) {
    ObjectNode node = JSON.objectNode();
    node.put("kind", event.kind().name().toLowerCase(Locale.ROOT));
    node.put("t", rounded(event.time() - kickTime, 6));
    node.set("pos_mm", millimetres(new Vector3(event.x(), event.y(), 0), radius));
    node.set(
        "vel_before", vector(new Vector3(event.vxBefore(), event.vyBefore(), event.vzBefore()), 6));
    node.set(
        "vel_after", vector(new Vector3(event.vxAfter(), event.vyAfter(), event.vzAfter()), 6));
    return node;
  }

  private static ArrayNode millimetres(Vector3 v, double radius) {
    return vector(new Vector3(1000 * v.x(), 1000 * v.y(), 1000 * (v.z() + radius)), 3);
  }

  private static ArrayNode vector(Vector3 v, int digits) {
    return JSON.arrayNode()
        .add(rounded(v.x(), digits))
        .add(rounded(v.y(), digits))
        .add(rounded(v.z(), digits));
  }

  private static double rounded(double value, int digits) {
    double scale = Math.pow(10, digits);
    return Math.round(value * scale) / scale;
  }
}
