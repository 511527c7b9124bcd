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
 * @param causes in the order in which they explain most
 * @param learned smooth terms that improve the prediction, and laws that take the place of the simple model's, without being the cause of most
 * @param candidates all that were tried, best first
 * @param unexplained what remains
 * @param structureBefore how the residuals of the simple model depend on each variable
 * @param structureAfter the same for the extended model
 * @param kicks every kick in order of time
 * @param simpleModel the jointly fitted simple model, without effects
 * @param model the extended model, as a team's AI uses it
 * @param trace what was tried, and what became of it
 * @param problems what failed inside; empty when all stages went through
 * @param ballErrors standard errors of the ball's parameters in the extended model, by the parameter's name, in its unit; those that no kick shows are missing
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
