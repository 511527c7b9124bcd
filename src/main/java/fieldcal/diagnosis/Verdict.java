package fieldcal.diagnosis;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** What a diagnosis comes to. */
public enum Verdict {
  /** No effect pays on kicks that were held out of the fit, and no structure is left in the residuals. */
  MODEL_ADEQUATE,
  /** Named causes explain what the model gets wrong; nothing significant is left. */
  EXPLAINED,
  /** Named causes or learned terms improve the prediction of held-out kicks, and something is left, or what helps has no name. */
  PARTLY_EXPLAINED,
  /** Something is wrong, and neither named causes nor learned terms improve the prediction of held-out kicks. */
  UNEXPLAINED_STRUCTURE;

  /**
   * The name in files.
   *
   * @return lower case with underscores
   */
  public String id() {
    return name().toLowerCase(Locale.ROOT);
  }

  /**
   * From the name in files.
   *
   * @param id lower case with underscores
   * @return empty for a name that a later version wrote
   */
  public static Optional<Verdict> ofId(String id) {
    return Arrays.stream(values()).filter(v -> v.id().equals(id)).findFirst();
  }
}
