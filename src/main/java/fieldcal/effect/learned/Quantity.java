package fieldcal.effect.learned;

import java.util.Optional;

/** What a learned term changes, with its unit and the usual size of such changes. */
public enum Quantity {
  /** Acceleration along the path, sliding or rolling, m/s²; positive makes the ball faster. */
  ACCELERATION_ALONG("ground", "acceleration_along", "m/s²", 1, 0.05, 3, "accRoll is −0.3 m/s²"),

  /** Acceleration across the path, sliding or rolling, m/s²; positive turns the ball to its left. */
  ACCELERATION_ACROSS(
      "ground", "acceleration_across", "m/s²", 1, 0.05, 3, "a slope of 0.5 % pulls so much"),

  /** Relative change of the carpet's friction, sliding and rolling (–); positive brakes more. */
  FRICTION(
      "ground", "friction", "", 1, 0.05, 0.9, "up to 0.08 with the heading in matches of 2026"),

  /** Relative change of the rolling deceleration alone (–); positive brakes more. */
  ROLLING("ground", "rolling", "", 1, 0.05, 0.9, "accRoll scatters by 0.1 in matches of 2026"),

  /** Friction of a sliding ball as a part of the model's (–), which depends on the direction of the slip: the coefficients of what brakes more come first, then those of what pulls to the left of the slip. */
  SLIDING("ground", "sliding", "", 2, 0.1, 0.9, "a friction box has 0.41 more at its corners"),

  /** Force over the mass along x and y of the field on a ball on the carpet, m/s²: the coefficients of x come first, then those of y. A rolling ball follows it with 5/7, since it must be turned, too. */
  PUSH("ground", "push", "m/s²", 2, 0.05, 3, "a slope of 0.5 % pulls so much"),

  /** Height of the floor under the carpet, mm, relative to the rest of the field: a ball is pulled downhill, by g times the slope. A rolling ball follows it with 5/7, since it must be turned, too. */
  FLOOR("ground", "floor", "mm", 1, 1, 12, "DIN 18202: 4 mm within 1 m, 12 mm within 10 m"),

  /** Relative change of the rolling deceleration by the pile of the carpet (–): a·cos θ + b·sin θ for a ball that travels in direction θ. The coefficients of a come first, then those of b; positive brakes more. */
  NAP("ground", "nap", "", 2, 0.05, 0.9, "up to 0.08 with the heading in matches of 2026"),

  /** Velocity of the air along x and y of the field, m/s, on which drag depends: the coefficients of x come first, then those of y. */
  AIR("ground", "air", "m/s", 2, 0.5, 10, "an open hall door moves air at 0.3 to 2 m/s"),

  /** Change of the vertical restitution e_z (–). */
  VERTICAL_RESTITUTION(
      "impact", "vertical_restitution", "", 1, 0.03, 0.5, "0.47 and 0.38 in matches of 2026"),

  /** Change of the tangential restitution e_xy (–). */
  TANGENTIAL_RESTITUTION(
      "impact", "tangential_restitution", "", 1, 0.03, 0.5, "0.70 and 0.87 in matches of 2026"),

  /** Turn of the path at an impact, rad; positive to the ball's left. */
  TURN("impact", "turn", "rad", 1, 0.02, 0.5, "chosen: a degree"),

  /** Spin right after the kick about the rolling axis, as a fraction of rolling spin (–). */
  SPIN("kick", "spin", "", 1, 0.1, 2, "kSwitch scatters by 0.075 in matches of 2026"),

  /** Error of the reported position along x and y, mm: the coefficients of x come first, then those of y. */
  SHIFT("measurement", "shift", "mm", 2, 5, 200, "cameras disagree by 20 mm in matches of 2026"),

  /** Error of the time stamp, ms; positive = the stamp is late. */
  TIME_ERROR("measurement", "time_error", "ms", 1, 1, 50, "jitter of 0.2 to 1.3 ms in 2026");

  private final String actsOn;
  private final String label;
  private final String unit;
  private final int components;
  private final double scale;
  private final double limit;
  private final String source;

  Quantity(
      String actsOn,
      String label,
      String unit,
      int components,
      double scale,
      double limit,
      String source) {
    this.actsOn = actsOn;
    this.label = label;
    this.unit = unit;
    this.components = components;
    this.scale = scale;
    this.limit = limit;
    this.source = source;
  }

  /**
   * Where it acts.
   *
   * @return "ground", "impact", "kick" or "measurement"
   */
  public String actsOn() {
    return actsOn;
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
   * @return 2 of what has components along x and y, and of sliding friction, else 1
   */
  public int components() {
    return components;
  }

  /** Whether a dependence on a variable that is known where it acts makes sense: a push by the field cannot depend on how the ball moves, nor a camera's error on where the ball goes next. */
  boolean canDependOn(Variable variable) {
    return switch (this) {
      case SLIDING -> variable == Variable.HEADING;
      case PUSH -> variable == Variable.PLACE || variable == Variable.SESSION_TIME;
      case FLOOR, NAP, AIR -> variable == Variable.PLACE;
      case TIME_ERROR -> variable == Variable.SESSION_TIME || variable == Variable.SPEED;
      case SHIFT -> variable == Variable.SESSION_TIME || variable == Variable.IMAGE_POSITION;
      default -> true;
    };
  }

  /**
   * The usual size of a change, the prior's standard deviation of a coefficient.
   *
   * @return in the unit
   */
  public double scale() {
    return scale;
  }

  /**
   * The largest coefficient, in absolute value, that a fit may return.
   *
   * @return in the unit
   */
  public double limit() {
    return limit;
  }

  /**
   * Where the scale comes from.
   *
   * @return a few words
   */
  public String source() {
    return source;
  }

  /**
   * The quantity of a name.
   *
   * @param label as in {@link #label}
   * @return empty when there is none
   */
  public static Optional<Quantity> of(String label) {
    for (Quantity quantity : values()) {
      if (quantity.label.equals(label)) {
        return Optional.of(quantity);
      }
    }
    return Optional.empty();
  }
}
