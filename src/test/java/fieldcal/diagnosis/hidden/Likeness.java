package fieldcal.diagnosis.hidden;

import fieldcal.ball.Parameter;
import fieldcal.camera.CameraCalibration;
import fieldcal.diagnosis.hidden.Answer.Named;
import fieldcal.diagnosis.hidden.Judgement.Strength;
import fieldcal.effect.Effect;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.SimulatedEffect;
import fieldcal.simulation.truth.Truth;
import java.util.Locale;
import java.util.stream.Collectors;

/** Whether a cause is a hidden effect, by its name and by what is the same under another, and how well its numbers are met. */
final class Likeness {
  /** Share of its variation over the paths that a named region must have in common with the true one. */
  private static final double SAME_REGION = 0.5;

  /** An offset within that of the line between two cameras could be a wrong height of the ball, rad. */
  private static final double ALONG = 0.5;

  private final EffectSetting hidden;
  private final Visibility visibility;
  private final Truth truth;
  private final Named cause;
  private final Effect named;
  private final int cameras;

  Likeness(EffectSetting hidden, Visibility visibility, Truth truth, Named cause) {
    this.hidden = hidden;
    this.visibility = visibility;
    this.truth = truth;
    this.cause = cause;
    named = cause.effect();
    cameras = truth.cameras().size();
  }

  /** Whether the cause is the effect. */
  boolean same() {
    SimulatedEffect effect = hidden.effect();
    boolean sameName = named.id().equals(effect.id());
    return switch (effect) {
      case CAMERA_OFFSET ->
          named.id().equals("ball_height_error")
              ? cameras == 2 && alongTheLine()
              : (sameName || named.id().equals("camera_pose_error")) && sameOfTwo();
      case CAMERA_POSE_ERROR ->
          (sameName || named.id().equals("camera_offset") && onlyOffset()) && sameOfTwo();
      case BALL_HEIGHT_ERROR ->
          sameName || named.id().equals("camera_offset") && cameras == 2 && onlyOffset();
      case CAMERA_TIME_OFFSET, CLOCK_SKEW, CAMERA_MOVED -> sameName && sameOfTwo();
      case LENS_DISTORTION_ERROR, CAMERA_POSITION_ERROR -> sameName && sameCamera();
      case ROBOT_KICK_BIAS -> sameName && sameRobot();
      case WORN_REGION ->
          sameName && Math.abs(RegionOverlap.correlation(hidden, named, truth)) > SAME_REGION;
      default -> sameName;
    };
  }

  /**
   * Whether a cause that is not the effect describes a part of it, so that its name beside the right one is not wrong.
   *
   * @return true for what a camera is off on average over a session in which it was knocked, and for laws of the impact where spin acts at impacts
   */
  boolean alike() {
    boolean chips =
        truth.commandedKicks().stream()
            .anyMatch(k -> k.kind() == fieldcal.simulation.truth.KickKind.CHIP);
    boolean impactLaw =
        named.id().equals("contact_impacts") || named.id().equals("bounce_spin_coupling");
    return switch (hidden.effect()) {
      case CAMERA_MOVED ->
          (named.id().equals("camera_offset") || named.id().equals("camera_pose_error"))
              && sameOfTwo();
      case CONTACT_IMPACTS, BOUNCE_SPIN_COUPLING, KICK_SPIN, SIDE_SPIN -> chips && impactLaw;
      // Lift without spin is nothing: the two are proposed together.
      case MAGNUS -> chips && (impactLaw || named.id().equals("kick_spin"));
      default -> false;
    };
  }

  /** Whether the cause is said to be indistinguishable from the effect. */
  boolean tied() {
    return cause.indistinguishableFrom().stream().anyMatch(this::means);
  }

  private boolean means(String tie) {
    String[] words = tie.split(" of camera ");
    return words[0].trim().equals(hidden.effect().id())
        && (words.length == 1
            || cameras == 2
            || Integer.parseInt(words[1].trim()) == (int) hidden.number("camera"));
  }

  /** The same camera, or all. */
  private boolean sameCamera() {
    boolean one =
        named.parameters().stream().anyMatch(p -> p.name().equals("camera") && p.value() >= 0);
    String written = hidden.values().getOrDefault("camera", "all");
    return one
        ? !written.equals("all") && (int) hidden.number("camera") == (int) named.value("camera")
        : written.equals("all");
  }

  /** Of two cameras only the difference can be seen: one is wrong, or the other by the opposite. */
  private boolean sameOfTwo() {
    return sameCamera() || cameras == 2;
  }

  private double sign() {
    return sameCamera() ? 1 : -1;
  }

  /** Whether an offset of the cameras is all that is to be seen. */
  private boolean onlyOffset() {
    return visibility.gainBeyondOffsets() < Visibility.MARGINAL;
  }

  private boolean alongTheLine() {
    CameraCalibration a = truth.cameras().get(0).trueCalibration();
    CameraCalibration b = truth.cameras().get(1).trueCalibration();
    double line =
        Math.atan2(b.derivedWorldY() - a.derivedWorldY(), b.derivedWorldX() - a.derivedWorldX());
    double offset = Math.atan2(hidden.number("y_mm"), hidden.number("x_mm"));
    return Math.abs(Math.sin(offset - line)) < Math.sin(ALONG);
  }

  private boolean sameRobot() {
    boolean yellow = hidden.values().get("team").equals("yellow");
    return named.value("robot") == hidden.number("robot") && (named.value("team") == 0) == yellow;
  }

