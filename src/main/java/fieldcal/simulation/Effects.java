package fieldcal.simulation;

import fieldcal.simulation.KickBehaviour.Bias;
import fieldcal.simulation.imaging.CameraErrors;
import fieldcal.simulation.imaging.CameraSettings;
import fieldcal.simulation.physics.AirLaw;
import fieldcal.simulation.physics.BallChange;
import fieldcal.simulation.physics.BallPhysics;
import fieldcal.simulation.physics.ExtraLaw;
import fieldcal.simulation.physics.GroundLaw;
import fieldcal.simulation.physics.ImpactLaw.Contact;
import fieldcal.simulation.physics.Seam;
import fieldcal.simulation.physics.UnnamedCause.FadingFriction;
import fieldcal.simulation.physics.UnnamedCause.FourWays;
import fieldcal.simulation.physics.UnnamedCause.LossByImpactSpeed;
import fieldcal.simulation.physics.UnnamedCause.OncePerTurn;
import fieldcal.simulation.physics.UnnamedCause.Patches;
import fieldcal.simulation.physics.UnnamedCause.RestitutionByPlace;
import fieldcal.simulation.physics.UnnamedCause.Ring;
import fieldcal.simulation.physics.UnnamedCause.RollBump;
import fieldcal.simulation.physics.UnnamedCause.SideForce;
import fieldcal.simulation.robot.RobotLimits;
import fieldcal.vision.Team;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** Puts effects into a simulation's settings. Each sets its quantity or adds to it; zero changes nothing. */
final class Effects {
  private static final double MILLI = 1e-3;

  private Effects() {}

  static BallPhysics physics(BallPhysics base, List<EffectSetting> effects) {
    BallPhysics p = base;
    for (EffectSetting e : effects) {
      p =
          switch (e.effect()) {
            case AIR_DRAG ->
                p.withAir(p.air().withDrag(p.air().dragCoefficient() + e.number("cd")));
            case MAGNUS -> p.withAir(p.air().withLift(p.air().liftCoefficient() + e.number("cl")));
            case SPEED_DEPENDENT_RESTITUTION ->
                p.withImpact(p.impact().withSpeedSlope(e.number("slope")));
            case BOUNCE_SPIN_COUPLING ->
                p.withImpact(p.impact().withSpinCoupling(e.number("coefficient")));
            case CONTACT_IMPACTS ->
                e.number("friction") == 0
                    ? p
                    : p.withImpact(
                        p.impact()
                            .withTangential(
                                new Contact(
                                    e.number("reversed"),
                                    e.number("friction"),
                                    e.number("loss"),
                                    e.number("loss"),
                                    e.number("rolling")))
                            .withMinHopHeight(
                                e.number("lowest_hop_mm", 1000 * p.impact().minHopHeight())
                                    / 1000));
            case WIND -> p.withAir(wind(p.air(), e));
            case BALL_CHANGED ->
                e.number("roll") == 0 && e.number("slide") == 0
                    ? p
                    : p.withExtra(
                        new BallChange(e.number("roll"), e.number("slide"), e.number("at")));
            case CARPET_SEAM ->
                e.number("loss") == 0 && e.number("turn") == 0
                    ? p
                    : p.withSeam(
                        new Seam(
                            e.number("loss"),
                            e.number("turn"),
                            e.number("normal"),
                            e.number("distance")));
            default ->
                unnamed(e, p.ball().radius())
                    .map(p::withExtra)
                    .orElse(p.withGround(ground(p.ground(), e)));
          };
    }
    return p;
  }

  private static AirLaw wind(AirLaw air, EffectSetting e) {
    double speed = e.number("speed");
    double direction = e.number("direction");
    return air.withWind(
        air.windX() + speed * Math.cos(direction), air.windY() + speed * Math.sin(direction));
  }

  /** The law of a cause that has no name; empty for other effects and at zero. */
  private static Optional<ExtraLaw> unnamed(EffectSetting e, double radius) {
    double size = e.number(e.effect().parameters().get(0).name());
    if (size == 0) {
      return Optional.empty();
    }
    return Optional.ofNullable(
        switch (e.effect()) {
          case UNNAMED_RESTITUTION_PLACE -> new RestitutionByPlace(size, e.number("direction"));
          case UNNAMED_ROLL_BUMP ->
              new RollBump(size, e.number("speed", 1.5), e.number("width", 0.4));
          case UNNAMED_FADING_FRICTION -> new FadingFriction(size, e.number("duration", 0.3));
          case UNNAMED_RING -> new Ring(size, e.number("inner", 1.5), e.number("outer", 2.5));
          case UNNAMED_ONCE_PER_TURN -> new OncePerTurn(size, radius);
          case UNNAMED_FOUR_WAYS -> new FourWays(size, e.number("direction"));
          case UNNAMED_IMPACT_SPEED -> new LossByImpactSpeed(size);
          case UNNAMED_SIDE_FORCE -> new SideForce(size);
          case UNNAMED_PATCHES -> new Patches(size, e.number("pitch", 0.8));
          default -> null;
        });
  }

