package fieldcal.diagnosis;

import fieldcal.diagnosis.search.SearchStep;
import fieldcal.effect.ExtendedModel;
import java.util.List;
import java.util.Map;
import java.util.Objects;

/**
 * The answer to a {@link DiagnosisProblem}.
 *
 * @param verdict whether the model is right, and whether causes were found
 * @param base the simple model under the published geometry
 * @param extended the model with all causes; the same as {@code base} when there are none
 * @param causes by how much they explain, most first
 * @param learned what helps without a name: learned terms, what differs from kick to kick by chance, unproven effects, and laws that replace a law of the simple model without explaining most
 * @param candidates what each effect that acts everywhere would gain alone, best first
 * @param unexplained what remains
 * @param structureBefore how the residuals of the simple model depend on each variable
 * @param structureAfter the same for the extended model
 * @param kicks every kick that the models were fitted to, in order of time; kicks that were left out are missing
 * @param simpleModel the jointly fitted simple model, without effects
 * @param model the extended model, as a team's AI uses it
 * @param trace the steps of the searches, in order
 * @param problems stages that failed or were left out; empty when all went through
 * @param ballErrors standard errors of the ball's parameters in the extended model, by the parameter's name, in its unit; parameters that no kick shows are missing; empty when the equations are singular
 * @param seed of the choice of held-out kicks and of the bootstrap
 */
public record Diagnosis(
    Verdict verdict,
    Quality base,
    Quality extended,
    List<Cause> causes,
    List<LearnedFinding> learned,
    List<Candidate> candidates,
    Unexplained unexplained,
    List<StructureProfile> structureBefore,
    List<StructureProfile> structureAfter,
    List<KickResiduals> kicks,
    ExtendedModel simpleModel,
    ExtendedModel model,
    List<SearchStep> trace,
    List<String> problems,
    Map<String, Double> ballErrors,
    long seed) {

  /** Copies the lists. {@inheritDoc} */
  public Diagnosis {
    Objects.requireNonNull(verdict, "verdict");
    causes = List.copyOf(causes);
    learned = List.copyOf(learned);
    trace = List.copyOf(trace);
    problems = List.copyOf(problems);
    candidates = List.copyOf(candidates);
    structureBefore = List.copyOf(structureBefore);
    structureAfter = List.copyOf(structureAfter);
    kicks = List.copyOf(kicks);
    ballErrors = Map.copyOf(ballErrors);
  }
}
