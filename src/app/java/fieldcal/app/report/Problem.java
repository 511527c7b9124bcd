package fieldcal.app.report;

import fieldcal.app.recording.DataProblem;
import java.util.Objects;

/**
 * Damage or gaps in the input, of one sort.
 *
 * @param where file, and offset if there is one
 * @param what in words
 * @param count how often
 * @param advice what it means or what to do
 */
public record Problem(String where, String what, long count, String advice) {

  /** Checks that the texts are there. */
  public Problem {
    Objects.requireNonNull(where, "where");
    Objects.requireNonNull(what, "what");
    Objects.requireNonNull(advice, "advice");
  }

  /**
   * A problem that was met while reading.
   *
   * @param problem which one
   * @return the same for a report
   */
  public static Problem of(DataProblem problem) {
    return new Problem(problem.where(), problem.what(), problem.count(), problem.advice());
  }
}
