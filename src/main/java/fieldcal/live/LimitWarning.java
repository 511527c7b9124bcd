package fieldcal.live;

import fieldcal.movement.LimitEstimate;
import fieldcal.movement.TeamLimits;
import fieldcal.vision.Team;
import java.util.Locale;
import java.util.Objects;

/**
 * A team's robots do not move as they are configured to.
 *
 * @param team whose
 * @param limit which of their limits
 * @param time end of the data behind the estimate, Unix time, s
 * @param estimate what they do
 * @param configured what they are configured to do, in the limit's unit; NaN when a warning ends because nothing is configured any more
 */
public record LimitWarning(
    Team team, Limit limit, double time, LimitEstimate estimate, double configured) {

  /** What can be limited. */
  public enum Limit {
    /** Speed, m/s. */
    VELOCITY("m/s"),
    /** Speeding up, m/s². */
    ACCELERATION("m/s²"),
    /** Slowing down, m/s². */
    BRAKING("m/s²");

    private final String unit;

    Limit(String unit) {
      this.unit = unit;
    }

    /**
     * The unit.
     *
     * @return m/s or m/s²
     */
    public String unit() {
      return unit;
    }

    /**
     * The name in files and sentences.
     *
     * @return lower case
     */
    public String label() {
      return name().toLowerCase(Locale.ROOT);
    }

    LimitEstimate of(TeamLimits limits) {
      return switch (this) {
        case VELOCITY -> limits.velocity();
        case ACCELERATION -> limits.acceleration();
        case BRAKING -> limits.braking();
      };
    }

    double of(ConfiguredLimits limits) {
      return switch (this) {
        case VELOCITY -> limits.velocity();
        case ACCELERATION -> limits.acceleration();
        case BRAKING -> limits.braking();
      };
    }
  }

  /**
   * Checks that nothing is missing. {@inheritDoc}
   *
   * @throws NullPointerException when the team, the limit or the estimate is null
   */
  public LimitWarning {
    Objects.requireNonNull(team, "team");
    Objects.requireNonNull(limit, "limit");
    Objects.requireNonNull(estimate, "estimate");
  }

  /**
   * How far the robots are off.
   *
   * @return as a part of what is configured (–); positive when they do more
   */
  public double deviation() {
    return estimate.value() / configured - 1;
  }

  /**
   * One sentence for the operator.
   *
   * @return for example {@code braking of yellow is 3.10 ± 0.05 m/s², 22 % less than the configured 4.00 m/s²}
   */
  public String text() {
    String what =
        String.format(
            Locale.ROOT,
            "%s of %s is %s%.2f ± %.2f %s",
            limit.label(),
            team.label(),
            estimate.reached() ? "" : "at least ",
            estimate.value(),
            estimate.standardError(),
            limit.unit());
    if (Double.isNaN(configured)) {
      return what + ", and nothing is configured";
    }
    return String.format(
        Locale.ROOT,
        "%s, %.0f %% %s than the configured %.2f %s",
        what,
        100 * Math.abs(deviation()),
        deviation() > 0 ? "more" : "less",
        configured,
        limit.unit());
  }

  /**
   * What to do about it.
   *
   * @return one sentence for the operator
   */
  public String advice() {
    if (Double.isNaN(configured)) {
      return "Configure the robots' limits, so that they can be compared.";
    }
    return deviation() > 0
        ? String.format(
            Locale.ROOT, "Raise the configured %s, or let the robots keep to it.", limit.label())
        : String.format(
            Locale.ROOT,
            "Lower the configured %s to %.2f %s, or check the robots' wheels and batteries.",
            limit.label(),
            estimate.value(),
            limit.unit());
  }
}
