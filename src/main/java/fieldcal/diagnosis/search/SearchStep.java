package fieldcal.diagnosis.search;

import java.util.Locale;

/**
 * One thing a search tried.
 *
 * @param what effects, as text
 * @param action what was done with them
 * @param expected gain of chi-square by the score test, kicks that the model does not explain weighing less
 * @param gained what the joint refit gained
 */
public record SearchStep(String what, Action action, double expected, double gained) {

  /** What became of it. */
  public enum Action {
    /** Came into the model. */
    ADDED,
    /** Was tried and gained less than its penalty. */
    REJECTED,
    /** Was in the model and is not needed any more. */
    REMOVED,
    /** Stands in the place of another that explained less. */
    SWAPPED,
    /** Its place was made better. */
    MOVED
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT, "%s %s: expected %.1f, gained %.1f", action, what, expected, gained);
  }
}
