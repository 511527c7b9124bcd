package fieldcal.simulation.physics;

import java.util.Locale;
import java.util.Objects;

/**
 * A law that was measured and has no formula: something of the ball's motion changes by a tabulated amount that depends on how or where it moves.
 *
 * @param changes what changes
 * @param dependsOn on what the amount depends
 * @param table the amount, in the unit of what changes
 */
public record TabulatedLaw(Quantity changes, Variable dependsOn, Table table) implements ExtraLaw {
  private static final double METRES_PER_MM = 1e-3;

  /** To each side of the ball over which the floor's slope is taken, m: so it is continuous though the height is linear between the points. Mounds that a carpet covers are wider. */
  private static final double SLOPE_OVER = 0.1;

  /** What a table may change. */
  public enum Quantity {
    /** Acceleration along the path on the carpet, m/s²; positive makes the ball faster. */
    ACCELERATION_ALONG,
    /** Acceleration across the path on the carpet, m/s²; positive turns it to the left. */
    ACCELERATION_ACROSS,
    /** Relative change of the friction, sliding and rolling (–); positive brakes more. */
    FRICTION,
    /** Relative change of the rolling deceleration alone (–); positive brakes more. */
    ROLLING,
    /** Relative change of the friction of a sliding ball against its slip (–); positive brakes more. */
    SLIDING_ALONG,
    /** Friction of a sliding ball to the left of its slip, as a part of that against it (–). */
    SLIDING_ACROSS,
    /** Force over the mass along x on a ball on the carpet, m/s²; a rolling ball takes a part of it. */
    PUSH_X,
    /** Force over the mass along y on a ball on the carpet, m/s². */
    PUSH_Y,
    /** Height of the floor, mm; pulls a ball on the carpet downhill, by g times the slope. */
    FLOOR,
    /** Relative change of the rolling deceleration of a ball that travels along x (–), times the cosine for others; positive brakes more. */
    NAP_X,
    /** Relative change of the rolling deceleration of a ball that travels along y (–), times the sine for others. */
    NAP_Y,
    /** Velocity of the air along x beside the wind that is the same everywhere, m/s. */
    AIR_X,
    /** Velocity of the air along y, m/s. */
    AIR_Y,
    /** Added to e_z of an impact (–). */
    VERTICAL_RESTITUTION,
    /** Added to e_xy of an impact (–). */
    TANGENTIAL_RESTITUTION,
    /** Turn of the path at an impact, rad; positive to the left. */
    TURN;

    /**
     * Its name in files.
     *
     * @return lower case with underscores
     */
    public String label() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** On what a table may depend. */
  public enum Variable {
    /** Speed over the ground, m/s. */
    SPEED(1),
    /** Speed at which the contact point slips, m/s; the table does nothing while the ball rolls. */
    SLIP(1),
    /** Time since the kick, s. */
    TIME_SINCE_KICK(1),
    /** Session time, s. */
    SESSION_TIME(1),
    /** Direction of travel, of sliding friction that of the slip, rad. */
    HEADING(1),
    /** Place on the field, x and y, m. */
    PLACE(2),
    /** Straight distance from the place of the kick, m. */
    DISTANCE_ROLLED(1),
    /** Vertical speed before an impact, m/s, positive. */
    VERTICAL_SPEED(1),
    /** Speed over the ground before an impact, m/s. */
    GROUND_SPEED(1),
    /** Which impact since the kick: 1 = the first. */
    HOP(1);

    private final int dimension;

    Variable(int dimension) {
      this.dimension = dimension;
    }

    /**
     * Its name in files.
     *
     * @return lower case with underscores
     */
    public String label() {
      return name().toLowerCase(Locale.ROOT);
    }

    /**
     * How many numbers it is.
     *
     * @return 2 of a place, else 1
     */
    public int dimension() {
      return dimension;
    }
  }

  /**
   * Checks that the table has as many dimensions as the variable. {@inheritDoc}
   *
   * @throws IllegalArgumentException when it has not
   */
  public TabulatedLaw {
    Objects.requireNonNull(changes, "changes");
    Objects.requireNonNull(dependsOn, "dependsOn");
    if (table.isSurface() && dependsOn.dimension() == 1) {
      throw new IllegalArgumentException(
          dependsOn.label() + " is one number, but the " + table + " needs two");
    }
  }

