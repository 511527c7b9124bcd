package fieldcal.app.wording;

import fieldcal.effect.Effect;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;

/** The words of every effect: one entry each, with its name and its sentences. */
final class EffectWords {
  private static final Map<String, EffectWords> ALL =
      Map.ofEntries(
          air("air_drag", "air drag", AirWords::airDrag),
          air("magnus", "lift of spinning balls (Magnus)", AirWords::magnus),
          air("wind", "moving air", AirWords::wind),
          kick("kick_spin", "topspin/backspin from the kicker", KickWords::kickSpin),
          kick("side_spin", "side spin from the kicker", KickWords::sideSpin),
          kick("robot_kick_bias", "badly calibrated kicker", KickWords::robotKickBias),
          carpet("field_slope", "sloping field", CarpetWords::fieldSlope),
          carpet("carpet_nap", "direction of the carpet", CarpetWords::carpetNap),
          carpet(
              "speed_dependent_roll",
              "rolling that depends on speed",
              CarpetWords::speedDependentRoll),
          carpet(
              "slip_dependent_friction",
              "friction that depends on slip",
              CarpetWords::slipDependentFriction),
          carpet("worn_region", "worn part of the carpet", CarpetWords::wornRegion),
          carpet("carpet_seam", "seam of the carpet", CarpetWords::carpetSeam),
          carpet("drift", "carpet that changes over time", CarpetWords::drift),
          carpet("ball_changed", "another ball", CarpetWords::ballChanged),
          bounce(
              "speed_dependent_restitution",
              "bounces that depend on speed",
              BounceWords::speedDependentRestitution),
          bounce(
              "bounce_spin_coupling",
              "bounces that depend on spin",
              BounceWords::bounceSpinCoupling),
          bounce("contact_impacts", "bounces that build up spin", BounceWords::contactImpacts),
          camera(
              "camera_offset",
              "offset of a camera",
              "offset of %s",
              "is shifted",
              CameraWords::offset),
          camera(
              "camera_time_offset",
              "wrong time stamps",
              "wrong time stamps of %s",
              "has wrong time stamps",
              CameraWords::timeOffset),
          camera(
              "camera_pose_error",
              "misplaced camera",
              "misplaced %s",
              "is misplaced",
              CameraWords::poseError),
          camera(
              "camera_position_error",
              "wrong camera position in vision",
              "wrong position of %s in vision",
              "is published at the wrong position",
              CameraWords::positionError),
          camera("camera_moved", "knocked camera", "knocked %s", "was knocked", CameraWords::moved),
          camera(
              "lens_distortion_error",
              "wrong lens distortion",
              "wrong lens distortion of %s",
              "has the wrong lens distortion",
              CameraWords::lensDistortion),
          camera("ball_height_error", "wrong ball height in vision", CameraWords::ballHeight),
          camera(
              "clock_skew",
              "camera clock at the wrong rate",
              "clock of %s at the wrong rate",
              "has a clock at the wrong rate",
              CameraWords::clockSkew),
          camera("rolling_shutter", "rolling shutter", CameraWords::rollingShutter));

  /** What is said of a camera whose effect has no words for that. */
  private static final String AFFECTED = "has the fault";

  private static final String OF_CAMERA = " of %s";

  private final String name;
  private final String ofCamera;
  private final String predicate;
  private final Maker maker;

  private EffectWords(String name, String ofCamera, String predicate, Maker maker) {
    this.name = name;
    this.ofCamera = ofCamera;
    this.predicate = predicate;
    this.maker = maker;
  }

  @FunctionalInterface
  private interface Maker {
    Sentences of(
        Effect effect, Map<String, Double> errors, ExampleKicks kicks, ReportedShifts shifts);
  }

  private static Map.Entry<String, EffectWords> air(
      String id, String name, Function<AirWords, Sentences> words) {
    return entry(id, name, (e, errors, kicks, s) -> words.apply(new AirWords(e, errors, kicks)));
  }

  private static Map.Entry<String, EffectWords> kick(
      String id, String name, Function<KickWords, Sentences> words) {
    return entry(id, name, (e, errors, kicks, s) -> words.apply(new KickWords(e, errors, kicks)));
  }

  private static Map.Entry<String, EffectWords> carpet(
      String id, String name, Function<CarpetWords, Sentences> words) {
    return entry(id, name, (e, errors, kicks, s) -> words.apply(new CarpetWords(e, errors, kicks)));
  }

  private static Map.Entry<String, EffectWords> bounce(
      String id, String name, Function<BounceWords, Sentences> words) {
    return entry(id, name, (e, errors, kicks, s) -> words.apply(new BounceWords(e, errors, kicks)));
  }

  private static Map.Entry<String, EffectWords> camera(
      String id, String name, Function<CameraWords, Sentences> words) {
    return camera(id, name, name + OF_CAMERA, AFFECTED, words);
  }

  /** The name and the predicate of one camera: "offset of camera 1", "camera 1 is shifted". */
  private static Map.Entry<String, EffectWords> camera(
      String id,
      String name,
      String ofCamera,
      String predicate,
      Function<CameraWords, Sentences> words) {
    Maker maker = (e, errors, k, shifts) -> words.apply(new CameraWords(e, errors, shifts));
    return Map.entry(id, new EffectWords(name, ofCamera, predicate, maker));
  }

  private static Map.Entry<String, EffectWords> entry(String id, String name, Maker maker) {
    return Map.entry(id, new EffectWords(name, name + OF_CAMERA, AFFECTED, maker));
  }

  /** Empty for an effect that has no words of its own. */
  static Optional<EffectWords> of(String id) {
    return Optional.ofNullable(ALL.get(id));
  }

  /** A few words in lower case. */
  String name() {
    return name;
  }

  /** The name of what one camera has, or all of them: "offset of camera 1". */
  String name(String camera) {
    return ofCamera.formatted(camera);
  }

  /** What is said of one camera of several: "camera 1" and this. */
  static String ofOneCamera(String id) {
    return of(id).map(words -> words.predicate).orElse(AFFECTED);
  }

  /** What is wrong, what it does, what to do. */
  Sentences sentences(
      Effect effect, Map<String, Double> errors, ExampleKicks kicks, ReportedShifts shifts) {
    return maker.of(effect, errors, kicks, shifts);
  }
}
