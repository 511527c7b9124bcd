package fieldcal.diagnosis;

import java.util.function.Consumer;

/** Says what the simple model gets wrong. Immutable and thread-safe. */
public final class Diagnoser {

  /** A diagnoser. */
  public Diagnoser() {}

  /**
   * Diagnoses.
   *
   * @param problem kicks and cameras
   * @param progress told in words what is being done, from the calling thread
   * @return the diagnosis
   * @throws IllegalArgumentException when there is no fitted kick
   */
  public Diagnosis diagnose(DiagnosisProblem problem, Consumer<String> progress) {
    if (problem.fits().isEmpty()) {
      throw new IllegalArgumentException("a diagnosis needs at least one fitted kick");
    }
    throw new UnsupportedOperationException("to be written");
  }
}
