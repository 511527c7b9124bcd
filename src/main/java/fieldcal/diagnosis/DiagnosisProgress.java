package fieldcal.diagnosis;

import fieldcal.diagnosis.model.FittedModel;
import java.util.Locale;
import java.util.function.Consumer;

/**
 * Reports in words what a diagnosis is doing and how far it has come: the stage, the part of it, how many models were fitted, and how much the best of them leaves
 * unexplained. Thread-safe.
 */
final class DiagnosisProgress {
  private final Consumer<String> told;
  private String stage = "";
  private String part = "";
  private int models;
  private double least = Double.POSITIVE_INFINITY;

  /**
   * @param told the words, after each fit
   */
  DiagnosisProgress(Consumer<String> told) {
    this.told = told;
  }

  /** A stage begins. */
  synchronized void stage(String what) {
    stage = what;
    part("");
  }

  /** A part of the stage begins; empty when it has none. */
  synchronized void part(String what) {
    part = what;
    told.accept(what.isEmpty() ? stage : stage + ", " + what);
  }

  /** A model was fitted. */
  synchronized void fitted(FittedModel model) {
    models++;
    double left = 0;
    for (int k = 0; k < model.kickCount(); k++) {
      double times = model.kick(k).record().timesNoise();
      left += model.solution().chiSquare(k) * times * times;
    }
    least = Math.min(least, Math.sqrt(left / model.solution().rows()));
    told.accept(
        String.format(
            Locale.ROOT,
            "%s%s: %d %s tried so far, the residual of the best is %.1f times the noise",
            stage,
            part.isEmpty() ? "" : ", " + part,
            models,
            models == 1 ? "model" : "models",
            least));
  }
}
