package fieldcal.diagnosis.hidden;

import fieldcal.diagnosis.hidden.Answer.Named;
import fieldcal.diagnosis.hidden.Judgement.Strength;
import fieldcal.effect.Effect;
import fieldcal.simulation.EffectSetting;
import fieldcal.simulation.physics.Region;
import fieldcal.simulation.truth.KickTruth;
import fieldcal.simulation.truth.KickTruth.Vector3;
import fieldcal.simulation.truth.Truth;

/** Compares a named worn region with the true one along the paths of the balls: elsewhere nobody can know. */
final class RegionOverlap {
  private RegionOverlap() {}

  /**
   * How alike the two are.
   *
   * @return correlation of inside and outside over the paths: 1 = the same, −1 = the other part of the field, 0 = nothing in common or nothing of either on the paths
   */
  static double correlation(EffectSetting hidden, Effect named, Truth truth) {
    Region region = hidden.region();
    double n = 0;
    double a = 0;
    double b = 0;
    double both = 0;
    for (KickTruth kick : truth.commandedKicks()) {
      for (Vector3 p : kick.path()) {
        boolean inTrue =
            p.x() > region.x0()
                && p.x() < region.x1()
                && p.y() > region.y0()
                && p.y() < region.y1();
        boolean inNamed = contains(named, p.x(), p.y());
        n++;
        a += inTrue ? 1 : 0;
        b += inNamed ? 1 : 0;
        both += inTrue && inNamed ? 1 : 0;
      }
    }
    double variance = a * (n - a) * b * (n - b);
    return variance <= 0 ? 0 : (n * both - a * b) / Math.sqrt(variance);
  }

  private static boolean contains(Effect named, double x, double y) {
    return x > named.value("region_x0")
        && x < named.value("region_x1")
        && y > named.value("region_y0")
        && y < named.value("region_y1");
  }

  /** Friction within over friction without, against the true ratio. */
  static Strength strength(EffectSetting hidden, Named cause, Truth truth) {
    boolean other = correlation(hidden, cause.effect(), truth) < 0;
    double change = cause.effect().value("change");
    double ratio = other ? 1 / (1 + change) : 1 + change;
    double error = cause.standardErrors().getOrDefault("change", Double.NaN);
    double ratioError = other ? error / ((1 + change) * (1 + change)) : error;
    double difference = Math.abs(ratio - 1 - hidden.number("change"));
    return Strength.of(
        100 * difference / Math.abs(hidden.number("change")), difference / ratioError);
  }
}
