package fieldcal.diagnosis;

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
   * @param otherwise what to go on with when it fails
   * @param stage what it finds
   * @param <T> a model, or what was decided about one
   * @return what it found
   */
  <T> T guarded(String what, T otherwise, Supplier<T> stage) {
    try {
      return stage.get();
    } catch (RuntimeException e) {
      problems.add(what + " failed: " + e);
      return otherwise;
    }
  }

  /** Something that was not done. */
  void add(String problem) {
    problems.add(problem);
  }

  /** What failed, in order. */
  List<String> problems() {
    return List.copyOf(problems);
  }
}
