package fieldcal.diagnosis;

import fieldcal.effect.MotionEffect;
import fieldcal.effect.ObservedCamera;
import fieldcal.kick.KickKind;
import java.util.List;

/** Neighbours of a shared state, for derivatives. */
final class Perturbation {
  private Perturbation() {}

  /** Fills in the states one step up for each free unknown that is no mean of a random effect; a mean acts through the kicks' own magnitudes only. */
  static void fill(
      Hypothesis hypothesis,
      SharedUnknowns unknowns,
      SharedState centre,
      List<ObservedCamera> observers,
      SharedState[] plus) {
    int k = SharedUnknowns.MODEL;
    boolean[] measures = new boolean[unknowns.size];
    for (Chart chart : hypothesis.fixed()) {
      boolean moves = chart.template() instanceof MotionEffect;
      for (int j = 0; j < chart.size(); j++) {
        measures[k++] = !moves;
      }
    }
    for (int i = 0; i < k; i++) {
      if (unknowns.free[i]) {
        plus[i] = moved(hypothesis, centre, observers, i, unknowns.step[i], measures[i]);
      }
    }
  }

  private static SharedState moved(
      Hypothesis hypothesis,
      SharedState centre,
      List<ObservedCamera> observers,
      int index,
      double by,
      boolean sameMotion) {
    double[] values = centre.values.clone();
    values[index] += by;
    SharedState moved = SharedState.of(hypothesis, values, observers);
    return sameMotion ? moved.withMotionOf(centre) : moved;
  }

  /** Whether kicks of a kind depend on an unknown of the simple model. */
  static boolean concerns(int index, KickKind kind) {
    return switch (index) {
      case SharedUnknowns.ACC_SLIDE, SharedUnknowns.K_SWITCH -> kind == KickKind.FLAT;
      case SharedUnknowns.FIRST_HOP, SharedUnknowns.OTHER_HOPS, SharedUnknowns.DAMPING_Z ->
          kind == KickKind.CHIP;
      default -> true;
    };
  }
}
