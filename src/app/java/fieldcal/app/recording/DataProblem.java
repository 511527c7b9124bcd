package fieldcal.app.recording;

import java.util.Objects;

/**
 * Something that was wrong with the data, in one line for the operator.
 *
 * @param where file, with the offset where there is one
 * @param what in words
 * @param count how often
 * @param advice what it means or what to do; may be empty
 */
public record DataProblem(String where, String what, long count, String advice) {

  /** Checks that the texts are there. {@inheritDoc} */
  public DataProblem {
    Objects.requireNonNull(where, "where");
    Objects.requireNonNull(what, "what");
    Objects.requireNonNull(advice, "advice");
  }

  @Override
  public String toString() {
    return where
        + ": "
        + what
        + (count > 1 ? " (" + count + " times)" : "")
        + (advice.isEmpty() ? "" : "; " + advice);
  }
}
