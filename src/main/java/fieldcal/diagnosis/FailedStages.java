package fieldcal.diagnosis;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/** Runs the stages. If one fails, the diagnosis goes on without what it would have found. Not thread-safe. */
final class FailedStages {
  private final List<String> problems = new ArrayList<>();

  /**
   * Runs a stage.
   *
   * @param what the stage, as a noun
   * @param otherwise what it returns when the stage fails
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
