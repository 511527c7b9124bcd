package fieldcal.calibration;

import fieldcal.fit.KickFit;
import fieldcal.kick.Kick;
import fieldcal.kick.Observations;

/**
 * One kick whose detections are corrected for effects: correct, fit again, correct, until the detections no longer move. Where an effect makes the path depend on the unknowns in another way than in the simple model (a ball with backspin slides longer), full steps oscillate or diverge; so the length of each step follows from what the last two achieved (Aitken's relaxation, B. M. Irons and
 * R. C. Tuck, Int. J. Numer. Meth. Engng. 1, 1969). Not thread-safe.
 */
final class CorrectedKick {
  private static final int MAX_STEPS = 40;
  private static final double SHORTEST_STEP = 0.05;
  private static final double LONGEST_STEP = 2;

  private final Kick original;
  private final EffectCorrection correction;
  private Kick kick;
  private boolean begun;

  CorrectedKick(Kick original, EffectCorrection correction) {
    this.original = original;
    this.correction = correction;
    kick = original;
  }

  /** The kick as corrected so far. */
  Kick kick() {
    return kick;
  }

  /**
   * Corrects until the detections no longer move.
   *
   * @param fitted fit of {@link #kick}
   * @param again fits a changed kick, from where the last fit of it ended
   * @param rest the detections have settled when a step is shorter than this, m
   * @return how far the detections were from their place before, root mean square, m; 0 when there is no fit
   */
  double correct(KickFit fitted, FitAgain again, double rest) {
    if (fitted.failure().isPresent()) {
      return 0;
    }
    KickFit fit = fitted;
    double before = Double.NaN;
    if (!begun) {
      begun = true;
      Kick first = correction.first(original, fit);
      before = norm(difference(first, kick));
      kick = first;
      fit = again.fit(kick, fit);
    }
    double[] last = null;
    double step = 1;
    for (int i = 0; i < MAX_STEPS && fit.failure().isEmpty(); i++) {
      double[] wanted = difference(correction.of(original, fit), kick);
      double distance = norm(wanted);
      before = Double.isNaN(before) ? distance : before;
      if (distance < rest) {
        break;
      }
      step = last == null ? 1 : relaxed(step, last, wanted);
      last = wanted;
      kick = moved(step, wanted);
      fit = again.fit(kick, fit);
    }
    return before;
  }

  /** Fits a kick from where another fit of it ended. */
  interface FitAgain {
    KickFit fit(Kick kick, KickFit from);
  }

  private static double relaxed(double step, double[] last, double[] wanted) {
    double along = 0;
    double squared = 0;
    for (int i = 0; i < wanted.length; i++) {
      double change = wanted[i] - last[i];
      along -= last[i] * change;
      squared += change * change;
    }
    return squared > 0
        ? Math.min(LONGEST_STEP, Math.max(SHORTEST_STEP, step * along / squared))
        : 1;
  }

  private Kick moved(double step, double[] wanted) {
    Observations now = kick.observations();
    Observations.Builder moved = new Observations.Builder();
    for (int i = 0; i < now.size(); i++) {
      double x = now.x(i) + step * wanted[2 * i];
      double y = now.y(i) + step * wanted[2 * i + 1];
      moved.add(now.time(i), now.camera(i), x, y, now.pixelX(i), now.pixelY(i));
    }
    return original.withObservations(moved.build());
  }

  private static double[] difference(Kick to, Kick from) {
    Observations a = to.observations();
    Observations b = from.observations();
    double[] d = new double[2 * a.size()];
    for (int i = 0; i < a.size(); i++) {
      d[2 * i] = a.x(i) - b.x(i);
      d[2 * i + 1] = a.y(i) - b.y(i);
    }
    return d;
  }

  /** Root mean square of the shifts. */
  private static double norm(double[] d) {
    double sum = 0;
    for (double v : d) {
      sum += v * v;
    }
    return d.length == 0 ? 0 : Math.sqrt(2 * sum / d.length);
  }
}
