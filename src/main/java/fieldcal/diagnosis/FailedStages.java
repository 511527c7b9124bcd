package fieldcal.diagnosis;

import fieldcal.diagnosis.model.FittedModel;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/** A stage that fails costs what it would have found, not the diagnosis. Not thread-safe. */
final class FailedStages {
  private final List<String> problems = new ArrayList<>();

  /**
   * Runs a stage.
   *
   * @param what the stage, as a noun
   * @param otherwise the model to go on with when it fails
   * @param stage what it finds
   * @return the model that it found
   */
  FittedModel guarded(String what, FittedModel otherwise, Supplier<FittedModel> stage) {
    try {
      return stage.get();
    } catch (RuntimeException e) {
      problems.add(what + " failed: " + e);
      return otherwise;
    }
  }

  /** What failed, in order. */
  List<String> problems() {
    return List.copyOf(problems);
  }
}
