package fieldcal.app.export;

import fieldcal.app.export.ExportModel.RobotLimits;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** What one number per limit leaves out of how robots move, and what that costs in the first second of a drive. */
final class RobotCost {
  private static final double SECOND = 1;

  /** s; the distance changes by less than 0.1 mm with a shorter one. */
  private static final double STEP = 1e-4;

  private RobotCost() {}

  static List<String> sentences(RobotLimits limits) {
    List<String> sentences = new ArrayList<>();
    Double velocity = limits.values().get("velocity_max");
    Double acceleration = limits.values().get("acceleration_max");
    for (String name : limits.unreached()) {
      sentences.add(
          "The "
              + limits.team()
              + " robots were never seen at their "
              + name.replace("_max", "")
              + " limit: the value is the highest that was seen.");
    }
    if (velocity == null || acceleration == null) {
      return sentences;
    }
    double full = distance(acceleration, velocity, 0, 1);
    Double torque = limits.effects().get("torque_limited");
    if (torque != null) {
      double real = distance(acceleration, velocity, torque, 1);
      sentences.add(cost(limits, "torque_limited", torque, "straight ahead", full - real));
    }
    Double directional = limits.effects().get("directional");
    if (directional != null) {
      double real = distance(acceleration, velocity, 0, 1 - directional);
      sentences.add(cost(limits, "directional", directional, "sideways", full - real));
    }
    return sentences;
  }

  private static String cost(
      RobotLimits limits, String effect, double coefficient, String where, double metres) {
    return String.format(
        Locale.ROOT,
        "Not carried: %s (coefficient %.2f) of %s. With the exported limits, a robot that"
            + " sets off %s comes %.0f mm too far in 1 s.",
        effect,
        coefficient,
        limits.team(),
        where,
        1000 * metres);
  }

  /** How far a robot comes in the first second from standing, its acceleration falling linearly with its speed, m. */
  private static double distance(
      double acceleration, double velocity, double torque, double share) {
    double v = 0;
    double way = 0;
    for (double t = 0; t < SECOND; t += STEP) {
      double a = share * acceleration * (1 - torque * v / velocity);
      double next = Math.min(velocity, v + Math.max(0, a) * STEP);
      way += (v + next) / 2 * STEP;
      v = next;
    }
    return way;
  }
}
