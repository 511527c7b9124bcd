package fieldcal.diagnosis;

import java.util.List;

/**
 * What is left when all named causes are in the model.
 *
 * @param significant whether more is left than noise makes
 * @param systematicMm size of the systematic part, root mean square per axis, mm
 * @param deviation the systematic part in standard deviations of what noise alone gives
 * @param dependsOn the variables that the residuals depend on, strongest first; empty when nothing significant is left
 */
public record Unexplained(
    boolean significant, double systematicMm, double deviation, List<StructureVariable> dependsOn) {

  /** Copies the list. {@inheritDoc} */
  public Unexplained {
    dependsOn = List.copyOf(dependsOn);
  }
}
