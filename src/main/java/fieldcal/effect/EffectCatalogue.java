package fieldcal.effect;

import fieldcal.effect.measurement.BallHeightError;
import fieldcal.effect.measurement.CameraMoved;
import fieldcal.effect.measurement.CameraOffset;
import fieldcal.effect.measurement.CameraPoseError;
import fieldcal.effect.measurement.CameraPositionError;
import fieldcal.effect.measurement.CameraTimeOffset;
import fieldcal.effect.measurement.ClockSkew;
import fieldcal.effect.measurement.LensDistortionError;
import fieldcal.effect.measurement.RollingShutter;
import fieldcal.effect.motion.AirDrag;
import fieldcal.effect.motion.BallChanged;
import fieldcal.effect.motion.BounceScatter;
import fieldcal.effect.motion.BounceSpinCoupling;
import fieldcal.effect.motion.CarpetNap;
import fieldcal.effect.motion.CarpetSeam;
import fieldcal.effect.motion.ContactImpacts;
import fieldcal.effect.motion.Drift;
import fieldcal.effect.motion.FieldSlope;
import fieldcal.effect.motion.KickSpin;
import fieldcal.effect.motion.Magnus;
import fieldcal.effect.motion.PullScatter;
import fieldcal.effect.motion.RobotKickBias;
import fieldcal.effect.motion.RollScatter;
import fieldcal.effect.motion.SideSpin;
import fieldcal.effect.motion.SlipDependentFriction;
import fieldcal.effect.motion.SpeedDependentRestitution;
import fieldcal.effect.motion.SpeedDependentRoll;
import fieldcal.effect.motion.Wind;
import fieldcal.effect.motion.WornRegion;
import fieldcal.vision.Team;
import java.util.List;
import java.util.Optional;

/** All effects that are known, each absent and with its smallest camera, robot or an empty region: one line per effect, in the order of the design's table. */
public final class EffectCatalogue {
  private static final List<Effect> ALL =
      List.of(
          new AirDrag(0),
          new Magnus(0),
          new KickSpin(0),
          new SideSpin(0),
          new FieldSlope(0, 0),
          new CarpetNap(0, 0),
          new SpeedDependentRoll(0),
          new WornRegion(0, 0, 0, 0, 0),
          new CameraOffset(0, 0, 0),
          new CameraTimeOffset(0, 0),
          new CameraPoseError(0, 0, 0, 0, 0, 0),
          new CameraPositionError(0, 0, 0, 0),
          new LensDistortionError(0, 0),
          new BallHeightError(0),
          new SpeedDependentRestitution(0),
          new BounceSpinCoupling(0),
          new Drift(0),
          new RobotKickBias(0, 0, Team.YELLOW, 0),
          new ClockSkew(0, 0),
          new RollingShutter(0),
          new Wind(0, 0),
          new SlipDependentFriction(0),
          new CameraMoved(0, 0, 0, 0),
          new BallChanged(0, 0, 0),
          new ContactImpacts(0, 0, 0, 0, 10),
          new CarpetSeam(0, 0, 0, 0));

  private static final List<Effect> UNNAMED =
      List.of(new RollScatter(0), new BounceScatter(0), new PullScatter(0));

  private EffectCatalogue() {}

  /**
   * All effects.
   *
   * @return absent ones, in the order of the design's table
   */
  public static List<Effect> all() {
    return ALL;
  }

  /**
   * What can differ from kick to kick without a cause: not to be named, and not part of an {@link ExtendedModel}.
   *
   * @return absent effects without a mean of their own
   */
  public static List<Effect> unnamed() {
    return UNNAMED;
  }

  /**
   * The effects on the motion.
   *
   * @return absent ones
   */
  public static List<MotionEffect> motion() {
    return ALL.stream()
        .filter(MotionEffect.class::isInstance)
        .map(MotionEffect.class::cast)
        .toList();
  }

  /**
   * The effects on what cameras report.
   *
   * @return absent ones
   */
  public static List<MeasurementEffect> measurement() {
    return ALL.stream()
        .filter(MeasurementEffect.class::isInstance)
        .map(MeasurementEffect.class::cast)
        .toList();
  }

  /**
   * The effect of an id.
   *
   * @param id as in {@link Effect#id}
   * @return the absent effect; empty when there is none
   */
  public static Optional<Effect> find(String id) {
    return ALL.stream().filter(e -> e.id().equals(id)).findFirst();
  }
}
