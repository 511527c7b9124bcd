package fieldcal.app.export;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * What a model offers to targets, by the names of the descriptors; SI units. Immutable.
 *
 * <p>Of the ball: {@code acc_slide}, {@code acc_roll} (m/s²), {@code k_switch}, {@code inertia} (1/k_switch − 1), {@code damping_xy_first_hop}, {@code
 * damping_xy_other_hops}, {@code damping_z}, {@code min_bounce_speed} (m/s, the vertical speed of an impact after which the model has no further hop) and {@code roll_slope} (1/s, 0 without the effect
 * {@code speed_dependent_roll}). Of the cameras: {@code ball_noise} and {@code camera_offset} (m), and from a twin {@code robot_noise} (m), {@code robot_angle_noise} (rad), {@code missed_balls}, {@code missed_robots} (shares) and {@code processing_time} (s, from exposure to sending). Of the robots: {@code velocity_max} (m/s), {@code acceleration_max} and {@code
 * braking_max} (m/s²), and where the robots reached them {@code angular_velocity_max} (rad/s), {@code angular_acceleration_max} and {@code angular_braking_max} (rad/s²) of the team that is chosen, and of both with {@code yellow.} or {@code blue.} before them.
 */
public final class Quantities {
  /** m/s², as in {@code fieldcal.ball}. */
  private static final double GRAVITY = 9.81;

  /** The parameters of the league's message. */
  static final List<String> OF_MODEL =
      List.of(
          "acc_slide",
          "acc_roll",
          "k_switch",
          "damping_xy_first_hop",
          "damping_xy_other_hops",
          "damping_z");

  private final Map<String, Double> values;

  private Quantities(Map<String, Double> values) {
    this.values = values;
  }

  /** Nothing known. */
  static Quantities none() {
    return new Quantities(Map.of());
  }

  Quantities with(String name, double value) {
    if (!Double.isFinite(value)) {
      return this;
    }
    Map<String, Double> more = new LinkedHashMap<>(values);
    more.put(name, value);
    return new Quantities(more);
  }

  Quantities with(FlatModel flat) {
    return with("acc_slide", flat.accSlide())
        .with("acc_roll", flat.accRoll())
        .with("k_switch", flat.kSwitch())
        .with("inertia", flat.inertiaFactor());
  }

  Quantities with(ChipModel chip) {
    double lowestTakeOff = Math.sqrt(2 * GRAVITY * ChipModel.MIN_HOP_HEIGHT);
    return with("damping_xy_first_hop", chip.dampingXyFirstHop())
        .with("damping_xy_other_hops", chip.dampingXyOtherHops())
        .with("damping_z", chip.dampingZ())
        .with("min_bounce_speed", lowestTakeOff / chip.dampingZ());
  }

  /** These, and the others where these have nothing. */
  Quantities and(Quantities others) {
    Map<String, Double> more = new LinkedHashMap<>(others.values);
    more.putAll(values);
    return new Quantities(more);
  }

  /**
   * A quantity.
   *
   * @param name as descriptors have it
   * @return its value, SI; empty when the model does not have it
   */
  public OptionalDouble of(String name) {
    Double value = values.get(name);
    return value == null ? OptionalDouble.empty() : OptionalDouble.of(value);
  }
}
