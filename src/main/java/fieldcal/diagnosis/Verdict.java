package fieldcal.diagnosis;

import java.util.Locale;

/** What a diagnosis comes to. */
public enum Verdict {
  /** No effect pays on kicks that were held out of the fit, and no structure is left in the residuals. */
  MODEL_ADEQUATE,
  /** One or more causes explain what the model gets wrong. */
  EXPLAINED,
  /** Something is wrong that no known effect explains. */
  UNEXPLAINED_STRUCTURE;

  /**
   * The name in files.
   *
   * @return lower case with underscores
   */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }
}