  private static GroundLaw ground(GroundLaw g, EffectSetting e) {
    return switch (e.effect()) {
      case FIELD_SLOPE -> g.withSlope(e.number("percent"), e.number("direction"));
      case CARPET_NAP -> g.withNap(e.number("amplitude"), e.number("direction"));
      case SPEED_DEPENDENT_ROLL ->
          g.withSpeedDependentRoll(
              g.rollingPerSpeed() + e.number("slope"), g.rollingPerSpeedSquared());
      case UNNAMED_ROLL_SQUARE ->
          g.withSpeedDependentRoll(
              g.rollingPerSpeed(), g.rollingPerSpeedSquared() + e.number("slope"));
      case WORN_REGION -> g.withWornRegion(e.number("change"), e.region());
      case DRIFT -> g.withDrift(e.number("percent_per_10min") / 100 / 600);
      case SLIP_DEPENDENT_FRICTION -> g.withSlipSlope(e.number("slope"));
      case CARPET_WAVES -> g.withWaves(e.number("amplitude"), e.number("wavelength", 2));
      default -> g;
    };
  }

  static KickBehaviour kicks(KickBehaviour base, List<EffectSetting> effects) {
    KickBehaviour k = base;
    for (EffectSetting e : effects) {
      k =
          switch (e.effect()) {
            case KICK_SPIN ->
                k.withRollSpin(
                        k.rollSpin() + e.number("fraction"),
                        Math.hypot(k.rollSpinScatter(), e.number("scatter")))
                    .withChipSpin(k.chipSpin() + e.number("chips"));
            case SIDE_SPIN ->
                k.withSideSpin(
                    k.sideSpin() + e.number("fraction"),
                    Math.hypot(k.sideSpinScatter(), e.number("scatter")));
            case ROBOT_KICK_BIAS -> k.withBiases(biases(k.biases(), e));
            default -> k;
          };
    }
    return k;
  }

  private static List<Bias> biases(List<Bias> base, EffectSetting e) {
    List<Bias> biases = new ArrayList<>(base);
    OptionalInt robot = e.robot();
    Optional<Integer> number = robot.isPresent() ? Optional.of(robot.getAsInt()) : Optional.empty();
    for (Team team : Team.values()) {
      if (e.concernsTeam(team)) {
        biases.add(new Bias(e.number("percent") / 100, e.number("yaw"), team, number));
      }
    }
    return biases;
  }

  static CameraSettings cameras(CameraSettings base, List<EffectSetting> effects) {
    CameraSettings c = base;
    for (EffectSetting e : effects) {
      if (e.effect() == SimulatedEffect.BALL_HEIGHT_ERROR) {
        c = c.withRegistration(c.ballPlane() + MILLI * e.number("mm"), c.disagreement());
      }
    }
    return c;
  }

  static double rollingShutter(double base, List<EffectSetting> effects) {
    return base
        + effects.stream()
            .filter(e -> e.effect() == SimulatedEffect.ROLLING_SHUTTER)
            .mapToDouble(e -> MILLI * e.number("ms"))
            .sum();
  }

  static List<CameraErrors> cameraErrors(List<Integer> cameras, List<EffectSetting> effects) {
    List<CameraErrors> errors =
        new ArrayList<>(Collections.nCopies(cameras.size(), CameraErrors.NONE));
    for (EffectSetting e : effects) {
      for (int i = 0; i < cameras.size(); i++) {
        errors.set(i, errors.get(i).plus(errorsOf(e, cameras.get(i), cameras.size())));
      }
    }
    return errors;
  }

  private static CameraErrors errorsOf(EffectSetting e, int id, int cameras) {
    CameraErrors none = CameraErrors.NONE;
    boolean concerned = e.concernsCamera(id);
    if (e.effect() == SimulatedEffect.CAMERA_OFFSET) {
      // The parameters are relative to the mean of all cameras, so the others are shifted the
      // other way.
      double share = MILLI * (concerned || cameras == 1 ? 1 : -1.0 / (cameras - 1));
      return none.withOffset(share * e.number("x_mm"), share * e.number("y_mm"));
    }
    if (!concerned) {
      return none;
    }
    return switch (e.effect()) {
      case CAMERA_TIME_OFFSET -> none.withTiming(MILLI * e.number("ms"), 0);
      case CAMERA_POSE_ERROR ->
          none.withTilt(MILLI * e.number("tilt_mrad"), e.number("axis"))
              .withShift(
                  MILLI * e.number("shift_x_mm"),
                  MILLI * e.number("shift_y_mm"),
                  MILLI * e.number("height_mm"));
      case CAMERA_POSITION_ERROR ->
          none.withMisstated(
              MILLI * e.number("x_mm"), MILLI * e.number("y_mm"), MILLI * e.number("height_mm"));
      case LENS_DISTORTION_ERROR -> none.withDistortion(e.number("delta"));
      case CLOCK_SKEW -> none.withTiming(0, 1e-6 * e.number("ppm"));
      case CAMERA_SHAKE -> none.withShake(MILLI * e.number("amplitude_mm"), e.number("hz", 1));
      case CAMERA_MOVED ->
          none.withKnock(MILLI * e.number("x_mm"), MILLI * e.number("y_mm"), e.number("at"));
      case UNNAMED_LENS_SHEAR -> none.withShear(MILLI * e.number("mm"));
      default -> none;
    };
  }

  static RobotLimits limits(RobotLimits base, Team team, List<EffectSetting> effects) {
    RobotLimits limits = base;
    for (EffectSetting e : effects) {
      if (e.effect() == SimulatedEffect.TORQUE_LIMITED && e.concernsTeam(team)) {
        limits = limits.withTorqueLoss(e.number("coefficient"));
      } else if (e.effect() == SimulatedEffect.DIRECTIONAL && e.concernsTeam(team)) {
        limits = limits.withDirectionality(e.number("coefficient"));
      }
    }
    return limits;
  }
}
