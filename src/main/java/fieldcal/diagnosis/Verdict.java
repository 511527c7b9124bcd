package fieldcal.diagnosis;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** The verdict of a diagnosis. */
public enum Verdict {
  /** No effect improves the prediction of kicks that were held out of the fit, and the residuals are no more than noise. */
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
