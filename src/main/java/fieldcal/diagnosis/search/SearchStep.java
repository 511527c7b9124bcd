package fieldcal.diagnosis.search;

import java.util.Locale;

/**
 * One thing a search tried.
 *
 * @param what effects, as text
 * @param action what was done with them
 * @param expected gain by the score test in units of chi-square, where kicks that the model does not explain weigh less; NaN where there was no such test
 * @param gained gain of the joint refit, in the same units; negative where a component was removed
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
    /** Was moved to a better place. */
    MOVED
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT, "%s %s: expected %.1f, gained %.1f", action, what, expected, gained);
  }
}
