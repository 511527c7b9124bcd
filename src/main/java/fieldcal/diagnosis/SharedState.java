package fieldcal.diagnosis;

import fieldcal.ball.ChipModel;
import fieldcal.ball.FlatModel;
import fieldcal.effect.Effect;
import fieldcal.effect.MeasurementEffect;
import fieldcal.effect.MeasurementEffects;
import fieldcal.effect.MotionEffect;
import fieldcal.effect.MotionEffects;
import fieldcal.effect.ObservedCamera;
import java.util.ArrayList;
import java.util.List;

/** What all kicks share at one setting of the shared unknowns: the models and the effects. Immutable. */
final class SharedState {
  final double[] values;
  final FlatModel flat;
  final ChipModel chip;
  final MeasurementEffects measurement;

  /** Effects on the motion that are the same for all kicks. Two states with the same object here give a ball the same path. */
  final MotionEffects motion;

  private final List<Chart> random;

  private SharedState(
      double[] values,
      FlatModel flat,
      ChipModel chip,
      MotionEffects motion,
      MeasurementEffects measurement,
      List<Chart> random) {
    this.values = values;
    this.flat = flat;
    this.chip = chip;
    this.motion = motion;
    this.measurement = measurement;
    this.random = random;
  }

  static SharedState of(Hypothesis hypothesis, double[] values, List<ObservedCamera> observers) {
    List<MotionEffect> motion = new ArrayList<>();
    List<MeasurementEffect> measurement = new ArrayList<>();
    int k = SharedUnknowns.MODEL;
    for (Chart chart : hypothesis.fixed()) {
      sort(chart.effect(values, k), motion, measurement);
      k += chart.size();
    }
    return new SharedState(
        values.clone(),
        SharedUnknowns.flat(values),
        SharedUnknowns.chip(values),
        MotionEffects.of(motion),
        MeasurementEffects.of(observers, measurement),
        hypothesis.random());
  }

  private static void sort(
      Effect effect, List<MotionEffect> motion, List<MeasurementEffect> measurement) {
    if (effect instanceof MotionEffect m) {
      motion.add(m);
    } else if (effect instanceof MeasurementEffect m) {
      measurement.add(m);
    }
  }

  /** The same with one more effect. */
  SharedState plus(Effect effect, List<ObservedCamera> observers) {
    List<MotionEffect> m = new ArrayList<>(motion.effects());
    List<MeasurementEffect> s = new ArrayList<>(measurement.effects());
    sort(effect, m, s);
    boolean moves = effect instanceof MotionEffect;
    return new SharedState(
        values,
        flat,
        chip,
        moves ? MotionEffects.of(m) : motion,
        moves ? measurement : MeasurementEffects.of(observers, s),
        random);
  }

  /** This state's camera effects with another state's motion, which is known to be equal: so that paths need not be made anew. */
  SharedState withMotionOf(SharedState equal) {
    return new SharedState(values, equal.flat, equal.chip, equal.motion, measurement, random);
  }

  /** Effects on the motion of one kick, whose own magnitudes of the random effects begin at {@code from}. */
  MotionEffects motionOf(double[] own, int from) {
    if (random.isEmpty()) {
      return motion;
    }
    List<MotionEffect> all = new ArrayList<>(motion.effects());
    for (int j = 0; j < random.size(); j++) {
      all.add((MotionEffect) random.get(j).effect(own, from + j));
    }
    return MotionEffects.of(all);
  }
}