  /** How well the numbers are met; call it only when the cause is the effect. */
  Strength strength() {
    if (!named.id().equals(hidden.effect().id())
        || hidden.effect() == SimulatedEffect.CAMERA_POSE_ERROR
            && hidden.number("height_mm") == 0) {
      return displaced();
    }
    return switch (hidden.effect()) {
      case FIELD_SLOPE -> polar("percent", "direction");
      case CARPET_NAP -> polar("amplitude", "direction");
      case KICK_SPIN, SIDE_SPIN -> spin();
      case WORN_REGION -> RegionOverlap.strength(hidden, cause, truth);
      case WIND -> polar("speed", "direction");
      case CAMERA_OFFSET, CAMERA_MOVED -> components(sign(), "x_mm", "y_mm");
      case BALL_CHANGED -> components(1, "roll", "slide");
      case CARPET_SEAM -> components(1, "loss", "turn");
      case CAMERA_TIME_OFFSET -> components(sign(), "ms");
      case CLOCK_SKEW -> components(sign(), "ppm");
      case CAMERA_POSE_ERROR -> components(sign(), "height_mm");
      case ROBOT_KICK_BIAS -> bias();
      default -> components(1, hidden.effect().parameters().get(0).name());
    };
  }

  private double error(String name) {
    return cause.standardErrors().getOrDefault(name, Double.NaN);
  }

  private Strength components(double sign, String... names) {
    double[] scores = new double[names.length];
    double off = 0;
    double size = 0;
    for (int i = 0; i < names.length; i++) {
      String name = names[i];
      double difference = sign * named.value(name) - hidden.number(name);
      scores[i] = difference / error(name);
      off = Math.hypot(off, difference);
      size = Math.hypot(size, hidden.number(name));
    }
    return Strength.of(100 * off / size, scores);
  }

  private Strength polar(String size, String direction) {
    double r = named.value(size);
    double a = named.value(direction);
    if (r < 0) {
      r = -r;
      a += Math.PI;
    }
    double trueR = hidden.number(size);
    double trueA = hidden.number(direction);
    double turn = Math.IEEEremainder(a - trueA, 2 * Math.PI);
    double off = Math.hypot(r * Math.cos(turn) - trueR, r * Math.sin(turn));
    return Strength.of(100 * off / trueR, (r - trueR) / error(size), turn / error(direction));
  }

  /** Against the mean and the scatter of the kicks that were made; chips show it at their impacts. */
  private Strength spin() {
    double radius = truth.physics().ball().radius();
    boolean roll = hidden.effect() == SimulatedEffect.KICK_SPIN;
    double[] spins =
        truth.commandedKicks().stream()
            .mapToDouble(k -> roll ? k.rollFraction(radius) : k.sideFraction(radius))
            .toArray();
    double sum = 0;
    double squares = 0;
    for (double s : spins) {
      sum += s;
      squares += s * s;
    }
    double mean = sum / spins.length;
    double scatter = Math.sqrt(Math.max(0, squares - sum * mean) / Math.max(1, spins.length - 1));
    double off = Math.hypot(named.value("fraction") - mean, cause.scatter() - scatter);
    return Strength.of(
        100 * off / Math.hypot(mean, scatter),
        (named.value("fraction") - mean) / error("fraction"));
  }

  private Strength bias() {
    String[] names = {"percent", "yaw"};
    double[] scores = new double[names.length];
    double percent = Double.NaN;
    for (int i = 0; i < names.length; i++) {
      double difference = Math.abs(named.value(names[i]) - hidden.number(names[i]));
      scores[i] = difference / error(names[i]);
      double size = Math.abs(hidden.number(names[i]));
      if (size > 0) {
        double off = 100 * difference / size;
        percent = Double.isNaN(percent) ? off : Math.max(percent, off);
      }
    }
    return Strength.of(percent, scores);
  }

  /** By how much one camera's reports are moved below it against the mean of all, when two names say so differently. */
  private Strength displaced() {
    double[] was = displacement(hidden.effect().id(), hidden::number);
    double[] is = displacement(named.id(), named::value);
    if (was == null || is == null) {
      return Strength.of(Double.NaN);
    }
    double sign = sign();
    double off = Math.hypot(sign * is[0] - was[0], sign * is[1] - was[1]);
    return Strength.of(100 * off / Math.hypot(was[0], was[1]));
  }

  private interface Numbers {
    double get(String name);
  }

  private double[] displacement(String id, Numbers numbers) {
    if (id.equals("camera_offset")) {
      return new double[] {numbers.get("x_mm"), numbers.get("y_mm")};
    }
    if (!id.equals("camera_pose_error")) {
      return null;
    }
    int camera = (int) numbers.get("camera");
    double height = truth.cameras().get(camera).trueCalibration().derivedWorldZ();
    double tilt = numbers.get("tilt_mrad") * height;
    double axis = numbers.get("axis");
    double share = cameras == 1 ? 1 : (cameras - 1.0) / cameras;
    // The ray straight down, turned about (cos, sin, 0), lands at height × (−sin, cos).
    return new double[] {
      share * (numbers.get("shift_x_mm") - tilt * Math.sin(axis)),
      share * (numbers.get("shift_y_mm") + tilt * Math.cos(axis))
    };
  }

  static String text(Effect effect) {
    return effect.parameters().stream()
        .filter(p -> p.value() != 0 || !p.estimated())
        .map(Likeness::text)
        .collect(Collectors.joining(",", effect.id() + ":", ""));
  }

  private static String text(Parameter p) {
    return p.name() + "=" + String.format(Locale.ROOT, p.estimated() ? "%.3g" : "%.2f", p.value());
  }
}
