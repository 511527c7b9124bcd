package fieldcal.diagnosis;

import fieldcal.diagnosis.ModelChoice.Weighed;
import fieldcal.diagnosis.model.FittedModel;
import fieldcal.diagnosis.validation.HoldOut;

/**
 * What was decided for some kicks. Immutable.
 *
 * @param screened these kicks and what may explain them
 * @param base the simple model that it is compared with
 * @param heldBase how the simple model does on held-out kicks
 * @param best the model that was chosen
 */
record Decided(DiagnosisCase screened, FittedModel base, HoldOut heldBase, Weighed best) {

  /** Whether the simple model is the best that was found. */
  boolean isNothing() {
    return model().model().components().isEmpty();
  }

  /** The model that was chosen. */
  FittedModel model() {
    return best.model();
  }

  /** The same, compared with the simple model of another decision. */
  Decided beside(Decided other) {
    return new Decided(screened, other.base, other.heldBase, best);
  }
}
