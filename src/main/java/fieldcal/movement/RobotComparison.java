package fieldcal.movement;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Compares the limits of a team's robots with each other. Each robot's limit is the mode of its own manoeuvres, corrected for how the team's limit depends on speed and direction. A robot differs when its limit clearly differs from the median of the others, and when many of its manoeuvres reach this limit. A robot that is merely never in a hurry, such as a keeper, stays below the others, but its manoeuvres do not cluster anywhere.
 */
final class RobotComparison {
  /** Least number of a robot's manoeuvres at its limit … */
  private static final double FEWEST = 15;

  /** … and least part of all its manoeuvres; robots of simulated matches that stay below their limit have up to 0.2 at any one value. */
  private static final double SHARE = 0.3;

  /** Largest part of its manoeuvres that may lie clearly above its limit. */
  private static final double ABOVE = 0.05;

  /** A manoeuvre is clearly above when it exceeds the limit by this part and by {@link #SURE} of its standard errors. */
  private static final double MARGIN = 0.06;

  private static final double SURE = 3;

  /** Limits that differ by less are usual among robots of a team. */
  private static final double SMALLEST = 0.07;

  /** Standard errors by which a significant difference exceeds zero. */
  private static final double SIGNIFICANT = 5;

  /** Least number of other robots that a robot is compared with. */
  private static final int OTHERS = 2;

  private RobotComparison() {}

  /** Where a robot's manoeuvres pile up. */
  private record Own(double value, double error, double mass) {}

  static List<RobotDifference> of(
      ManoeuvreTables tables, AccelerationLimit limit, String quantity) {
    Map<Integer, Own> known = new TreeMap<>();
    tables.robots().forEach((robot, table) -> put(known, robot, own(table, limit)));
    List<RobotDifference> different = new ArrayList<>();
    for (Map.Entry<Integer, Own> entry : known.entrySet()) {
      Own own = entry.getValue();
      double[] others =
          known.entrySet().stream()
              .filter(e -> !e.getKey().equals(entry.getKey()))
              .mapToDouble(e -> e.getValue().value())
              .sorted()
              .toArray();
      if (others.length < OTHERS) {
        continue;
      }
      int n = others.length;
      double median = (others[(n - 1) / 2] + others[n / 2]) / 2;
      double difference = Math.abs(own.value() - median);
      if (difference > SMALLEST * median && difference > SIGNIFICANT * own.error()) {
        different.add(
            new RobotDifference(
                entry.getKey(),
                quantity,
                own.value(),
                own.error(),
                median,
                Math.round(own.mass())));
      }
    }
    return different;
  }

  private static void put(Map<Integer, Own> known, int robot, Own own) {
    if (own != null) {
      known.put(robot, own);
    }
  }

  private static Own own(ManoeuvreTable table, AccelerationLimit limit) {
    if (table.samples() < FEWEST) {
      return null;
    }
    ManoeuvreTable.Columns raw = table.columns();
    ManoeuvreTable.Columns data = raw.without(limit.reduction(raw));
    SaturationFit.Uniform uniform = SaturationFit.uniform(data);
    if (uniform == null) {
      return null;
    }
    SaturationFit.Mode mode = uniform.highest();
    if (mode.mass() < FEWEST || mode.share() < SHARE) {
      return null;
    }
    double value = mode.beta()[0];
    double above = 0;
    double total = 0;
    for (int i = 0; i < data.count().length; i++) {
      double a = data.acceleration()[i];
      total += data.count()[i];
      above += a - SURE * data.error()[i] > (1 + MARGIN) * value ? data.count()[i] : 0;
    }
    double error = Math.hypot(mode.errors()[0], AccelerationLimit.SYSTEMATIC * value);
    return above <= ABOVE * total ? new Own(value, error, mode.mass()) : null;
  }
}
