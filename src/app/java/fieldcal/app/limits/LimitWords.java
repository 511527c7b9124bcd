package fieldcal.app.limits;

import fieldcal.app.wording.Amount;
import fieldcal.movement.Envelope;
import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.RobotDifference;
import fieldcal.movement.TeamLimits;
import java.util.Locale;

/** What one limit for all speeds and directions gets wrong, in words and sizes an operator knows. */
public final class LimitWords {
  /** What the estimate beside fieldcal's own is. */
  public static final String LEAGUES_ESTIMATE =
      "The league's estimate is the 99.5th percentile (velocity), the 75th (acceleration) or the"
          + " 95th (braking) of differences between frames that are five apart; it contains the"
          + " noise of the cameras.";

  private LimitWords() {}

  /**
   * What holds for a team whose limits depend on nothing, as far as its manoeuvres show it.
   *
   * @param limits of the team
   * @return for example {@code no difference between the speeds that were driven, nor between the directions that were measured (2 of 36)}
   */
  public static String oneLimit(TeamLimits limits) {
    int measured = limits.envelopes().stream().mapToInt(e -> e.points().size()).max().orElse(0);
    if (measured == Envelope.DIRECTIONS) {
      return "one limit holds for all speeds and directions";
    }
    String speeds = "no difference between the speeds that were driven";
    return measured < 2
        ? speeds + "; too few manoeuvres to compare directions"
        : String.format(
            Locale.ROOT,
            "%s, nor between the directions that were measured (%d of %d)",
            speeds,
            measured,
            Envelope.DIRECTIONS);
  }

  /**
   * How a limit depends on the direction.
   *
   * @param envelope with at least one known direction
   * @return for example {@code acceleration by direction: strongest 3.51 ± 0.04 m/s² at 0°, weakest 1.52 ± 0.02 m/s² at 90° (0° is the front, 90° the left); known in 31 of 36 directions}
   * @throws java.util.NoSuchElementException when no direction is known
   */
  public static String sentence(Envelope envelope) {
    Envelope.Point most = envelope.strongest().orElseThrow();
    Envelope.Point least = envelope.weakest().orElseThrow();
    return String.format(
        Locale.ROOT,
        "%s by direction: %s (0° is the front, 90° the left); known in %d of %d directions",
        envelope.seenIn(),
        envelope.points().size() == 1
            ? words(most)
            : "strongest " + words(most) + ", weakest " + words(least),
        envelope.points().size(),
        Envelope.DIRECTIONS);
  }

  private static String words(Envelope.Point point) {
    return String.format(
        Locale.ROOT,
        "%.2f ± %.2f m/s² at %s°",
        point.value(),
        point.standardError(),
        Amount.decimals(Math.toDegrees(point.angle()), 0));
  }

  /**
   * How a robot differs from its team mates.
   *
   * @param different of a team
   * @return for example {@code robot 3 is weaker: acceleration 2.25 ± 0.02 m/s², 75 % of its team mates' 3.00 m/s² (51 manoeuvres)}
   */
  public static String sentence(RobotDifference different) {
    return String.format(
        Locale.ROOT,
        "robot %d is %s: %s %.2f ± %.2f m/s², %.0f %% of its team mates' %.2f m/s² (%d manoeuvres)",
        different.robot(),
        different.ratio() < 1 ? "weaker" : "stronger",
        different.quantity(),
        different.value(),
        different.standardError(),
        100 * different.ratio(),
        different.ofOthers(),
        different.manoeuvres());
  }

  /**
   * What a team's robots do otherwise, and how much that is.
   *
   * @param limits of the team
   * @param deviation one of its deviations
   * @return for example {@code accelerates less the faster it drives: 3.93 m/s² from standstill, 2.04 m/s² at 3.00 m/s}
   */
  public static String sentence(TeamLimits limits, LimitDeviation deviation) {
    boolean braking = deviation.seenIn().equals("braking");
    LimitEstimate limit = braking ? limits.braking() : limits.acceleration();
    String what = deviation.effect().sentence();
    if (braking) {
      what = what.replaceFirst("^accelerates", "brakes");
    }
    double left = limit.value() * (1 - deviation.coefficient());
    double fastest = limits.velocity().value();
    if (!limit.known() || !Double.isFinite(left)) {
      return what;
    }
    return switch (deviation.effect()) {
      case DIRECTIONAL ->
          String.format(
              Locale.ROOT, "%s: %.2f m/s² along it, %.2f m/s² sideways", what, limit.value(), left);
      case TORQUE_LIMITED ->
          Double.isFinite(fastest)
              ? String.format(
                  Locale.ROOT,
                  "%s: %.2f m/s² from standstill, %.2f m/s² at %.2f m/s",
                  what,
                  limit.value(),
                  left,
                  fastest)
              : what;
    };
  }
}