  private double at(BallMoment m) {
    return switch (dependsOn) {
      case SPEED, GROUND_SPEED -> table.at(m.groundSpeed(), 0);
      case SLIP -> m.slip() > 0 ? table.at(m.slip(), 0) : 0;
      case TIME_SINCE_KICK -> table.at(m.sinceKick(), 0);
      case SESSION_TIME -> table.at(m.sessionTime(), 0);
      case HEADING -> table.at(ofSlip() ? m.slipHeading() : m.heading(), 0);
      case PLACE -> table.at(m.x(), m.y());
      case DISTANCE_ROLLED -> table.at(m.distanceFromKick(), 0);
      case VERTICAL_SPEED -> table.at(Math.abs(m.vz()), 0);
      case HOP -> table.at(m.hop(), 0);
    };
  }

  private boolean ofSlip() {
    return changes == Quantity.SLIDING_ALONG || changes == Quantity.SLIDING_ACROSS;
  }

  @Override
  public double slidingFactor(BallMoment moment) {
    return changes == Quantity.SLIDING_ALONG ? Math.max(0, 1 + at(moment)) : frictionFactor(moment);
  }

  @Override
  public double slidingAcross(BallMoment moment) {
    return changes == Quantity.SLIDING_ACROSS ? at(moment) : 0;
  }

  @Override
  public double rollingFactor(BallMoment moment) {
    return changes == Quantity.ROLLING ? Math.max(0, 1 + at(moment)) : frictionFactor(moment);
  }

  @Override
  public double rollingChange(BallMoment moment) {
    double along =
        switch (changes) {
          case NAP_X -> Math.cos(moment.heading());
          case NAP_Y -> Math.sin(moment.heading());
          default -> 0;
        };
    return along == 0 ? 0 : along * at(moment);
  }

  @Override
  public void flow(BallMoment moment, double[] air) {
    if (changes == Quantity.AIR_X || changes == Quantity.AIR_Y) {
      air[changes == Quantity.AIR_X ? 0 : 1] += at(moment);
    }
  }

  private double frictionFactor(BallMoment moment) {
    return changes == Quantity.FRICTION ? Math.max(0, 1 + at(moment)) : 1;
  }

  @Override
  public double alongPath(BallMoment moment) {
    return changes == Quantity.ACCELERATION_ALONG ? at(moment) : 0;
  }

  @Override
  public double acrossPath(BallMoment moment) {
    return changes == Quantity.ACCELERATION_ACROSS ? at(moment) : 0;
  }

  @Override
  public void push(BallMoment moment, double[] acceleration) {
    boolean pushes = changes == Quantity.PUSH_X || changes == Quantity.PUSH_Y;
    // A ball on the carpet has no vertical speed, one in flight has none for an instant only.
    boolean onCarpet = moment.vz() == 0;
    if (pushes && onCarpet) {
      acceleration[changes == Quantity.PUSH_X ? 0 : 1] += at(moment);
    } else if (changes == Quantity.FLOOR && onCarpet) {
      double x = moment.x();
      double y = moment.y();
      acceleration[0] -= pull(table.at(x - SLOPE_OVER, y), table.at(x + SLOPE_OVER, y));
      acceleration[1] -= pull(table.at(x, y - SLOPE_OVER), table.at(x, y + SLOPE_OVER));
    }
  }

  /** g times the slope between two heights in mm. */
  private static double pull(double before, double behind) {
    return BallPhysics.GRAVITY * METRES_PER_MM * (behind - before) / (2 * SLOPE_OVER);
  }

  @Override
  public double restitutionChange(BallMoment moment) {
    return changes == Quantity.VERTICAL_RESTITUTION ? at(moment) : 0;
  }

  @Override
  public double alongChange(BallMoment moment) {
    return changes == Quantity.TANGENTIAL_RESTITUTION ? at(moment) : 0;
  }

  @Override
  public double turn(BallMoment moment) {
    return changes == Quantity.TURN ? at(moment) : 0;
  }
}
