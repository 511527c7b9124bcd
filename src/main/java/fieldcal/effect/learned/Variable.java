package fieldcal.effect.learned;

import fieldcal.effect.BallMotion;
import java.util.Optional;
import java.util.Set;

/** On what a learned term may depend: predicted quantities, never measured ones. */
public enum Variable {
  /** Speed over the ground, m/s. */
  SPEED("speed", "m/s", 1, Set.of("ground", "kick", "measurement")),

  /** Speed of the contact point over the carpet while the ball slides, m/s; a term of it is absent when the ball rolls. */
  SLIP("slip", "m/s", 1, Set.of("ground")),

  /** Time since the kick, s. */
  TIME_SINCE_KICK("time_since_kick", "s", 1, Set.of("ground")),

  /** Time since the beginning of the session, s. */
  SESSION_TIME("session_time", "s", 1, Set.of("ground", "impact", "measurement")),

  /** Direction of travel, of sliding friction that of the slip, rad, 0 = along x, counter-clockwise. */
  HEADING("heading", "rad", 1, Set.of("ground", "impact", "kick")),

  /** Place on the field, x and y, m. */
  PLACE("place", "m", 2, Set.of("ground", "impact")),

  /** Straight-line distance from the kick, m. */
  DISTANCE_ROLLED("distance_rolled", "m", 1, Set.of("ground")),

  /** Vertical speed at an impact, m/s, positive. */
  VERTICAL_SPEED("vertical_speed", "m/s", 1, Set.of("impact")),

  /** Speed over the ground at an impact, m/s. */
  GROUND_SPEED("ground_speed", "m/s", 1, Set.of("impact")),

  /** Which impact of a chip: 1 = the first. */
  HOP("hop", "", 1, Set.of("impact")),

  /** Reported position relative to the place below the camera, x and y, m. */
  IMAGE_POSITION("image_position", "m", 2, Set.of("measurement"));

  /** Fastest change of the speed over the ground on the carpet, m/s²: accSlide is −3.3 and accRoll −0.28 in matches of 2026, rounded up. */
  private static final double SLIDING_RATE = 4;

  private static final double ROLLING_RATE = 1;

  /** Fastest change of the slip, m/s²: accSlide/(1 − kSwitch) = 3.3/0.34, rounded up. */
  private static final double SLIP_RATE = 12;

  private final String label;
  private final String unit;
  private final int dimension;
  private final Set<String> where;

  Variable(String label, String unit, int dimension, Set<String> where) {
    this.label = label;
    this.unit = unit;
    this.dimension = dimension;
    this.where = where;
  }

  /**
   * The name in files.
   *
   * @return lower case with underscores
   */
  public String label() {
    return label;
  }

  /**
   * The unit.
   *
   * @return empty when it has none
   */
  public String unit() {
    return unit;
  }

  /**
   * How many numbers it is.
   *
   * @return 2 of a place, else 1
   */
  public int dimension() {
    return dimension;
  }

  /**
   * Whether it is known where a quantity acts.
   *
   * @param quantity which
   * @return false for example for the slip at an impact
   */
  public boolean isKnownAt(Quantity quantity) {
    return where.contains(quantity.actsOn());
  }

  /**
   * The variable of a name.
   *
   * @param label as in {@link #label}
   * @return empty when there is none
   */
  public static Optional<Variable> of(String label) {
    for (Variable variable : values()) {
      if (variable.label.equals(label)) {
        return Optional.of(variable);
      }
    }
    return Optional.empty();
  }

  /** The number at an instant of the motion; the first one of a place. */
  double first(BallMotion m) {
    return switch (this) {
      case SPEED, GROUND_SPEED -> m.groundSpeed();
      case SLIP -> slip(m);
      case TIME_SINCE_KICK -> m.timeSinceKick();
      case SESSION_TIME -> m.sessionTime();
      case HEADING -> Math.atan2(m.vy(), m.vx());
      case PLACE, IMAGE_POSITION -> m.x();
      case DISTANCE_ROLLED -> m.distanceFromKick();
      case VERTICAL_SPEED -> Math.abs(m.vz());
      case HOP -> m.hop();
    };
  }

  /** The second number of a place at an instant of the motion; 0 of what has one. */
  double second(BallMotion m) {
    return dimension == 2 ? m.y() : 0;
  }

  /** How fast it changes on the carpet at most, its unit per second. */
  double rate(BallMotion m) {
    return switch (this) {
      case SPEED -> m.isSliding() ? SLIDING_RATE : ROLLING_RATE;
      case SLIP -> SLIP_RATE;
      case TIME_SINCE_KICK, SESSION_TIME -> 1;
      case PLACE, DISTANCE_ROLLED -> m.groundSpeed();
      case HEADING, VERTICAL_SPEED, GROUND_SPEED, HOP, IMAGE_POSITION -> 0;
    };
  }

  private static double slip(BallMotion m) {
    double x = m.vx() - m.spinX();
    double y = m.vy() - m.spinY();
    return Math.sqrt(x * x + y * y);
  }
}
