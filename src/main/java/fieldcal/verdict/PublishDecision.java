package fieldcal.verdict;

import java.util.Locale;

/** What to do with a calibrated model, from the least to the most serious. */
public enum PublishDecision {
  /** The model is well determined and explains the kicks. */
  PUBLISH,
  /** The kicks do not determine every parameter well enough. */
  RECORD_MORE,
  /** Something speaks against the model; a person, or a diagnosis, has to find out what. */
  CHECK_FIRST,
  /** These numbers predict worse than those in use. */
  DO_NOT_PUBLISH;

  /**
   * The name in files.
   *
   * @return lower case with underscores
   */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * The more serious of two decisions.
   *
   * @param other to compare with
   * @return this one or the other
   */
  public PublishDecision or(PublishDecision other) {
    return compareTo(other) >= 0 ? this : other;
  }
}
