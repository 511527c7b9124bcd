package fieldcal.diagnosis;

import fieldcal.effect.ExtendedModel;
import java.util.List;
import java.util.Objects;

/**
 * The answer to a {@link DiagnosisProblem}.
 *
 * @param verdict what it comes to
 * @param base the simple model under the published geometry
 * @param extended the model with all causes; the same as {@code base} when there are none
 * @param causes in the order in which they explain most
 * @param candidates all that were tried, best first
 * @param unexplained what remains
 * @param structureBefore how the residuals of the simple model depend on each variable
 * @param structureAfter the same for the extended model
 * @param kicks every kick in order of time
 * @param simpleModel the jointly fitted simple model, without effects
 * @param model the extended model, as a team's AI uses it
 * @param seed of the choice of held-out kicks and of the bootstrap
 */
public record Diagnosis(
    Verdict verdict,
    Quality base,
    Quality extended,
    List<Cause> causes,
    List<Candidate> candidates,
    Unexplained unexplained,
    List<StructureProfile> structureBefore,
    List<StructureProfile> structureAfter,
    List<KickResiduals> kicks,
    ExtendedModel simpleModel,
    ExtendedModel model,
    long seed) {

  /** Copies the lists. {@inheritDoc} */
  public Diagnosis {
    Objects.requireNonNull(verdict, "verdict");
    causes = List.copyOf(causes);
    candidates = List.copyOf(candidates);
    structureBefore = List.copyOf(structureBefore);
    structureAfter = List.copyOf(structureAfter);
    kicks = List.copyOf(kicks);
  }
}
