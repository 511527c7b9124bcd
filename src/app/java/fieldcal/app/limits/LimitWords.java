package fieldcal.app.limits;

import fieldcal.movement.LimitDeviation;
import fieldcal.movement.LimitEstimate;
import fieldcal.movement.TeamLimits;
import java.util.Locale;

/** What one limit for all speeds and directions gets wrong, in words and sizes an operator knows. */
public final class LimitWords {
  private LimitWords() {}

  /**
   * What a team's robots do otherwise, and how much that is.
   *
   * @param limits of the team
   * @param deviation one of its deviations
   * @return for example {@code accelerates less the faster it drives: 3.93 m/s² from standstill, 2.04 at 3.00 m/s}
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
              Locale.ROOT, "%s: %.2f m/s² along it, %.2f sideways", what, limit.value(), left);
      case TORQUE_LIMITED ->
          Double.isFinite(fastest)
              ? String.format(
                  Locale.ROOT,
                  "%s: %.2f m/s² from standstill, %.2f at %.2f m/s",
                  what,
                  limit.value(),
                  left,
                  fastest)
              : what;
    };
  }
}
