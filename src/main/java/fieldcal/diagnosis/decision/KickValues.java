package fieldcal.diagnosis.decision;

import fieldcal.diagnosis.model.Component;
import fieldcal.diagnosis.model.EffectKick;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.model.Weighing;
import fieldcal.fit.joint.ScoreSystem;
import fieldcal.kick.KickKind;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.apache.commons.math3.stat.StatUtils;

/**
 * A value that differs from kick to kick, together with what is recorded of each kick. Immutable.
 *
 * @param mean mean of all kicks, to which values are shrunk
 * @param kicks in the order of time
 */
record KickValues(double mean, List<Kick> kicks) {
  /** A kick whose detections determine less than this share of its value is left out: its value is only what the other kicks lead one to expect. */
  private static final double LEAST_RELIABILITY = 0.1;

  /**
   * One kick.
   *
   * @param index of the kick in the model
   * @param value value of the magnitude, estimated with the scatter of all kicks as the prior
   * @param reliability share of the value's variance over the kicks that its detections determine, 0 to 1; by the rest the value is shrunk to the mean
   * @param kind flat or chip
   * @param time of the session, s
   * @param speed at the kick, m/s
   * @param heading direction of the kick, rad
   * @param x place of the kick, m
   * @param y place of the kick, m
   */
  record Kick(
      int index,
      double value,
      double reliability,
      KickKind kind,
      double time,
      double speed,
      double heading,
      double x,
      double y) {}

  KickValues {
    kicks =
        kicks.stream()
            .filter(k -> k.reliability >= LEAST_RELIABILITY)
            .sorted(Comparator.comparingDouble(Kick::time))
            .toList();
  }

  /** The values of a component that has one for each kick. */
  static KickValues of(FittedModel model, int component) {
    Component c = model.model().components().get(component);
    int random = model.model().random().indexOf(c);
    int mean = model.model().freeIndex(model.model().offset(component));
    double scatter = model.scatter(component);
    // The kick's own value is eliminated: a kick determines the mean with a precision of
    // 1/(scatter² + error²).
    ScoreSystem equations = model.solution().scores(List.of(), Weighing.ALIKE.of(model));
    List<Kick> all = new ArrayList<>();
    for (int k = 0; k < model.kickCount(); k++) {
      EffectKick kick = model.kick(k);
      double[] own = model.solution().own(k);
      double reliability = scatter * scatter * equations.curvature(k, mean, mean);
      all.add(
          new Kick(
              k,
              own[kick.record().timeIndex() + 1 + random],
              Math.min(1, reliability),
              kick.record().kind(),
              kick.sessionTime(own),
              Math.hypot(own[2], own[3]),
              Math.atan2(own[3], own[2]),
              own[0],
              own[1]));
    }
    return new KickValues(model.solution().values()[model.model().offset(component)], all);
  }

  /** The same of one kind of kick. */
  KickValues of(KickKind kind) {
    return new KickValues(mean, kicks.stream().filter(k -> k.kind == kind).toList());
  }

  /** The same without the kicks whose values are farthest from the median: what only these show is something that happened to them. */
  KickValues withoutFarthest(int few) {
    double middle = StatUtils.percentile(kicks.stream().mapToDouble(Kick::value).toArray(), 50);
    return new KickValues(
        mean,
        kicks.stream()
            .sorted(Comparator.comparingDouble(k -> Math.abs(k.value - middle)))
            .limit(Math.max(0, kicks.size() - few))
            .toList());
  }

  /** What is left beside something that is known of each kick, whose values are shrunk to their mean as the others are. */
  KickValues beside(ToDoubleFunction<Kick> known) {
    double middle = kicks.stream().mapToDouble(known).average().orElse(0);
    return new KickValues(
        mean - middle,
        kicks.stream()
            .map(
                k -> {
                  double off = k.reliability * (known.applyAsDouble(k) - middle);
                  return new Kick(
                      k.index,
                      k.value - middle - off,
                      k.reliability,
                      k.kind,
                      k.time,
                      k.speed,
                      k.heading,
                      k.x,
                      k.y);
                })
            .toList());
  }

  /** Standard deviation of the values from kick to kick, as their detections give it without what all kicks have in common: a value shrunk to the mean by its reliability r has r times the variance of the scatter. 0 of fewer than two kicks. */
  double scatter() {
    double total = kicks.stream().mapToDouble(Kick::reliability).sum();
    double own = kicks.stream().mapToDouble(Kick::value).sum();
    double prior = kicks.stream().mapToDouble(k -> (1 - k.reliability()) * mean).sum();
    double middle = (own - prior) / total;
    double squares = 0;
    for (Kick k : kicks) {
      double off = k.value() - mean - k.reliability() * (middle - mean);
      squares += off * off / k.reliability();
    }
    return kicks.size() < 2 ? 0 : Math.sqrt(squares / (kicks.size() - 1));
  }
}
